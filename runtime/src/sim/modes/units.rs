//! From the units of the dictionary to those of the axis and back: counts, 1/256 count per second, counts per square
//! second, 0.1 % of rated torque.

use crate::quantity::QuantityKind;

use super::super::config::Config;
use super::super::memory::{Memory, Slot};
use super::super::number::bits;
use super::super::slots::Slots;

/// Parts of a count per second.
const SPEED: i64 = 256;

/// A factor from a raw number to the unit of the axis: `num / den`, both above 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Scale {
    num: i64,
    den: i64,
}

impl Scale {
    pub(crate) const ONE: Self = Self { num: 1, den: 1 };

    /// `num / den`, reduced and within 62 bits; what is not above 0 counts as 1.
    fn new(num: i128, den: i128) -> Self {
        let common = gcd(num.max(1), den.max(1)).max(1);
        let (mut num, mut den) = (num.max(1) / common, den.max(1) / common);
        while num > i128::from(i64::MAX) || den > i128::from(i64::MAX) {
            (num, den) = ((num >> 1).max(1), (den >> 1).max(1));
        }
        Self { num: i64::try_from(num).unwrap_or(1), den: i64::try_from(den).unwrap_or(1) }
    }

    /// The nearest number of the axis.
    pub(crate) fn inward(self, raw: i64) -> i64 {
        nearest(raw, self.num, self.den)
    }

    /// The nearest raw number.
    pub(crate) fn outward(self, value: i64) -> i64 {
        nearest(value, self.den, self.num)
    }
}

/// `value * num / den`, to the nearest; halves go up.
fn nearest(value: i64, num: i64, den: i64) -> i64 {
    if num == den {
        return value;
    }
    let half = den >> 1;
    let short = value.checked_mul(num).and_then(|product| product.checked_add(half));
    if let Some(quotient) = short.and_then(|sum| sum.checked_div_euclid(den)) {
        return quotient;
    }
    let sum = product([i128::from(value), i128::from(num)]).saturating_add(i128::from(half));
    let quotient = sum.checked_div_euclid(i128::from(den)).unwrap_or(0);
    i64::try_from(quotient).unwrap_or(if quotient < 0 { i64::MIN } else { i64::MAX })
}

/// The greatest common divisor of two numbers above 0.
fn gcd(a: i128, b: i128) -> i128 {
    let (mut a, mut b) = (a, b);
    while let Some(rest) = a.checked_rem(b) {
        (a, b) = (b, rest);
    }
    a
}

/// What the parameters of the drive say, in units of the axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Units {
    /// User positions.
    pub(crate) position: Scale,
    /// 606Bh, 606Ch and 60FFh.
    pub(crate) velocity: Scale,
    /// 6071h, 6074h and 6077h.
    pub(crate) torque: Scale,
    /// The speed of a positioning.
    pub(crate) profile_velocity: i64,
    /// The highest speed that a profile has.
    pub(crate) max_velocity: i64,
    /// The highest speed of the motor.
    pub(crate) max_motor_speed: i64,
    pub(crate) acceleration: i64,
    pub(crate) deceleration: i64,
    pub(crate) quick_stop: i64,
    pub(crate) homing_fast: i64,
    pub(crate) homing_slow: i64,
    pub(crate) homing_acceleration: i64,
    /// In counts.
    pub(crate) home_offset: i64,
    pub(crate) position_offset: i64,
    /// Software limits in counts; `None` where there are none.
    pub(crate) limits: Option<(i64, i64)>,
    pub(crate) following_window: Option<i64>,
    pub(crate) position_window: i64,
    pub(crate) velocity_window: i64,
    pub(crate) velocity_threshold: i64,
    /// Torque limits, positive and negative, in 0.1 % of rated.
    pub(crate) torque_limits: (i32, i32),
    /// How much the torque changes in a second; `None`: at once.
    pub(crate) torque_slope: Option<i64>,
}

/// A look at the dictionary.
struct View<'a, 'm, 's> {
    memory: &'a Memory<'m, 's>,
    slots: &'a Slots,
    config: &'a Config,
    position: Scale,
    revolution: i64,
}

impl Units {
    pub(crate) fn of(memory: &Memory<'_, '_>, slots: &Slots, config: &Config) -> Self {
        let revolution = revolution(memory, slots, config);
        let position = gear(memory, slots, revolution);
        View { memory, slots, config, position, revolution }.units()
    }
}

impl View<'_, '_, '_> {
    fn units(&self) -> Units {
        let slots = self.slots;
        let max_motor_speed = self.limit(slots.max_motor_speed);
        let max_velocity = self.limit(slots.max_profile_velocity).min(max_motor_speed);
        Units {
            position: self.position,
            velocity: self.velocity_scale(if slots.velocity.exists() {
                slots.velocity
            } else {
                slots.target_velocity
            }),
            torque: self.torque_scale(slots.target_torque),
            profile_velocity: self.speed(slots.profile_velocity).min(max_velocity),
            max_velocity,
            max_motor_speed,
            acceleration: self.acceleration(slots.acceleration, i64::MAX),
            deceleration: self.acceleration(slots.deceleration, i64::MAX),
            quick_stop: self
                .acceleration(slots.quick_stop_deceleration, self.rpm(self.config.quick_stop_ramp)),
            homing_fast: self.speed(slots.homing_fast).min(max_motor_speed),
            homing_slow: self.speed(slots.homing_slow).min(max_motor_speed),
            homing_acceleration: self
                .acceleration(slots.homing_acceleration, self.acceleration(slots.acceleration, i64::MAX)),
            home_offset: self.counts(slots.home_offset),
            position_offset: self.counts(slots.position_offset),
            limits: self.limits(),
            following_window: self.following_window(),
            position_window: self.counts(slots.position_window),
            velocity_window: self.speed(slots.velocity_window),
            velocity_threshold: self.speed(slots.velocity_threshold),
            torque_limits: self.torque_limits(),
            torque_slope: self.torque_slope(),
        }
    }

    fn raw(&self, slot: Slot) -> i64 {
        self.memory.used(slot)
    }

    /// The quantity of an entry and what one count of it is, in base units.
    fn unit(&self, slot: Slot) -> (QuantityKind, i128, i128) {
        let object = self.memory.object(slot);
        let unit = object.and_then(|object| self.memory.model().unit_of(object));
        unit.map_or((QuantityKind::Raw, 1, 1), |unit| {
            let (num, den) = unit.factor();
            (unit.quantity(), i128::from(num), i128::from(den))
        })
    }

    /// An acceleration, in counts per square second, of so many rpm in a second.
    fn rpm(&self, rpm: u32) -> i64 {
        (self.revolution / 60).saturating_mul(i64::from(rpm))
    }

    /// The factor of an entry that is a speed. A speed without a unit is in user units.
    fn velocity_scale(&self, slot: Slot) -> Scale {
        let (quantity, num, den) = self.unit(slot);
        let (gear_num, gear_den) = (i128::from(self.position.num), i128::from(self.position.den));
        let speed = i128::from(SPEED);
        match quantity {
            QuantityKind::Velocity => {
                Scale::new(product([num, i128::from(self.revolution), speed]), product([den, 60]))
            }
            QuantityKind::Counts => Scale::new(product([num, speed]), den),
            _ => Scale::new(product([num, gear_num, speed]), product([den, gear_den])),
        }
    }

    fn torque_scale(&self, slot: Slot) -> Scale {
        match self.unit(slot) {
            (QuantityKind::TorqueRatio | QuantityKind::CurrentRatio, num, den) => {
                Scale::new(product([num, 1_000]), den)
            }
            _ => Scale::ONE,
        }
    }

    fn speed(&self, slot: Slot) -> i64 {
        self.velocity_scale(slot).inward(self.raw(slot))
    }

    /// A speed limit; without the object there is none.
    fn limit(&self, slot: Slot) -> i64 {
        if slot.exists() {
            self.speed(slot)
        } else {
            FASTEST
        }
    }

    /// A ramp: a rate, or the time for a change of speed.
    fn acceleration(&self, slot: Slot, default: i64) -> i64 {
        if !slot.exists() {
            return default;
        }
        let (quantity, num, den) = self.unit(slot);
        let raw = i128::from(self.raw(slot)).max(1);
        let revolution = i128::from(self.revolution);
        let (gear_num, gear_den) = (i128::from(self.position.num), i128::from(self.position.den));
        let rate = match quantity {
            QuantityKind::Time => {
                let speed = i128::from(self.config.ramp_speed);
                ratio(product([speed, revolution, den]), product([raw, num, 60]))
            }
            QuantityKind::RampTime => ratio(product([1_000, revolution, den]), product([raw, num, 60])),
            QuantityKind::Acceleration => ratio(product([raw, num, revolution]), product([den, 60])),
            QuantityKind::Counts => ratio(product([raw, num]), den),
            _ => ratio(product([raw, num, gear_num]), product([den, gear_den])),
        };
        rate.max(1)
    }

    fn counts(&self, slot: Slot) -> i64 {
        self.position.inward(self.raw(slot))
    }

    fn limits(&self) -> Option<(i64, i64)> {
        let (min, max) = (self.slots.min_position, self.slots.max_position);
        let there = min.exists() && max.exists() && self.raw(min) < self.raw(max);
        there.then(|| (self.counts(min), self.counts(max)))
    }

    /// In counts where the unit says so or there is none; all bits set switch it off.
    fn following_window(&self) -> Option<i64> {
        let slot = self.slots.following_window;
        let raw = Some(self.raw(slot)).filter(|raw| slot.exists() && *raw != i64::from(u32::MAX))?;
        let (quantity, num, den) = self.unit(slot);
        Some(match quantity {
            QuantityKind::UserPosition => self.position.inward(raw),
            QuantityKind::Angle => ratio(product([i128::from(raw), num, i128::from(self.revolution)]), den),
            _ => raw,
        })
    }

    /// The lower of 6072h and of 60E0h or 60E1h.
    fn torque_limits(&self) -> (i32, i32) {
        let of = |slot: Slot| {
            let limit = slot.exists().then(|| self.torque_scale(slot).inward(self.raw(slot)));
            limit.and_then(|limit| i32::try_from(limit).ok()).unwrap_or(i32::MAX)
        };
        let both = of(self.slots.max_torque);
        (both.min(of(self.slots.max_torque_positive)), both.min(of(self.slots.max_torque_negative)))
    }

    fn torque_slope(&self) -> Option<i64> {
        let slot = self.slots.torque_slope;
        slot.exists().then(|| self.torque_scale(slot).inward(self.raw(slot)))
    }
}

/// The highest speed that the axis knows.
const FASTEST: i64 = 1 << 44;

/// Counts of a revolution of the motor.
fn revolution(memory: &Memory<'_, '_>, slots: &Slots, config: &Config) -> i64 {
    let (increments, turns) = (memory.used(slots.encoder_increments), memory.used(slots.encoder_revolutions));
    let stated = (increments > 0).then(|| increments.checked_div(turns.max(1))).flatten();
    stated.unwrap_or(i64::from(config.counts_per_revolution)).clamp(1, 1 << 40)
}

/// Counts for one user unit: 6093h, or 608Fh, 6091h and 6092h; one to one where there is neither.
fn gear(memory: &Memory<'_, '_>, slots: &Slots, revolution: i64) -> Scale {
    let of = |slot: Slot| i128::from(memory.used_or(slot, 1).max(1));
    if slots.factor_numerator.exists() {
        return Scale::new(of(slots.factor_numerator), of(slots.factor_divisor));
    }
    let feed = if slots.feed.exists() { of(slots.feed) } else { i128::from(revolution) };
    Scale::new(
        product([i128::from(revolution), of(slots.gear_motor), of(slots.feed_revolutions)]),
        product([of(slots.gear_shaft), feed]),
    )
}

/// The product, or the nearest number.
fn product<const N: usize>(factors: [i128; N]) -> i128 {
    factors.into_iter().fold(1, i128::saturating_mul)
}

/// `num / den` rounded down; 1 at least below the line.
fn ratio(num: i128, den: i128) -> i64 {
    let quotient = num.checked_div(den.max(1)).unwrap_or(0);
    i64::try_from(quotient).unwrap_or(i64::MAX)
}

/// A span of microseconds, as a number that can be compared with sums.
pub(super) fn micros(span: core::time::Duration) -> i64 {
    i64::try_from(crate::time::micros(span)).unwrap_or(i64::MAX)
}

/// How far apart two places are.
pub(super) fn distance(a: i64, b: i64) -> i64 {
    i64::try_from(bits(a.saturating_sub(b).saturating_abs())).unwrap_or(i64::MAX)
}

#[cfg(test)]
mod tests {
    use super::super::super::memory::cells;
    use super::super::super::samples::{at, MODEL};
    use super::*;

    #[test]
    fn what_goes_in_comes_out() {
        let scale = Scale::new(131_072, 10_000);
        for raw in [-1_000_000, -1, 0, 1, 7, 10_000, 2_000_000_000] {
            assert_eq!(scale.outward(scale.inward(raw)), raw);
        }
        assert_eq!((scale.inward(10_000), scale.inward(-5_000)), (131_072, -65_536));
        assert_eq!(Scale::new(i128::MAX, 3).inward(0), 0);
        assert_eq!(Scale::new(i128::MAX, 1).inward(i64::MAX), i64::MAX);
    }

    #[test]
    fn units_are_those_of_the_objects() {
        let mut cells = [0; cells(&MODEL)];
        let mut memory = Memory::new(&MODEL, &mut cells).unwrap();
        let slots = Slots::of(&memory);
        memory.put(slots.profile_velocity, 10_000);
        memory.put(memory.slot(at(0x6083, 0)), 500);
        let units = Units::of(&memory, &slots, &Config::default());
        assert_eq!(units.position.inward(10_000), 131_072, "10,000 user units a revolution");
        assert_eq!(units.profile_velocity, 131_072 * 256, "a revolution a second");
        assert_eq!(units.max_motor_speed, 50 * 131_072 * 256, "3,000 rpm");
        assert_eq!(
            units.acceleration,
            2_000 * 131_072 / 60 * 2 + 1,
            "2,000 rpm in half a second, rounded down"
        );
        assert_eq!(units.torque_limits, (3_000, 3_000));
        assert_eq!(units.limits, Some((-13_107_200, 13_107_200)));
        assert_eq!(units.following_window, Some(262_144));
        assert_eq!(units.velocity.outward(131_072 * 256), 10_000);
    }
}
