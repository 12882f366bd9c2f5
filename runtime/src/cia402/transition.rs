//! The seventeen transitions.

use core::fmt;

use super::command::{Command, Controlword};
use super::state::State;

/// What makes a drive change its state.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Cause {
    /// Power-on or a reset of the application: transition 0.
    PowerOn,
    /// The drive by itself: start-up is done, a stop has come to standstill, a fault reaction has ended. Transitions 1, 12
    /// and 14.
    Done,
    /// A command of the controlword.
    Command(Command),
    /// A fault: transition 13.
    Fault,
}

/// What decides a transition besides its cause.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Options {
    /// 605Ah keeps the state quick stop active: 5 to 8. Then transition 16 is possible and 12 needs a command.
    pub quick_stop_stays: bool,
    /// The cause of the fault is still there: transition 15 does not happen.
    pub fault_persists: bool,
}

/// A transition of CiA 402, by its number, 0 to 16.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Transition(u8);

impl Transition {
    /// Its number.
    pub const fn number(self) -> u8 {
        self.0
    }

    /// The state that it leads to.
    pub const fn to(self) -> State {
        match self.0 {
            0 => State::NotReadyToSwitchOn,
            2 | 6 | 8 => State::ReadyToSwitchOn,
            3 | 5 => State::SwitchedOn,
            4 | 16 => State::OperationEnabled,
            11 => State::QuickStopActive,
            13 => State::FaultReactionActive,
            14 => State::Fault,
            _ => State::SwitchOnDisabled,
        }
    }

    /// The transition that `cause` makes in `state`; `None` where the state stays as it is.
    ///
    /// ```
    /// use drivewright_runtime::cia402::{Cause, Command, Options, State, Transition};
    ///
    /// let quick_stop = Cause::Command(Command::QuickStop);
    /// let number = |state| Transition::of(state, quick_stop, Options::default()).map(Transition::number);
    /// assert_eq!(number(State::OperationEnabled), Some(11));
    /// assert_eq!(number(State::SwitchedOn), Some(10));
    /// assert_eq!(number(State::Fault), None, "there is nothing to stop");
    /// ```
    pub const fn of(state: State, cause: Cause, options: Options) -> Option<Self> {
        use Command::{DisableVoltage, EnableOperation, FaultReset, QuickStop, Shutdown, SwitchOn};
        use State as S;
        let number = match (state, cause) {
            (_, Cause::PowerOn) => 0,
            (S::FaultReactionActive, Cause::Done) => 14,
            (S::FaultReactionActive | S::Fault, Cause::Fault) => return None,
            (_, Cause::Fault) => 13,
            (S::NotReadyToSwitchOn, Cause::Done) => 1,
            (S::SwitchOnDisabled, Cause::Command(Shutdown)) => 2,
            (S::ReadyToSwitchOn, Cause::Command(SwitchOn)) => 3,
            (S::SwitchedOn, Cause::Command(EnableOperation)) => 4,
            (S::OperationEnabled, Cause::Command(SwitchOn)) => 5,
            (S::SwitchedOn, Cause::Command(Shutdown)) => 6,
            (S::ReadyToSwitchOn, Cause::Command(QuickStop | DisableVoltage)) => 7,
            (S::OperationEnabled, Cause::Command(Shutdown)) => 8,
            (S::OperationEnabled, Cause::Command(DisableVoltage)) => 9,
            (S::SwitchedOn, Cause::Command(QuickStop | DisableVoltage)) => 10,
            (S::OperationEnabled, Cause::Command(QuickStop)) => 11,
            (S::QuickStopActive, Cause::Command(DisableVoltage)) => 12,
            (S::QuickStopActive, Cause::Done) if !options.quick_stop_stays => 12,
            (S::Fault, Cause::Command(FaultReset)) if !options.fault_persists => 15,
            (S::QuickStopActive, Cause::Command(EnableOperation)) if options.quick_stop_stays => 16,
            _ => return None,
        };
        Some(Self(number))
    }

    /// The command that `word` gives a drive in `state`, whose last controlword was `previous`: a rising edge of bit 7
    /// in the state fault is a fault reset, otherwise bits 0 to 3 decide.
    pub const fn command(state: State, word: Controlword, previous: Controlword) -> Option<Command> {
        if matches!(state, State::Fault) {
            return if word.fault_reset() && !previous.fault_reset() {
                Some(Command::FaultReset)
            } else {
                None
            };
        }
        word.level()
    }
}

impl fmt::Display for Transition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "transition {} to {}", self.0, self.to())
    }
}
