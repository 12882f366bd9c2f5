//! Targets: what was commanded, and what goes out while nothing is.

use core::time::Duration;

use super::{Axis, AxisError, AxisErrorKind, Doing, Goal};
use crate::cia402::{Mode, State};

/// What the program wants; `None` until it says so.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub(super) struct Commanded {
    pub(super) position: Option<i32>,
    pub(super) velocity: Option<i32>,
    pub(super) torque: Option<i16>,
}

impl Axis {
    /// The position of this cycle, user units, in cyclic synchronous position mode.
    ///
    /// # Errors
    /// [`AxisErrorKind::TargetJumps`]: the target stays what it was. The first one is measured from where the axis is held,
    /// by [`AxisPolicy::seed_limit`](super::AxisPolicy::seed_limit); the others from the one that went out last, by
    /// [`AxisPolicy::step_limits`](super::AxisPolicy::step_limits). [`AxisErrorKind::WrongMode`], [`AxisErrorKind::NotEnabled`].
    pub fn target_position(&mut self, position: i32) -> Result<(), AxisError> {
        self.takes_targets(&[Mode::CYCLIC_POSITION])?;
        let first = self.commanded.position.is_none();
        let limit = if first { Some(self.policy.seed_limit) } else { self.policy.step_limits.position };
        self.in_reach(self.base.position, position, limit)?;
        self.commanded.position = Some(position);
        self.compose();
        Ok(())
    }

    /// The velocity, raw counts: of this cycle in cyclic synchronous velocity mode, to go to in profile velocity mode.
    ///
    /// # Errors
    /// As of [`target_position`](Self::target_position); in profile velocity mode the drive makes the ramp, so no step is too far.
    pub fn target_velocity(&mut self, velocity: i32) -> Result<(), AxisError> {
        self.takes_targets(&[Mode::CYCLIC_VELOCITY, Mode::PROFILE_VELOCITY])?;
        self.in_reach(self.base.velocity, velocity, self.cyclic(self.policy.step_limits.velocity))?;
        self.commanded.velocity = Some(velocity);
        self.compose();
        Ok(())
    }

    /// The torque, raw counts: of this cycle in cyclic synchronous torque mode, to go to in profile torque mode.
    ///
    /// # Errors
    /// As of [`target_velocity`](Self::target_velocity).
    pub fn target_torque(&mut self, torque: i16) -> Result<(), AxisError> {
        let modes = [Mode::CYCLIC_TORQUE, Mode::CYCLIC_TORQUE_ANGLE, Mode::PROFILE_TORQUE];
        self.takes_targets(&modes)?;
        let limit = self.cyclic(self.policy.step_limits.torque);
        self.in_reach(i32::from(self.base.torque), i32::from(torque), limit)?;
        self.commanded.torque = Some(torque);
        self.compose();
        Ok(())
    }

    /// Goes to a velocity; done when bit 10, target reached, shows it. See [`target_velocity`](Self::target_velocity).
    pub fn velocity(&mut self, velocity: i32, within: Duration) {
        let set = self.target_velocity(velocity);
        self.settle(set, within);
    }

    /// Goes to a torque; done when bit 10, target reached, shows it. See [`target_torque`](Self::target_torque).
    pub fn torque(&mut self, torque: i16, within: Duration) {
        let set = self.target_torque(torque);
        self.settle(set, within);
    }

    fn settle(&mut self, set: Result<(), AxisError>, within: Duration) {
        self.begin(Goal::Settle, within);
        if let Err(error) = set {
            self.refuse(error.kind);
        }
    }

    /// A limit of a step where targets come every cycle.
    fn cyclic(&self, limit: Option<u32>) -> Option<u32> {
        limit.filter(|_| self.mode.is_some_and(Mode::is_cyclic))
    }

    fn takes_targets(&self, modes: &[Mode]) -> Result<(), AxisError> {
        let mode = self.mode.filter(|mode| modes.contains(mode) && self.view.mode() == Some(*mode));
        if mode.is_none() {
            return Err(self.refused(AxisErrorKind::WrongMode { shown: self.view.mode() }));
        }
        self.in_operation().map_err(|kind| self.refused(kind))
    }

    pub(super) fn in_operation(&self) -> Result<(), AxisErrorKind> {
        self.not_faulted()?;
        if self.enabled && self.view.state() == Some(State::OperationEnabled) {
            Ok(())
        } else {
            Err(AxisErrorKind::NotEnabled)
        }
    }

    fn in_reach(&self, from: i32, to: i32, limit: Option<u32>) -> Result<(), AxisError> {
        match limit {
            Some(limit) if from.abs_diff(to) > limit => {
                Err(self.refused(AxisErrorKind::TargetJumps { from, to, limit }))
            }
            _ => Ok(()),
        }
    }

    fn refused(&self, kind: AxisErrorKind) -> AxisError {
        AxisError { doing: Doing::Target, ..self.error(kind) }
    }

    /// 607Ah: what was commanded. Where nothing is: the place at which the axis came into operation in cyclic synchronous
    /// position mode, and before that the place where it is.
    pub(super) fn target_position_out(&mut self) -> i32 {
        let operates = self.view.state() == Some(State::OperationEnabled);
        let holds = self.seeded && operates && self.view.mode() == Some(Mode::CYCLIC_POSITION);
        let actual = self.view.position();
        self.seeded |= actual.is_some();
        match self.commanded.position {
            Some(position) => position,
            None if holds => self.out.position,
            None => actual.unwrap_or(self.out.position),
        }
    }

    /// 60FFh and 6071h: 0 but in operation.
    pub(super) fn speeds_out(&self) -> (i32, i16) {
        match self.in_operation() {
            Ok(()) => (self.commanded.velocity.unwrap_or(0), self.commanded.torque.unwrap_or(0)),
            Err(_) => (0, 0),
        }
    }
}
