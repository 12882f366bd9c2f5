//! The fault reset: an edge whose levels are held, and a look at what came of it.

use super::{Axis, Goal, Verdict};
use crate::cia402::{Command, State};

#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum ResetPhase {
    /// Bit 7 is low, so that an edge can rise.
    Low,
    /// Bit 7 is high.
    High,
    /// Bit 7 is low again; the fault should be gone.
    Verify,
}

impl Axis {
    /// Resets a fault, once. Done when the drive is out of it; done at once where there is none, and then nothing changes.
    /// The axis is not enabled afterwards: that is another goal.
    pub fn reset_fault(&mut self) {
        let edge = self.policy.edge_hold.saturating_mul(2);
        // A fault that is still being handled is waited for.
        let within = self.policy.state_within.saturating_add(edge).saturating_add(self.policy.reset_within);
        self.begin(Goal::Reset(ResetPhase::Low), within);
    }

    pub(super) fn advance_reset(&mut self, phase: ResetPhase) -> Verdict {
        let state = self.view.state();
        match phase {
            ResetPhase::Low => {
                let Some(seen) = state else { return Ok(false) };
                if !seen.is_fault() {
                    return Ok(true);
                }
                self.leave_operation(Command::DisableVoltage);
                self.set_level(Command::DisableVoltage);
                if state == Some(State::Fault) && self.edge_is_held() {
                    self.set_level(Command::FaultReset);
                    self.enter(Goal::Reset(ResetPhase::High));
                }
                Ok(false)
            }
            ResetPhase::High => {
                if self.edge_is_held() {
                    self.set_level(Command::DisableVoltage);
                    self.enter(Goal::Reset(ResetPhase::Verify));
                }
                Ok(false)
            }
            ResetPhase::Verify if self.phase >= self.policy.reset_within => Err(self.overdue()),
            ResetPhase::Verify => Ok(self.is_fresh() && state.is_some_and(|state| !state.is_fault())),
        }
    }

    /// Whether the level of this phase has been sent, and for long enough.
    pub(super) fn edge_is_held(&self) -> bool {
        self.phase_samples >= 2 && self.phase >= self.policy.edge_hold
    }
}
