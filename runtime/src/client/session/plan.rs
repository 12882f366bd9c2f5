//! What an operation does, step by step.

use core::time::Duration;

use crate::address::Address;
use crate::client::axis::Request;

/// A step of an operation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Step {
    /// Write this raw number: into the process data where the entry is mapped, by SDO otherwise.
    Set(Address, i64),
    /// Write this raw number by SDO. Refused where process data would overwrite it.
    Write(Address, i64),
    /// That the axis is in operation.
    NeedOperation,
    /// Read what 605Ah says.
    ReadQuickStop,
    /// That the fault, if there is one, can be reset.
    NeedResettable,
    /// Pursue a goal.
    Goal(Request),
    /// Set the target velocity, raw.
    TargetVelocity(i32),
    /// Set the target torque, raw.
    TargetTorque(i16),
    /// Select the mode again that was shown before the operation.
    RestoreMode,
    /// One cycle; an axis that has left operation is no error, for it is what the plan is for.
    Look,
    /// One cycle.
    Cycle,
    /// Cycles as long as the caller says, and no longer than this.
    Hold(Duration),
}

/// The most steps of a plan.
const STEPS: usize = 10;

/// The steps of an operation, in order.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Plan {
    steps: [Option<Step>; STEPS],
}

impl Plan {
    /// No steps.
    pub const EMPTY: Self = Self { steps: [None; STEPS] };

    /// One cycle.
    pub const fn cycle() -> Self {
        let mut steps = [None; STEPS];
        steps[0] = Some(Step::Cycle);
        Self { steps }
    }

    /// A goal.
    pub fn goal(request: Request) -> Self {
        Self::EMPTY.then(Step::Goal(request))
    }

    /// With one more step. There is room for ten; more are left out.
    #[must_use]
    pub fn then(mut self, step: Step) -> Self {
        if let Some(place) = self.steps.iter_mut().find(|place| place.is_none()) {
            *place = Some(step);
        }
        self
    }

    /// With a value to be set, if there is one.
    #[must_use]
    pub fn set(self, address: Address, value: Option<i64>) -> Self {
        match value {
            Some(value) => self.then(Step::Set(address, value)),
            None => self,
        }
    }

    pub(super) fn step(&self, at: usize) -> Option<Step> {
        *self.steps.get(at)?
    }
}
