//! Moves as a whole: the mode is selected, the profile is written, the target is given and reached.

use core::time::Duration;

use crate::address::Address;
use crate::cia402::Mode;
use crate::client::axis::{Request, SetPoint};
use crate::client::error::ClientError;
use crate::client::object::{AccessError, Action, Cause};
use crate::client::session::{Client, Plan, Step};
use crate::client::units::Amount;
use crate::object::RangeError;

const TARGET_POSITION: Address = Address::new(0x607A, 0);
const TARGET_VELOCITY: Address = Address::new(0x60FF, 0);
const TARGET_TORQUE: Address = Address::new(0x6071, 0);
const PROFILE_VELOCITY: Address = Address::new(0x6081, 0);
const PROFILE_ACCELERATION: Address = Address::new(0x6083, 0);
const PROFILE_DECELERATION: Address = Address::new(0x6084, 0);
const TORQUE_SLOPE: Address = Address::new(0x6087, 0);
/// How long an axis may take to stand after a jog.
const STOP_WITHIN: Duration = Duration::from_secs(10);
const MINUTE: Duration = Duration::from_secs(60);

impl Plan {
    /// With an entry of this axis to be set, if there is an amount for it.
    pub(super) fn amount(
        self,
        client: &Client<'_>,
        address: Address,
        amount: Option<Amount>,
    ) -> Result<Self, ClientError> {
        match amount {
            Some(amount) => {
                Ok(self.then(Step::Set(client.image().at(address), client.count(address, amount)?)))
            }
            None => Ok(self),
        }
    }
}

/// A count as a target of `bits` bits: what does not go into them is out of range.
fn target<T: TryFrom<i64>>(client: &Client<'_>, address: Address, amount: Amount) -> Result<T, ClientError> {
    let count = client.count(address, amount)?;
    let at = client.image().at(address);
    let model = client.model();
    let missing = AccessError { address: at, action: Action::Write(Some(count)), cause: Cause::NotInProfile };
    let object = model.object(at).ok_or(missing)?;
    let limit = |limit: Option<i128>, nearest| limit.and_then(|n| i64::try_from(n).ok()).unwrap_or(nearest);
    let range = (limit(object.min(), i64::MIN), limit(object.max(), i64::MAX));
    let refused = RangeError::new(at, count.into(), range, &[]);
    if !object.accepts(count.into()) {
        return Err(refused.into());
    }
    T::try_from(count).map_err(|_| refused.into())
}

/// A move in profile position mode. What is not said stays as the drive has it.
///
/// ```
/// use core::time::Duration;
/// use drivewright_runtime::client::moves::MoveTo;
/// use drivewright_runtime::prelude::*;
///
/// let there = MoveTo::to(120_000).velocity(Value::rpm(300)).within(Duration::from_secs(5));
/// let back = MoveTo::by(-120_000).immediately();
/// assert_ne!(there, back);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct MoveTo {
    target: Amount,
    relative: bool,
    immediately: bool,
    velocity: Option<Amount>,
    acceleration: Option<Amount>,
    deceleration: Option<Amount>,
    within: Duration,
}

impl MoveTo {
    /// To a position, with a time-out of a minute.
    pub fn to(target: impl Into<Amount>) -> Self {
        Self {
            target: target.into(),
            relative: false,
            immediately: false,
            velocity: None,
            acceleration: None,
            deceleration: None,
            within: MINUTE,
        }
    }

    /// By a distance.
    pub fn by(distance: impl Into<Amount>) -> Self {
        Self { relative: true, ..Self::to(distance) }
    }

    /// Replaces a move that is under way.
    #[must_use]
    pub const fn immediately(self) -> Self {
        Self { immediately: true, ..self }
    }

    /// With the velocity, 6081h.
    #[must_use]
    pub fn velocity(self, velocity: impl Into<Amount>) -> Self {
        Self { velocity: Some(velocity.into()), ..self }
    }

    /// With the acceleration, 6083h, in what the drive measures it: some have a time there.
    #[must_use]
    pub fn acceleration(self, acceleration: impl Into<Amount>) -> Self {
        Self { acceleration: Some(acceleration.into()), ..self }
    }

    /// With the deceleration, 6084h.
    #[must_use]
    pub fn deceleration(self, deceleration: impl Into<Amount>) -> Self {
        Self { deceleration: Some(deceleration.into()), ..self }
    }

    /// With a time-out.
    #[must_use]
    pub const fn within(self, within: Duration) -> Self {
        Self { within, ..self }
    }

    /// The steps.
    ///
    /// # Errors
    /// Those of [`Client::count`].
    pub fn plan(&self, client: &Client<'_>) -> Result<Plan, ClientError> {
        let target = target(client, TARGET_POSITION, self.target)?;
        let set_point = SetPoint { target, relative: self.relative, immediately: self.immediately };
        let plan = Plan::EMPTY
            .then(Step::NeedOperation)
            .amount(client, PROFILE_VELOCITY, self.velocity)?
            .amount(client, PROFILE_ACCELERATION, self.acceleration)?
            .amount(client, PROFILE_DECELERATION, self.deceleration)?
            .then(Step::Goal(Request::SelectMode(Mode::PROFILE_POSITION)));
        Ok(plan.then(Step::Goal(Request::MoveTo(set_point, self.within))))
    }
}

/// The steps to a velocity in profile velocity mode.
///
/// # Errors
/// Those of [`Client::count`].
pub fn velocity(client: &Client<'_>, velocity: Amount, within: Duration) -> Result<Plan, ClientError> {
    let velocity = target(client, TARGET_VELOCITY, velocity)?;
    Ok(in_mode(Mode::PROFILE_VELOCITY).then(Step::Goal(Request::Velocity(velocity, within))))
}

/// The steps to a torque in profile torque mode. Where the statusword of the drive does not show in this mode that a target
/// is reached, they end when it is sent. The slope is 6087h, where it is said.
///
/// # Errors
/// Those of [`Client::count`].
pub fn torque(
    client: &Client<'_>,
    torque: Amount,
    slope: Option<Amount>,
    within: Duration,
) -> Result<Plan, ClientError> {
    let torque = target(client, TARGET_TORQUE, torque)?;
    let plan = in_mode(Mode::PROFILE_TORQUE).amount(client, TORQUE_SLOPE, slope)?;
    Ok(if client.shows_target_reached(Mode::PROFILE_TORQUE) {
        plan.then(Step::Goal(Request::Torque(torque, within)))
    } else {
        plan.then(Step::TargetTorque(torque)).then(Step::Cycle)
    })
}

/// The steps of a jog: a velocity in profile velocity mode as long as it is held, and no longer than `within`; then
/// standstill.
///
/// # Errors
/// Those of [`Client::count`].
pub fn jog(client: &Client<'_>, velocity: Amount, within: Duration) -> Result<Plan, ClientError> {
    let velocity = target(client, TARGET_VELOCITY, velocity)?;
    Ok(in_mode(Mode::PROFILE_VELOCITY)
        .then(Step::TargetVelocity(velocity))
        .then(Step::Hold(within))
        .then(Step::Goal(Request::Velocity(0, STOP_WITHIN))))
}

fn in_mode(mode: Mode) -> Plan {
    Plan::EMPTY.then(Step::NeedOperation).then(Step::Goal(Request::SelectMode(mode)))
}
