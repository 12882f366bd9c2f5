//! The ways down: to a state without power, by a quick stop, by disabling. And back from a quick stop, on request.

use core::time::Duration;

use super::{Axis, AxisErrorKind, Goal, Verdict};
use crate::cia402::{Command, State};

use super::walk::toward;

impl Axis {
    /// Goes to a state and stays there: switch on disabled, ready to switch on, switched on. Operation is reached in the
    /// mode that is selected, see [`enable`](Self::enable); quick stop active by [`quick_stop`](Self::quick_stop).
    pub fn reach(&mut self, state: State) {
        match state {
            State::OperationEnabled => self.enable(self.out.mode),
            State::QuickStopActive => self.quick_stop(),
            State::NotReadyToSwitchOn | State::FaultReactionActive | State::Fault => {
                self.begin(Goal::Reach(state), Duration::ZERO);
                self.refuse(AxisErrorKind::NotAGoal);
            }
            State::SwitchOnDisabled | State::ReadyToSwitchOn | State::SwitchedOn => {
                let first = toward(State::OperationEnabled, state, None).unwrap_or(Command::DisableVoltage);
                self.leave_operation(first);
                self.begin(Goal::Reach(state), self.policy.state_within);
            }
        }
    }

    /// Takes the torque off the motor, as 605Ch says, and stays switched on. Done in every state without power, in fault
    /// as well.
    pub fn disable(&mut self) {
        self.leave_operation(Command::SwitchOn);
        self.begin(Goal::Disable, self.policy.state_within);
    }

    /// Goes to ready to switch on, as 605Bh says.
    pub fn shutdown(&mut self) {
        self.reach(State::ReadyToSwitchOn);
    }

    /// Stops the axis as 605Ah says. It is a request: where nothing can move there is nothing to stop, and it is done. It
    /// is done as well if the drive has gone on to switch on disabled by itself.
    pub fn quick_stop(&mut self) {
        self.leave_operation(Command::QuickStop);
        self.set_level(Command::QuickStop);
        self.begin(Goal::QuickStop, self.policy.state_within);
    }

    /// Goes from quick stop active back to operation, transition 16. Refused where 605Ah ends a quick stop without power,
    /// and where it is not known to stay: see [`AxisPolicy::quick_stop`](super::AxisPolicy::quick_stop).
    pub fn resume(&mut self) {
        self.drop_commands();
        self.begin(Goal::Resume, self.policy.state_within);
    }

    /// What was commanded in operation ends with it, and the command that holds it at once, heard or not.
    pub(super) fn leave_operation(&mut self, command: Command) {
        self.enabled = false;
        if self.level == Command::EnableOperation {
            self.set_level(command);
        }
        self.drop_commands();
    }

    pub(super) fn advance_reach(&mut self, goal: State) -> Verdict {
        self.not_faulted()?;
        self.walk_to(goal);
        Ok(self.view.state() == Some(goal) && self.level_has_arrived())
    }

    pub(super) fn advance_disable(&mut self) -> bool {
        let Some(state) = self.view.state() else {
            self.set_level(Command::DisableVoltage);
            return false;
        };
        if state.is_powered() && state != State::FaultReactionActive {
            self.walk_to(State::SwitchedOn);
        } else if self.level != Command::SwitchOn {
            // Nothing is switched on by who disables.
            self.set_level(if state == State::ReadyToSwitchOn {
                Command::Shutdown
            } else {
                Command::DisableVoltage
            });
        }
        !state.is_powered() && self.level_has_arrived()
    }

    pub(super) fn quick_stop_is_done(&self) -> bool {
        let Some(state) = self.view.state() else { return false };
        let nothing_moves =
            matches!(state, State::NotReadyToSwitchOn | State::FaultReactionActive | State::Fault);
        let stops = matches!(state, State::QuickStopActive | State::SwitchOnDisabled);
        nothing_moves || stops && self.level_has_arrived()
    }

    pub(super) fn advance_resume(&mut self) -> Verdict {
        self.not_faulted()?;
        match (self.view.state(), self.policy.quick_stop) {
            (Some(State::OperationEnabled), Some(_)) if self.level == Command::EnableOperation => {
                self.enabled = true;
                Ok(true)
            }
            (Some(State::QuickStopActive), Some(option)) if option.stays => {
                self.would_not_jump(self.out.mode)?;
                self.set_level(Command::EnableOperation);
                Ok(false)
            }
            (Some(State::QuickStopActive), Some(_)) => Err(AxisErrorKind::QuickStopDoesNotStay),
            (Some(State::QuickStopActive), None) => Err(AxisErrorKind::QuickStopNotKnown),
            (None, _) => Ok(false),
            _ => Err(AxisErrorKind::NotQuickStopped),
        }
    }

    /// The next command on the way to `goal`.
    pub(super) fn walk_to(&mut self, goal: State) {
        if let Some(command) = self.view.state().and_then(|state| toward(state, goal, self.policy.quick_stop))
        {
            self.set_level(command);
        }
    }
}
