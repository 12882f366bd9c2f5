//! The way up: a mode that the drive confirms, a target where the axis is, the states one by one.

use super::{Axis, AxisErrorKind, Goal, Verdict, MODE_BITS};
use crate::cia402::{Command, Controlword, Mode, State};

impl Axis {
    /// Goes to operation in a mode. Done when 6061h shows the mode and the statusword shows operation; at once if both do
    /// already.
    ///
    /// The target position follows the actual one until the axis is in operation, and is held from then on; velocity and
    /// torque start from 0. It does not reset a fault.
    pub fn enable(&mut self, mode: Mode) {
        self.start_enabling(mode, None);
    }

    /// As [`enable`](Self::enable) in cyclic synchronous position mode, with a first target. It is refused if the axis is
    /// not there, within [`AxisPolicy::seed_limit`](super::AxisPolicy::seed_limit).
    pub fn enable_with_target(&mut self, position: i32) {
        self.start_enabling(Mode::CYCLIC_POSITION, Some(position));
    }

    /// Selects a mode in any state. Done when 6061h shows it.
    pub fn select_mode(&mut self, mode: Mode) {
        self.begin(Goal::SelectMode, self.policy.mode_within);
        if self.policy.modes.has(mode) {
            self.want_mode(mode);
        } else {
            self.refuse(self.mode_not_supported(mode));
        }
    }

    fn start_enabling(&mut self, mode: Mode, position: Option<i32>) {
        self.begin(Goal::Enable(mode), self.policy.state_within);
        if !self.policy.modes.has(mode) {
            return self.refuse(self.mode_not_supported(mode));
        }
        self.want_mode(mode);
        if !self.enabled {
            self.drop_commands();
            self.commanded.position = position;
        }
    }

    /// A mode takes over nothing of what was commanded in another one.
    fn want_mode(&mut self, mode: Mode) {
        if self.policy.mode_needs_halt_off && self.view.mode() != Some(mode) {
            self.set_bit(Controlword::HALT, false);
        }
        if self.mode != Some(mode) {
            self.mode = Some(mode);
            self.drop_commands();
        }
    }

    pub(super) fn advance_enable(&mut self, mode: Mode) -> Verdict {
        self.not_faulted()?;
        self.would_not_jump(mode)?;
        if self.policy.mode_before_enable && !self.mode_is_taken() {
            return if self.waited < self.policy.mode_within {
                Ok(false)
            } else {
                Err(self.mode_not_taken())
            };
        }
        let state = self.view.state();
        if state == Some(State::OperationEnabled)
            && self.level != Command::EnableOperation
            && !self.level_has_arrived()
        {
            // The command before this one takes the axis out of operation: the sample is older than that.
            return Ok(false);
        }
        self.walk_to(State::OperationEnabled);
        self.enabled |= state == Some(State::OperationEnabled);
        Ok(self.enabled && self.mode_is_taken())
    }

    /// That the axis would not jump if it went to operation with the next cycle.
    pub(super) fn would_not_jump(&self, mode: Mode) -> Result<(), AxisErrorKind> {
        if mode != Mode::CYCLIC_POSITION || self.enabled {
            return Ok(());
        }
        let actual = self.view.position().ok_or(AxisErrorKind::NoActualPosition)?;
        let target = self.commanded.position.unwrap_or(actual);
        let limit = self.policy.seed_limit;
        if target.abs_diff(actual) > limit {
            return Err(AxisErrorKind::SeedTooFar { target, actual, limit });
        }
        Ok(())
    }

    pub(super) fn mode_is_taken(&self) -> bool {
        self.view.mode() == self.mode && self.mode.is_some()
    }

    pub(super) fn mode_not_taken(&self) -> AxisErrorKind {
        AxisErrorKind::ModeNotTaken {
            asked: self.mode.unwrap_or(Mode::NONE),
            shown: self.view.mode(),
            halted: self.bits & Controlword::HALT != 0,
        }
    }

    fn mode_not_supported(&self, asked: Mode) -> AxisErrorKind {
        AxisErrorKind::ModeNotSupported { asked, supported: self.policy.modes }
    }
}

// The bits that a change of the mode clears are those that a drive could take for a command of the new mode.
const _: () = assert!(MODE_BITS & Controlword::MODE_4 != 0 && MODE_BITS & Controlword::HALT == 0);
