//! Amounts: raw counts, or physical values that become counts by the unit of the entry.

use core::time::Duration;

use crate::address::Address;
use crate::client::error::ClientError;
use crate::client::object::{AccessError, Action, Cause};
use crate::model::{DriveModel, ObjectDesc};
use crate::object::RangeError;
use crate::quantity::{Angle, FixedUnit, QuantityKind, UserUnit, Velocity};
use crate::ratio::{Factor, Failure};
use crate::scale::Scale;
use crate::value::Value;

/// How much: a raw count, or a value with its unit.
///
/// ```
/// use drivewright_runtime::client::units::Amount;
/// use drivewright_runtime::prelude::*;
///
/// let speeds: [Amount; 2] = [Value::rpm(300).into(), 3_000.into()];
/// assert_ne!(speeds[0], speeds[1], "whether they are the same is up to the unit of the entry");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum Amount {
    /// Counts of the entry.
    Raw(i64),
    /// A physical value: `num / den` of the base unit of `kind`.
    Physical {
        /// What it measures.
        kind: QuantityKind,
        /// Above the line.
        num: i64,
        /// Below the line, not 0.
        den: u32,
    },
}

impl From<i64> for Amount {
    fn from(raw: i64) -> Self {
        Self::Raw(raw)
    }
}

impl<Q: FixedUnit> From<Value<Q>> for Amount {
    fn from(value: Value<Q>) -> Self {
        Self::Physical { kind: Q::KIND, num: value.num(), den: value.den() }
    }
}

impl Amount {
    /// The count that is nearest to it, where the entry takes it.
    pub(super) fn count(
        self,
        model: &DriveModel<'_>,
        address: Address,
        scales: &Scales,
    ) -> Result<i64, ClientError> {
        let (kind, num, den) = match self {
            Self::Raw(raw) => return Ok(raw),
            Self::Physical { kind, num, den } => (kind, num, den),
        };
        let missing = AccessError { address, action: Action::Read, cause: Cause::NotInProfile };
        let object = model.object(address).ok_or(missing)?;
        let mismatch = |entry| ClientError::Unit { address, entry, given: kind };
        let unit = model.unit_of(object).ok_or(mismatch(None))?;
        let (up, down) = unit.factor();
        let own = Factor::new(u64::from(up), u64::from(down)).ok_or(ClientError::NoScale)?;
        let factor = if unit.quantity() == kind {
            own
        } else {
            let scale = scales.get(unit.quantity(), kind).ok_or(mismatch(Some(unit.quantity())))?;
            own.times(scale?).ok_or(ClientError::NoScale)?
        };
        within(object, factor.nearest_count(num, den))
    }
}

/// The count as far as the entry takes it.
fn within(object: &ObjectDesc<'_>, count: Result<i128, Failure>) -> Result<i64, ClientError> {
    let (low, high) = object.data_type().range().unwrap_or((0, 0));
    let near = |n: i128| i64::try_from(n).unwrap_or(if n < 0 { i64::MIN } else { i64::MAX });
    let range = (near(object.min().unwrap_or(low).max(low)), near(object.max().unwrap_or(high).min(high)));
    let count = count.unwrap_or(i128::MAX);
    match i64::try_from(count) {
        Ok(short) if object.accepts(count) => Ok(short),
        _ => Err(RangeError::new(object.address(), count, range, &[]).into()),
    }
}

/// What user units are worth.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Scales {
    position: Option<(QuantityKind, Factor)>,
    velocity: Option<(QuantityKind, Factor)>,
    acceleration: Option<(QuantityKind, Factor)>,
}

impl Scales {
    pub(super) fn set<Q: UserUnit<P>, P: FixedUnit>(&mut self, scale: Scale<Q, P>) {
        let scale = Some((P::KIND, scale.factor()));
        match Q::KIND {
            QuantityKind::UserPosition => self.position = scale,
            QuantityKind::UserVelocity => self.velocity = scale,
            QuantityKind::UserAcceleration => self.acceleration = scale,
            _ => (),
        }
    }

    /// `None`: the units have nothing to do with one another.
    fn get(&self, user: QuantityKind, kind: QuantityKind) -> Option<Result<Factor, ClientError>> {
        let scale = match user {
            QuantityKind::UserPosition => self.position,
            QuantityKind::UserVelocity => self.velocity,
            QuantityKind::UserAcceleration => self.acceleration,
            _ => return None,
        };
        match scale {
            None => Some(Err(ClientError::NoScale)),
            Some((base, factor)) if base == kind => Some(Ok(factor)),
            Some(_) => None,
        }
    }
}

/// How long a distance takes at a speed, whatever the direction; `None` at standstill, or beyond what a [`Duration`] holds.
///
/// ```
/// use core::time::Duration;
/// use drivewright_runtime::client::units::travel_time;
/// use drivewright_runtime::prelude::*;
///
/// // Forty revolutions at 60 rpm.
/// assert_eq!(travel_time(Value::revolutions(40), Value::rpm(60)), Some(Duration::from_secs(40)));
/// assert_eq!(travel_time(Value::revolutions(40), Value::rpm(0)), None);
/// ```
pub fn travel_time(distance: Value<Angle>, speed: Value<Velocity>) -> Option<Duration> {
    const MICROS_PER_MINUTE: u128 = 60_000_000;
    let above = u128::from(distance.num().unsigned_abs()).checked_mul(u128::from(speed.den()))?;
    let below = u128::from(distance.den()).checked_mul(u128::from(speed.num().unsigned_abs()))?;
    let micros = above.checked_mul(MICROS_PER_MINUTE)?.checked_div(below)?;
    u64::try_from(micros).ok().map(Duration::from_micros)
}
