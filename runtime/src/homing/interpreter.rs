//! Runs a homing program event by event. It knows no time and no speed: whoever moves the axis tells it what is crossed
//! and when the axis stands, and does what it commands. So a proof over all geometries, the virtual drive and a picture
//! read a program in the same way.
//!
//! What the rules of the [language](super) mean here:
//!
//! - **Start.** All cases whose `when` holds are candidates. A case of an axis that stands at home goes before those that
//!   name switches only.
//! - **Candidates** move alike. The first event that one of them waits for rules the others out.
//! - **Own direction.** A crossing that the axis makes in the other direction, on the way to its turning point, ends no
//!   move. One in the direction of the move does, from the first moment on.
//! - **Change, not level.** A move until a switch is off that starts where it is off goes on over the switch.
//! - **Latch** takes the place of the last event that ended a move; after [`Step::Stop`], or where
//!   no event was before it, the place of rest.
//! - **Abort** is a level: it ends the run as soon as all of it is seen, at the start too, unless the event that makes it
//!   true is the one that the program waits for.
//! - **Mask.** A masked signal ends no move and no run.
//! - **End.** The axis brakes after the last step. Home is where it was latched, not where the axis comes to rest.
//!
//! ```
//! use drivewright_runtime::homing::interpreter::{Command, Crossing, Levels, Run};
//! use drivewright_runtime::homing::*;
//!
//! const METHOD_17: HomingDesc<'static> = HomingDesc::new(17).with_cases(&[HomingCase::new(
//!     &[Level::off(Signal::NegativeLimit)],
//!     &[
//!         Step::fast(Side::Negative, Event::on(Signal::NegativeLimit)),
//!         Step::slow(Side::Positive, Event::off(Signal::NegativeLimit)),
//!         Step::Latch,
//!     ],
//! )]);
//!
//! let mut run = Run::start(&METHOD_17, Levels::default()).unwrap();
//! assert_eq!(run.command(), Command::Move { direction: Side::Negative, pace: Pace::Fast });
//! // The limit is at -500: the axis crosses its edge, brakes, turns and crosses it again.
//! run.event(Crossing { event: Event::on(Signal::NegativeLimit), position: -500, direction: Side::Negative });
//! assert_eq!(run.command(), Command::Move { direction: Side::Positive, pace: Pace::Slow });
//! run.event(Crossing { event: Event::off(Signal::NegativeLimit), position: -500, direction: Side::Positive });
//! assert_eq!(run.command(), Command::Brake);
//! run.standstill(-480);
//! assert_eq!(run.command(), Command::Finished { home: Some(-500) });
//! ```

mod outcome;
mod seen;
#[cfg(test)]
mod tests;

pub use outcome::{Command, Failure, StartError};
pub use seen::{Crossing, Levels};

use super::{Event, HomingCase, HomingDesc, HomingStatus, Level, Step};

/// All that a run knows, to compare and to search: two runs of one method in the same state go on alike.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct State {
    command: Command,
    /// A bit for each case that is still possible.
    alive: u32,
    /// The step that all of them are at, from 0.
    step: u16,
    levels: Levels,
    /// What a latch takes.
    place: Option<i64>,
    latched: Option<i64>,
}

/// A homing program that runs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[must_use]
pub struct Run<'m> {
    method: &'m HomingDesc<'m>,
    state: State,
}

impl<'m> Run<'m> {
    /// Starts a method where this is seen.
    pub fn start(method: &'m HomingDesc<'m>, seen: Levels) -> Result<Self, StartError> {
        if method.status() != HomingStatus::Supported {
            return Err(StartError::NotThere(method.status()));
        }
        if let Some(same) = method.same() {
            return Err(StartError::SameAs(same));
        }
        if method.cases().len() > 32 {
            return Err(StartError::TooManyCases);
        }
        let alive = candidates(method, seen);
        if alive == 0 {
            return Err(StartError::NoCase);
        }
        let state =
            State { command: Command::Brake, alive, step: 0, levels: seen, place: None, latched: None };
        let mut run = Self { method, state };
        if !run.aborts() {
            run.go_on();
        }
        Ok(run)
    }

    /// What the axis has to do now.
    pub const fn command(&self) -> Command {
        self.state.command
    }

    /// The method.
    pub const fn method(&self) -> &'m HomingDesc<'m> {
        self.method
    }

    /// All that the run knows.
    pub const fn state(&self) -> State {
        self.state
    }

    /// What was latched so far.
    pub const fn latched(&self) -> Option<i64> {
        self.state.latched
    }

    /// What the switches say, as far as the run was told.
    pub const fn levels(&self) -> Levels {
        self.state.levels
    }

    /// The case that runs, counted from 1; `None` while there are several candidates.
    pub fn case(&self) -> Option<u8> {
        let alone = self.state.alive.is_power_of_two();
        alone.then(|| self.first())
    }

    /// The events that end the present move: one for each candidate.
    pub fn awaits(&self) -> impl Iterator<Item = Event> + 'm {
        let (moving, step) = (matches!(self.state.command, Command::Move { .. }), self.state.step);
        self.cases().filter_map(move |(_, case)| match step_of(case, step) {
            Some(Step::Move { until, .. }) if moving => Some(until),
            _ => None,
        })
    }

    /// Tells what the axis has crossed. Gives whether this changed the command or the step.
    ///
    /// To be called for each crossing, in their order, while the run is neither finished nor failed; after that it has no
    /// effect. For torque and stall the direction is the one in which the axis is driven.
    pub fn event(&mut self, crossing: Crossing) -> bool {
        if self.ended() {
            return false;
        }
        if let Event::Switch(signal, on) = crossing.event {
            self.state.levels = self.state.levels.with(signal, on);
        }
        let takers = self.takers(crossing);
        if takers == 0 {
            return self.aborts();
        }
        self.state.alive = takers;
        self.state.place = Some(crossing.position);
        self.next();
        true
    }

    /// Tells that the axis stands, and where. Without effect unless the command is to brake or to return.
    pub fn standstill(&mut self, position: i64) {
        match self.state.command {
            Command::Brake => {
                self.state.levels.standstill = true;
                self.rested(position);
            }
            Command::Return { .. } => {
                self.state.levels.standstill = true;
                self.next();
            }
            _ => {}
        }
    }

    fn rested(&mut self, position: i64) {
        match self.step() {
            Some(Step::Stop) => {
                self.state.place = Some(position);
                self.next();
            }
            Some(Step::Latch) => {
                self.state.place = Some(position);
                self.go_on();
            }
            _ => self.go_on(),
        }
    }

    fn ended(&self) -> bool {
        matches!(self.state.command, Command::Finished { .. } | Command::Failed(_))
    }

    /// The candidates with their numbers from 0.
    fn cases(&self) -> impl Iterator<Item = (u8, &'m HomingCase<'m>)> + 'm {
        let alive = self.state.alive;
        (0..32_u8).zip(self.method.cases()).filter(move |(n, _)| alive & bit(*n) != 0)
    }

    /// The number of the first candidate, from 1.
    fn first(&self) -> u8 {
        self.cases().next().map_or(0, |(n, _)| n.saturating_add(1))
    }

    /// The step that the candidates are at; `None` at the end.
    fn step(&self) -> Option<Step> {
        self.cases().next().and_then(|(_, case)| step_of(case, self.state.step))
    }

    /// The candidates whose move this crossing ends.
    fn takers(&self, crossing: Crossing) -> u32 {
        let Command::Move { direction, .. } = self.state.command else { return 0 };
        if direction != crossing.direction {
            return 0;
        }
        let takes = |case: &HomingCase<'_>| {
            let awaited = matches!(step_of(case, self.state.step),
                Some(Step::Move { until, .. }) if until == crossing.event);
            awaited && !masks(case, crossing.event)
        };
        self.cases().filter(|(_, case)| takes(case)).fold(0, |set, (n, _)| set | bit(n))
    }

    /// Rules out the candidates that what is seen ends with an error; gives whether that was the last.
    fn aborts(&mut self) -> bool {
        let levels = self.state.levels;
        let left =
            self.cases().filter(|(_, case)| !aborted(case, levels)).fold(0, |set, (n, _)| set | bit(n));
        if left == 0 {
            self.state.command = Command::Failed(Failure::Aborted { case: self.first() });
            return true;
        }
        self.state.alive = left;
        false
    }

    /// Goes to the next step.
    fn next(&mut self) {
        self.state.step = self.state.step.saturating_add(1);
        self.go_on();
    }

    /// Does the step that the candidates are at, and those after it that take no time.
    fn go_on(&mut self) {
        loop {
            if let Some(failure) = self.parted() {
                self.state.command = Command::Failed(failure);
                return;
            }
            match (self.step(), self.state.place) {
                (Some(Step::Latch), Some(place)) => {
                    self.state.latched = Some(place);
                    self.state.step = self.state.step.saturating_add(1);
                }
                (step, _) => {
                    self.command_for(step);
                    return;
                }
            }
        }
    }

    /// What the axis has to do for a step that takes time.
    fn command_for(&mut self, step: Option<Step>) {
        self.state.command = match step {
            Some(Step::Move { direction, pace, .. }) => {
                self.state.levels.standstill = false;
                Command::Move { direction, pace }
            }
            Some(Step::NotStated) => Command::Failed(self.not_stated()),
            Some(Step::Return) => {
                self.state.levels.standstill = false;
                self.state.latched.map_or(Command::Failed(self.not_stated()), |to| Command::Return { to })
            }
            Some(Step::Done) | None if self.state.levels.standstill => {
                Command::Finished { home: self.state.latched }
            }
            // A latch that gets here has no place yet: it takes the place of rest.
            Some(Step::Stop | Step::Latch | Step::Done) | None => Command::Brake,
        };
    }

    fn not_stated(&self) -> Failure {
        Failure::NotStated { case: self.first(), step: self.state.step.saturating_add(1) }
    }

    /// Where two candidates go on in different ways, although no event has told them apart.
    fn parted(&self) -> Option<Failure> {
        let step = self.state.step;
        let own = self.step();
        let (other, _) = self.cases().find(|(_, case)| !alike(own, step_of(case, step)))?;
        let other = other.saturating_add(1);
        Some(Failure::Parted { case: self.first(), other, step: step.saturating_add(1) })
    }
}

/// Whether two steps are one to the axis, which does not know what a move waits for.
fn alike(a: Option<Step>, b: Option<Step>) -> bool {
    match (a, b) {
        (
            Some(Step::Move { direction, pace, .. }),
            Some(Step::Move { direction: other, pace: other_pace, .. }),
        ) => direction == other && pace == other_pace,
        _ => a == b,
    }
}

fn step_of(case: &HomingCase<'_>, step: u16) -> Option<Step> {
    case.moves().0.get(usize::from(step)).copied()
}

const fn bit(case: u8) -> u32 {
    match 1_u32.checked_shl(case as u32) {
        Some(bit) => bit,
        None => 0,
    }
}

fn masks(case: &HomingCase<'_>, event: Event) -> bool {
    matches!(event, Event::Switch(signal, _) if case.mask().contains(&signal))
}

/// Whether a case ends with an error where this is seen.
fn aborted(case: &HomingCase<'_>, seen: Levels) -> bool {
    let masked = |level: &Level| matches!(level, Level::Switch(signal, _) if case.mask().contains(signal));
    case.abort().is_some_and(|abort| {
        !abort.0.is_empty() && abort.0.iter().all(|level| seen.holds(*level) && !masked(level))
    })
}

/// The cases that hold where this is seen. Those that say that the axis is at home are the exception from the others.
fn candidates(method: &HomingDesc<'_>, seen: Levels) -> u32 {
    let holding = |exception: bool| {
        let holds = move |case: &HomingCase<'_>| {
            let when = case.when().0;
            when.iter().all(|level| seen.holds(*level)) && (!exception || when.contains(&Level::AtHome))
        };
        (0..32_u8).zip(method.cases()).filter(|(_, case)| holds(case)).fold(0, |set, (n, _)| set | bit(n))
    };
    match holding(true) {
        0 => holding(false),
        at_home => at_home,
    }
}
