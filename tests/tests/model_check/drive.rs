//! A drive that does what it is told, when it likes.

use drivewright_runtime::cia402::{
    Cause, Controlword, HomingState, Mode, ModeBits, Options, State, Statusword, Transition,
};
use drivewright_runtime::client::axis::{Outputs, Sample};

/// Where the axis is before anything moves it: far from 0, which is what a target without a seed would be.
pub(crate) const PLACE: i32 = 1_000_000;

/// What a drive may do besides obeying.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Event {
    /// It obeys.
    Obeys,
    /// What it does takes longer: a stop, a start, a move, homing, a change of mode.
    Waits,
    /// It faults.
    Faults,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(crate) enum Homing {
    /// Not in this power cycle, or given up.
    Not,
    Runs,
    Found,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(crate) struct Drive {
    pub(crate) state: State,
    pub(crate) received: Outputs,
    before: Controlword,
    pub(crate) mode: Mode,
    pub(crate) place: i32,
    /// Bit 12 of profile position mode, and whether the target has been reached.
    acknowledges: bool,
    reached: bool,
    pub(crate) homing: Homing,
    /// 605Ah is 5 to 8.
    stays: bool,
}

impl Drive {
    pub(crate) fn new(state: State, stays: bool, homing: Homing) -> Self {
        Self {
            state,
            received: Outputs::default(),
            before: Controlword(0),
            mode: Mode::NONE,
            place: PLACE,
            acknowledges: false,
            reached: true,
            homing,
            stays,
        }
    }

    /// Whether something goes on that may take longer.
    pub(crate) fn is_busy(&self) -> bool {
        let ends = matches!(self.state, State::NotReadyToSwitchOn | State::FaultReactionActive)
            || self.state == State::QuickStopActive && !self.stays;
        ends || self.mode != self.received.mode || !self.reached || self.homing == Homing::Runs
    }

    /// One cycle; the transition that it made.
    pub(crate) fn step(&mut self, event: Event) -> Option<Transition> {
        let word = self.received.controlword;
        let ends = matches!(
            self.state,
            State::NotReadyToSwitchOn | State::FaultReactionActive | State::QuickStopActive
        );
        let command = Transition::command(self.state, word, self.before).map(Cause::Command);
        let cause = match event {
            Event::Faults => Some(Cause::Fault),
            Event::Obeys if ends && (!self.stays || self.state != State::QuickStopActive) => {
                Some(Cause::Done)
            }
            _ => command,
        };
        let options = Options { quick_stop_stays: self.stays, fault_persists: false };
        let made = cause.and_then(|cause| Transition::of(self.state, cause, options));
        self.state = made.map_or(self.state, Transition::to);
        if event != Event::Waits {
            self.mode = self.received.mode;
        }
        self.work(word, event);
        self.before = word;
        made
    }

    /// What goes on in operation.
    fn work(&mut self, word: Controlword, event: Event) {
        if self.state != State::OperationEnabled {
            (self.acknowledges, self.reached) = (false, true);
            self.homing = if self.homing == Homing::Runs { Homing::Not } else { self.homing };
            return;
        }
        let rises = word.mode_4() && !self.before.mode_4();
        match self.mode {
            Mode::PROFILE_POSITION => {
                self.reached &= !rises || self.acknowledges;
                self.acknowledges = word.mode_4();
                if event == Event::Obeys && !rises && !self.reached {
                    (self.place, self.reached) = (self.received.position, true);
                }
            }
            Mode::HOMING if rises => self.homing = Homing::Runs,
            Mode::HOMING if self.homing == Homing::Runs && !word.mode_4() => self.homing = Homing::Not,
            Mode::HOMING if self.homing == Homing::Runs && event == Event::Obeys => {
                self.homing = Homing::Found;
            }
            Mode::CYCLIC_POSITION => self.place = self.received.position,
            _ => {}
        }
    }

    /// What it sends.
    pub(crate) fn sample(&self) -> Sample {
        let bits = match self.mode {
            Mode::HOMING => match self.homing {
                Homing::Not => Statusword::TARGET_REACHED,
                Homing::Runs => 0,
                Homing::Found => ModeBits::HOMING_ATTAINED | Statusword::TARGET_REACHED,
            },
            Mode::PROFILE_POSITION => {
                let acknowledge = if self.acknowledges { ModeBits::SET_POINT_ACKNOWLEDGE } else { 0 };
                acknowledge | if self.reached { Statusword::TARGET_REACHED } else { 0 }
            }
            _ => Statusword::TARGET_REACHED,
        };
        let word = Statusword(self.state.pattern().1 | Statusword::REMOTE | bits);
        Sample { mode: Some(self.mode), position: Some(self.place), ..Sample::new(word) }
    }
}

#[test]
fn the_drive_homes_when_it_is_told() {
    let mut drive = Drive::new(State::OperationEnabled, false, Homing::Not);
    drive.received.mode = Mode::HOMING;
    let mut cycle = |word, event| {
        drive.received.controlword = Controlword(word);
        drive.step(event);
        HomingState::of(drive.sample().statusword)
    };
    assert_eq!(cycle(0x0F, Event::Obeys), HomingState::NotStarted);
    assert_eq!(cycle(0x1F, Event::Obeys), HomingState::InProgress);
    assert_eq!(cycle(0x1F, Event::Waits), HomingState::InProgress);
    assert_eq!(cycle(0x1F, Event::Obeys), HomingState::Completed);
}
