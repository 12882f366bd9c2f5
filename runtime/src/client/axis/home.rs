//! Homing, supervised: the result is that of this homing, not of an earlier one.

use core::time::Duration;

use super::{Axis, AxisErrorKind, Goal, Verdict};
use crate::cia402::{HomingState, Mode, ModeBits, Statusword};

#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum HomePhase {
    /// Bit 4 is low, so that an edge can rise.
    Low,
    /// Bit 4 is high; the drive must show that it starts. `before`: what it showed until now.
    Start {
        before: HomingState,
    },
    Running,
    /// It looks interrupted.
    Idle,
}

impl HomePhase {
    pub(super) const fn overdue(self, word: Statusword) -> AxisErrorKind {
        let state = HomingState::of(word);
        match self {
            Self::Low | Self::Start { .. } => AxisErrorKind::HomingNotStarted(state),
            Self::Running | Self::Idle => AxisErrorKind::HomingTooLong(state),
        }
    }
}

/// Home was found, at rest or not yet.
const fn attained(state: HomingState) -> bool {
    matches!(state, HomingState::Attained | HomingState::Completed)
}

/// Homing failed, or the drive reports a pattern that is none.
const fn failed(state: HomingState) -> bool {
    matches!(state, HomingState::ErrorMoving | HomingState::ErrorStopped | HomingState::Reserved)
}

impl Axis {
    /// Starts homing in homing mode, with the method and speeds that the drive holds; done when home is found and the axis
    /// stands. It is never started by anything else. When it fails or takes too long bit 4 falls, which ends it.
    pub fn home(&mut self, within: Duration) {
        self.homed = false;
        self.set_bit(ModeBits::START_HOMING, false);
        self.begin(Goal::Home(HomePhase::Low), within);
        if self.view.mode() != Some(Mode::HOMING) || self.mode != self.view.mode() {
            return self.refuse(AxisErrorKind::WrongMode { shown: self.view.mode() });
        }
        if let Err(kind) = self.in_operation() {
            self.refuse(kind);
        }
    }

    pub(super) fn advance_home(&mut self, phase: HomePhase, word: Statusword) -> Verdict {
        let state = HomingState::of(word);
        match phase {
            HomePhase::Low => {
                if self.edge_is_held() && self.is_fresh() {
                    self.enter(Goal::Home(HomePhase::Start { before: state }));
                    self.set_bit(ModeBits::START_HOMING, true);
                }
                Ok(false)
            }
            HomePhase::Start { before } if !self.started(before, state)? => Ok(false),
            HomePhase::Start { .. } | HomePhase::Running | HomePhase::Idle => self.run(phase, state),
        }
    }

    /// Whether this homing has started: what the drive shows is not what it showed before, or cannot be.
    fn started(&self, before: HomingState, state: HomingState) -> Verdict {
        let overdue = self.phase >= self.policy.homing_start_within;
        if failed(state) {
            // An old error shows until the drive has seen the start.
            return Ok(!failed(before) || overdue);
        }
        if attained(state) && attained(before) {
            let believed = !self.policy.homing_clears_attained;
            return if overdue && !believed {
                Err(AxisErrorKind::HomingNotStarted(state))
            } else {
                Ok(overdue)
            };
        }
        match state {
            // Before the start it can look like this, too: the axis is not in its window.
            HomingState::InProgress => Ok(self.is_fresh()),
            HomingState::NotStarted if attained(before) || failed(before) => Ok(true),
            HomingState::NotStarted if overdue => Err(AxisErrorKind::HomingNotStarted(state)),
            HomingState::NotStarted => Ok(false),
            _ => Ok(true),
        }
    }

    fn run(&mut self, phase: HomePhase, state: HomingState) -> Verdict {
        if failed(state) {
            return Err(AxisErrorKind::HomingFailed(state));
        }
        self.homed = state == HomingState::Completed;
        let next = if state == HomingState::NotStarted { HomePhase::Idle } else { HomePhase::Running };
        if next != phase {
            self.enter(Goal::Home(next));
        }
        if next == HomePhase::Idle && self.phase >= self.policy.homing_idle {
            return Err(AxisErrorKind::HomingInterrupted);
        }
        Ok(self.homed)
    }
}
