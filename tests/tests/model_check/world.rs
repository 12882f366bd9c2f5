//! Client, drive and line in one cycle.

use drivewright_runtime::client::axis::{Axis, Outputs, Progress, Sample};

use super::drive::{Drive, Event};
use super::goal::{CYCLE, Goal};
use super::promises::{Asked, Broken, done, promises};

/// What becomes of a message.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Message {
    Arrives,
    Lost,
    /// The one before it arrives once more in its place.
    Old,
}

/// What happens in a cycle.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Choice {
    pub(crate) outputs: Message,
    pub(crate) event: Event,
    pub(crate) sample: Message,
    /// The next goal begins, whether the one before has ended or not.
    pub(crate) next: bool,
}

/// A line and a drive that work.
pub(crate) const FAIR: Choice =
    Choice { outputs: Message::Arrives, event: Event::Obeys, sample: Message::Arrives, next: false };

/// A client under search: the real one, or one with a mistake.
pub(crate) type Client = fn(&mut Axis, Option<Sample>) -> Outputs;

/// The real one.
pub(crate) fn real(axis: &mut Axis, sample: Option<Sample>) -> Outputs {
    axis.step(CYCLE, sample)
}

/// All that decides what can happen next.
#[derive(Clone, Hash, Debug)]
pub(crate) struct World {
    pub(crate) axis: Axis,
    pub(crate) drive: Drive,
    last_sample: Sample,
    last_outputs: Outputs,
    /// Goals that were begun.
    pub(crate) begun: usize,
    pub(crate) asked: Asked,
    pub(crate) faults: u8,
    /// No message is ever old: then what is done must have been done.
    pub(crate) strict: bool,
}

impl World {
    pub(crate) fn new(axis: Axis, drive: Drive, faults: u8, strict: bool) -> Self {
        let (last_sample, last_outputs) = (drive.sample(), Outputs::default());
        Self { axis, drive, last_sample, last_outputs, begun: 0, asked: Asked::default(), faults, strict }
    }

    /// Whether nothing is pursued any more and the plan is at its end.
    pub(crate) fn is_over(&self, plan: &[Goal]) -> bool {
        self.begun == plan.len() && self.axis.progress() != Progress::Pending
    }

    /// One cycle.
    pub(crate) fn step(&mut self, plan: &[Goal], choice: Choice, client: Client) -> Result<(), Broken> {
        let begins = choice.next || self.axis.progress() != Progress::Pending;
        if let (Some(goal), true) = (plan.get(self.begun), begins) {
            self.begun += 1;
            self.asked.begin(*goal, &self.drive);
            goal.begin(&mut self.axis);
        }
        let (shown, fresh) = (self.drive, self.drive.sample());
        let sample = match choice.sample {
            Message::Arrives => Some(fresh),
            Message::Lost => None,
            Message::Old => Some(self.last_sample),
        };
        self.last_sample = fresh;
        let outputs = client(&mut self.axis, sample);
        match choice.outputs {
            Message::Arrives => self.drive.received = outputs,
            Message::Lost => {}
            Message::Old => self.drive.received = self.last_outputs,
        }
        self.last_outputs = outputs;
        self.asked.end(&self.axis);
        self.faults -= u8::from(choice.event == Event::Faults);
        let made = self.drive.step(choice.event);
        self.asked.see(&self.drive);
        promises(self, &shown, outputs, made)?;
        done(self, &shown)
    }
}
