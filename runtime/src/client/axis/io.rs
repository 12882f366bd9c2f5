//! What goes in and out every cycle.

use core::fmt;
use core::time::Duration;

use crate::cia402::{Controlword, Mode, State, Statusword};

/// What came in with one cycle.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Sample {
    /// 6041h.
    pub statusword: Statusword,
    /// 6061h; `None` if it was not read.
    pub mode: Option<Mode>,
    /// 6064h, user units.
    pub position: Option<i32>,
    /// 606Ch, raw counts.
    pub velocity: Option<i32>,
    /// 6077h, raw counts.
    pub torque: Option<i16>,
    /// 603Fh.
    pub error_code: Option<u16>,
}

impl Sample {
    /// A sample of a statusword alone.
    pub const fn new(statusword: Statusword) -> Self {
        Self { statusword, mode: None, position: None, velocity: None, torque: None, error_code: None }
    }
}

/// What goes out with the next cycle.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Outputs {
    /// 6040h.
    pub controlword: Controlword,
    /// 6060h.
    pub mode: Mode,
    /// 607Ah, user units.
    pub position: i32,
    /// 60FFh, raw counts.
    pub velocity: i32,
    /// 6071h, raw counts.
    pub torque: i16,
}

impl Default for Outputs {
    /// Disable voltage, no mode, targets of 0.
    fn default() -> Self {
        Self { controlword: Controlword(0), mode: Mode::NONE, position: 0, velocity: 0, torque: 0 }
    }
}

/// What is known of the state of the drive.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Feedback {
    /// No statusword has come yet.
    Nothing,
    /// The last statusword is too old to be believed.
    Stale(Statusword),
    /// The statusword is that of no state.
    Unknown(Statusword),
    /// The statusword shows this state.
    State(State),
}

impl fmt::Display for Feedback {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Nothing => f.write_str("no statusword yet"),
            Self::Stale(word) => write!(f, "no statusword any more, the last was {word}"),
            Self::Unknown(word) => word.fmt(f),
            Self::State(state) => state.fmt(f),
        }
    }
}

/// The last sample and its age.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub(super) struct View {
    pub(super) sample: Option<Sample>,
    age: Duration,
    stale: bool,
}

impl View {
    /// Takes what a cycle brought. Ages end to be counted where they are too high, so that waiting comes to rest.
    pub(super) fn take(&mut self, elapsed: Duration, sample: Option<Sample>, stale_after: Duration) {
        if sample.is_some() {
            *self = Self { sample, age: Duration::ZERO, stale: false };
        } else if !self.stale {
            self.age = self.age.saturating_add(elapsed);
            self.stale = self.age > stale_after;
        }
    }

    /// The age counts from here on: nobody has asked for a sample in the time before.
    pub(super) fn touch(&mut self) {
        (self.age, self.stale) = (Duration::ZERO, false);
    }

    pub(super) fn age(&self) -> Duration {
        self.age
    }

    pub(super) fn feedback(&self) -> Feedback {
        match self.sample {
            None => Feedback::Nothing,
            Some(sample) if self.stale => Feedback::Stale(sample.statusword),
            Some(sample) => {
                sample.statusword.state().map_or(Feedback::Unknown(sample.statusword), Feedback::State)
            }
        }
    }

    pub(super) fn state(&self) -> Option<State> {
        match self.feedback() {
            Feedback::State(state) => Some(state),
            _ => None,
        }
    }

    pub(super) fn mode(&self) -> Option<Mode> {
        self.sample?.mode
    }

    pub(super) fn position(&self) -> Option<i32> {
        self.sample?.position
    }

    pub(super) fn word(&self) -> Option<Statusword> {
        Some(self.sample?.statusword)
    }
}
