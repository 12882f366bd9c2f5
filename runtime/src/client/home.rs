//! Homing as a whole: method, speeds and offset are written, the mode is changed, home is found, the mode is changed back.

use core::time::Duration;

use crate::address::Address;
use crate::cia402::Mode;
use crate::client::axis::Request;
use crate::client::error::ClientError;
use crate::client::session::{Client, Plan, Step};
use crate::client::units::{travel_time, Amount};
use crate::homing::{HomingDesc, HomingStatus};
use crate::quantity::{Angle, Velocity};
use crate::value::Value;

const METHOD: Address = Address::new(0x6098, 0);
const FAST: Address = Address::new(0x6099, 1);
const SLOW: Address = Address::new(0x6099, 2);
const ACCELERATION: Address = Address::new(0x609A, 0);
const OFFSET: Address = Address::new(0x607C, 0);

/// A homing. What is not said stays as the drive has it.
///
/// ```
/// use drivewright_runtime::client::home::Homing;
/// use drivewright_runtime::prelude::*;
///
/// // At most 40 revolutions to the switch: the time-out follows from that and from the speeds.
/// let homing = Homing::method(17).travel(Value::revolutions(40), Value::rpm(60), Value::rpm(6)).keep_mode();
/// // There and back at 60 rpm, two revolutions at 6 rpm, and two seconds for the ramps.
/// assert_eq!(homing.time_out().as_secs(), 80 + 20 + 2);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Homing {
    method: i8,
    fast: Option<Amount>,
    slow: Option<Amount>,
    acceleration: Option<Amount>,
    offset: Option<Amount>,
    within: Duration,
    keeps_mode: bool,
    unless_homed: bool,
}

impl Homing {
    /// Homing by a method, with a time-out of a minute.
    pub const fn method(method: i8) -> Self {
        Self {
            method,
            fast: None,
            slow: None,
            acceleration: None,
            offset: None,
            within: Duration::from_secs(60),
            keeps_mode: false,
            unless_homed: false,
        }
    }

    /// With the speed to the switch, 6099:01, and that to the index, 6099:02.
    #[must_use]
    pub fn speeds(self, fast: impl Into<Amount>, slow: impl Into<Amount>) -> Self {
        Self { fast: Some(fast.into()), slow: Some(slow.into()), ..self }
    }

    /// With the speeds, and a time-out that is enough for the longest way: there and back at the fast speed, two
    /// revolutions at the slow one, and two seconds. A speed of 0 leaves the time-out as it is.
    #[must_use]
    pub fn travel(self, distance: Value<Angle>, fast: Value<Velocity>, slow: Value<Velocity>) -> Self {
        let way = travel_time(distance, fast).map(|time| time.saturating_mul(2));
        let search = travel_time(Value::revolutions(2), slow);
        let within = match (way, search) {
            (Some(way), Some(search)) => way.saturating_add(search).saturating_add(Duration::from_secs(2)),
            _ => self.within,
        };
        self.speeds(fast, slow).within(within)
    }

    /// With the acceleration, 609Ah.
    #[must_use]
    pub fn acceleration(self, acceleration: impl Into<Amount>) -> Self {
        Self { acceleration: Some(acceleration.into()), ..self }
    }

    /// With the home offset, 607Ch.
    #[must_use]
    pub fn offset(self, offset: impl Into<Amount>) -> Self {
        Self { offset: Some(offset.into()), ..self }
    }

    /// With a time-out. The drive may have one of its own, which must be longer.
    #[must_use]
    pub const fn within(self, within: Duration) -> Self {
        Self { within, ..self }
    }

    /// Stays in homing mode afterwards.
    #[must_use]
    pub const fn keep_mode(self) -> Self {
        Self { keeps_mode: true, ..self }
    }

    /// Does nothing where this client has homed the axis already.
    #[must_use]
    pub const fn unless_homed(self) -> Self {
        Self { unless_homed: true, ..self }
    }

    /// The longest time that it may take.
    pub const fn time_out(&self) -> Duration {
        self.within
    }

    /// The steps.
    ///
    /// # Errors
    /// [`ClientError::NotAHomingMethod`], and those of [`Client::count`].
    pub fn plan(&self, client: &Client<'_>) -> Result<Plan, ClientError> {
        if self.unless_homed && client.axis().is_homed() {
            return Ok(Plan::EMPTY);
        }
        let model = client.model();
        let usable = |method: &HomingDesc<'_>| method.status() != HomingStatus::Reserved;
        let unknown = !model.homing_methods().is_empty() && !model.homing(self.method).is_some_and(usable);
        if self.method == 0 || unknown {
            return Err(ClientError::NotAHomingMethod { method: self.method });
        }
        let mut plan = Plan::EMPTY.then(Step::NeedOperation);
        let amounts =
            [(FAST, self.fast), (SLOW, self.slow), (ACCELERATION, self.acceleration), (OFFSET, self.offset)];
        for (address, amount) in amounts {
            plan = plan.amount(client, address, amount)?;
        }
        plan = plan
            .then(Step::Set(client.image().at(METHOD), i64::from(self.method)))
            .then(Step::Goal(Request::SelectMode(Mode::HOMING)))
            .then(Step::Goal(Request::Home(self.within)));
        Ok(if self.keeps_mode { plan } else { plan.then(Step::RestoreMode) })
    }
}
