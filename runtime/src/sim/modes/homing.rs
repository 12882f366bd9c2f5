//! Homing: runs the program of the method on the axis.

use core::time::Duration;

use crate::cia402::ModeBits;
use crate::cia402::Statusword;
use crate::homing::interpreter::{Command, Crossing, Run};
use crate::homing::{Event, Pace, Side};

use super::super::planner::{Limits, Planner};
use super::super::plant::Plant;
use super::units::Units;

/// How long the torque is at its limit without motion until that is a hard stop.
const STALL: Duration = Duration::from_millis(100);

/// How far homing is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
enum Progress {
    /// Not started, or interrupted.
    #[default]
    Idle,
    Runs,
    Attained,
    Failed,
}

/// Homing.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Homing<'m> {
    run: Option<Run<'m>>,
    progress: Progress,
    /// Bit 4 of the last cycle.
    bit: bool,
    time: Duration,
    /// The stall of this move has been told.
    stalled: bool,
}

/// What a cycle of homing gives.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Outcome {
    /// Nothing.
    None,
    /// Home is here, in counts of the axis.
    Home(i64),
}

impl<'m> Homing<'m> {
    /// The mode is entered; bit 4 of `word` is no edge.
    pub(super) fn enter(&mut self, word: u16) {
        *self = Self { bit: word & ModeBits::START_HOMING != 0, ..Self::default() };
    }

    pub(super) const fn runs(&self) -> bool {
        matches!(self.progress, Progress::Runs)
    }

    /// Gives whether bit 4 asks for a start in this cycle. A run ends where it is cleared.
    pub(super) fn look(&mut self, word: u16) -> bool {
        let bit = word & ModeBits::START_HOMING != 0;
        let before = core::mem::replace(&mut self.bit, bit);
        let rises = bit && !before;
        if !bit && self.runs() {
            self.interrupt();
        }
        rises && !self.runs()
    }

    /// Starts; without a run there is an error.
    pub(super) fn start(&mut self, run: Option<Run<'m>>) {
        self.progress = if run.is_some() { Progress::Runs } else { Progress::Failed };
        (self.run, self.time, self.stalled) = (run, Duration::ZERO, false);
    }

    /// Ends without a result.
    pub(super) fn interrupt(&mut self) {
        if self.runs() {
            (self.run, self.progress) = (None, Progress::Idle);
        }
    }

    pub(super) fn fail(&mut self) {
        (self.run, self.progress) = (None, Progress::Failed);
    }

    /// Time that the run has taken.
    pub(super) const fn time(&self) -> Duration {
        self.time
    }

    /// Tells the run what the axis has crossed in the last cycle.
    pub(super) fn watch(&mut self, plant: &Plant) {
        let Some(run) = &mut self.run else { return };
        for crossing in plant.crossings() {
            if run.event(*crossing) {
                self.stalled = false;
            }
        }
        if plant.stalled() >= STALL && !self.stalled {
            self.stalled = true;
            let stall = |event| Crossing { event, position: plant.position(), direction: plant.driven() };
            run.event(stall(Event::Torque(true)));
            run.event(stall(Event::Stall));
        }
    }

    /// What the planner has to do.
    pub(super) fn step(
        &mut self,
        plant: &Plant,
        planner: &mut Planner,
        units: &Units,
        cycle: Duration,
    ) -> Outcome {
        let Some(mut run) = self.run else {
            planner.stop(units.homing_acceleration);
            return Outcome::None;
        };
        self.time = self.time.saturating_add(cycle);
        let still = planner.done() && plant.standstill();
        if still && matches!(run.command(), Command::Brake | Command::Return { .. }) && at_goal(&run, planner)
        {
            run.standstill(plant.position());
        }
        self.run = Some(run);
        self.obey(run.command(), planner, units)
    }

    fn obey(&mut self, command: Command, planner: &mut Planner, units: &Units) -> Outcome {
        let ramp = units.homing_acceleration;
        let limits = |velocity| Limits { velocity, acceleration: ramp, deceleration: ramp };
        match command {
            Command::Move { direction, pace } => {
                let speed = if pace == Pace::Fast { units.homing_fast } else { units.homing_slow };
                let velocity = if direction == Side::Positive { speed } else { speed.saturating_neg() };
                planner.run_at(velocity, limits(speed));
            }
            Command::Brake => planner.stop(ramp),
            Command::Return { to } => planner.move_to(to, limits(units.homing_slow)),
            Command::Finished { home } => {
                (self.run, self.progress) = (None, Progress::Attained);
                return home.map_or(Outcome::None, Outcome::Home);
            }
            Command::Failed(_) => {
                self.fail();
                planner.stop(ramp);
            }
        }
        Outcome::None
    }

    /// Bits 10, 12 and 13.
    pub(super) fn bits(&self, stands: bool) -> u16 {
        let reached = if stands && !self.runs() { Statusword::TARGET_REACHED } else { 0 };
        reached
            | match self.progress {
                Progress::Idle | Progress::Runs => 0,
                Progress::Attained => ModeBits::HOMING_ATTAINED,
                Progress::Failed => ModeBits::HOMING_ERROR,
            }
    }
}

/// Whether the planner has been told to do what the run waits for: not in the cycle in which the command is new.
fn at_goal(run: &Run<'_>, planner: &Planner) -> bool {
    match run.command() {
        Command::Return { to } => planner.target() == Some(to),
        _ => planner.point().velocity == 0,
    }
}
