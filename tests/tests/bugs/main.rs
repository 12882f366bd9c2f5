//! Bugs that recur in CiA 402 libraries, each under its number: `tests/mutants/README.md` lists them, and
//! `cargo xtask test --mutants` puts them back.
//!
//! The client is shown statuswords, cycle by cycle, as a drive would send them.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test")]

mod drives;
mod enabling;
mod faults;
mod homing;
mod moves;
mod stops;

use std::time::Duration;

use drivewright_runtime::cia402::{Mode, Statusword};
use drivewright_runtime::client::axis::{Axis, AxisErrorKind, AxisPolicy, Outputs, Progress, Sample};

const CYCLE: Duration = Duration::from_millis(10);

const NOT_READY: u16 = 0x0200;
const DISABLED: u16 = 0x0240;
const READY: u16 = 0x0221;
const SWITCHED_ON: u16 = 0x0233;
const ENABLED: u16 = 0x0237;
const QUICK_STOP: u16 = 0x0217;
const FAULT: u16 = 0x0208;

/// A client, and what a drive shows beside its statusword.
struct Rig {
    axis: Axis,
    shown: Sample,
}

impl Rig {
    fn new(policy: AxisPolicy) -> Self {
        let shown = Sample { mode: Some(Mode::NONE), position: Some(5_000), ..Sample::default() };
        Self { axis: Axis::new(policy), shown }
    }

    /// One cycle with this statusword.
    fn see(&mut self, word: u16) -> Outputs {
        self.shown.statusword = Statusword(word);
        self.axis.step(CYCLE, Some(self.shown))
    }

    /// Some cycles with this statusword; the outputs of each.
    fn stay(&mut self, word: u16, cycles: usize) -> Vec<Outputs> {
        (0..cycles).map(|_| self.see(word)).collect()
    }

    /// Cycles until the goal has ended, a thousand at most.
    fn until_the_end(&mut self, word: u16) -> Vec<Outputs> {
        let mut all = Vec::new();
        while self.axis.progress() == Progress::Pending && all.len() < 1_000 {
            all.push(self.see(word));
        }
        all
    }

    /// In operation in a mode.
    fn enabled(policy: AxisPolicy, mode: Mode) -> Self {
        let mut rig = Self::new(policy);
        rig.axis.enable(mode);
        rig.shown.mode = Some(mode);
        for word in [DISABLED, READY, SWITCHED_ON, ENABLED] {
            rig.see(word);
        }
        assert_eq!(rig.axis.progress(), Progress::Done);
        rig
    }

    fn failed(&self) -> Option<AxisErrorKind> {
        match self.axis.progress() {
            Progress::Failed(error) => Some(error.kind),
            _ => None,
        }
    }
}

/// The controlwords of some cycles.
fn words(outputs: &[Outputs]) -> Vec<u16> {
    outputs.iter().map(|o| o.controlword.0).collect()
}
