//! A leg of a way: a time in which the speed goes evenly from one value to another.

use crate::sim::motion::{PARTS, SPEED, TICKS, TOP_SPEED};

/// A place: whole units and parts of one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) struct Place {
    pub(super) unit: i64,
    /// From 0 to below [`PARTS`].
    pub(super) part: i64,
}

impl Place {
    pub(super) const fn at(unit: i64) -> Self {
        Self { unit, part: 0 }
    }

    /// The place so many parts further in a direction; the end of the numbers at most.
    pub(super) fn after(self, sign: i64, parts: i128) -> Self {
        let sum = i128::from(self.part) + parts * i128::from(sign);
        // The division of short numbers is the quick one, and nearly all are short.
        if let Ok(sum) = i64::try_from(sum) {
            return Self {
                unit: self.unit.saturating_add(sum.div_euclid(PARTS)),
                part: sum.rem_euclid(PARTS),
            };
        }
        let units = sum.div_euclid(i128::from(PARTS));
        let part = i64::try_from(sum.rem_euclid(i128::from(PARTS))).unwrap_or(0);
        let far = if units < 0 { i64::MIN } else { i64::MAX };
        Self { unit: self.unit.saturating_add(i64::try_from(units).unwrap_or(far)), part }
    }

    /// From here to a whole unit, in parts.
    pub(super) fn to(self, unit: i64) -> i128 {
        (i128::from(unit) - i128::from(self.unit)) * i128::from(PARTS) - i128::from(self.part)
    }
}

/// A leg. Speeds are in the direction of motion.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) struct Leg {
    /// How long it goes on, in half microseconds.
    pub(super) left: i64,
    pub(super) from: i64,
    pub(super) to: i64,
    /// What the speed gains in half a microsecond, in 2^-32 of its unit.
    slope: i64,
    /// Where it ends; `None` where that does not matter.
    pub(super) end: Option<Place>,
}

impl Leg {
    /// Half a unit of speed, in 2^-32.
    pub(super) const HALF: i64 = 1 << 31;

    pub(super) const NONE: Self = Self { left: 0, from: 0, to: 0, slope: 0, end: None };

    pub(super) fn new(from: i64, to: i64, ticks: i64) -> Self {
        let slope = (i128::from(to - from) << 32).checked_div(i128::from(ticks)).unwrap_or(0);
        Self { left: ticks, from, to, slope: i64::try_from(slope).unwrap_or(0), end: None }
    }

    pub(super) const fn endless(speed: i64) -> Self {
        Self { left: i64::MAX, from: speed, to: speed, slope: 0, end: None }
    }

    pub(super) const fn is_endless(&self) -> bool {
        self.left == i64::MAX
    }

    pub(super) const fn ending(mut self, end: Place) -> Self {
        self.end = Some(end);
        self
    }

    /// What it covers, in parts.
    pub(super) fn length(&self) -> i128 {
        i128::from(self.from + self.to) * i128::from(self.left)
    }

    /// In units per square second.
    pub(super) fn acceleration(&self) -> i64 {
        let gain = i128::from(self.slope) * i128::from(TICKS / SPEED * 2 + 1) / 2;
        i64::try_from((gain + i128::from(Self::HALF)) >> 32).unwrap_or(0)
    }

    /// Speed and its fraction after a time.
    pub(super) fn speed_after(&self, speed: i64, fraction: i64, ticks: i64) -> (i64, i64) {
        let sum = i128::from(self.slope) * i128::from(ticks) + i128::from(fraction);
        let gain = i64::try_from(sum >> 32).unwrap_or(0);
        let fraction = i64::try_from(sum & 0xFFFF_FFFF).unwrap_or(0);
        ((speed + gain).clamp(0, TOP_SPEED * SPEED), fraction)
    }

    /// A place, or the end of the leg if that is before it.
    pub(super) fn within(&self, place: Place, sign: i64) -> Place {
        match self.end {
            Some(end) if sign > 0 => place.min(end),
            Some(end) => place.max(end),
            None => place,
        }
    }

    /// Takes time off; gives whether none is left.
    pub(super) fn ends_after(&mut self, ticks: i64) -> bool {
        if !self.is_endless() {
            self.left -= ticks;
        }
        self.left == 0
    }
}
