//! Motion in integers: what an acceleration does to speed and place in a time, with nothing lost to rounding on the way.
//!
//! Time is counted in half microseconds, so that 62.5 µs is a whole number. Speed is counted in 1/256 of a count per
//! second, place in whole counts and a fraction of 1/1,024,000,000: speed times time is a whole number of those. What a
//! division leaves over is carried to the next step.

use core::time::Duration;

/// Half microseconds in a second.
pub(super) const TICKS: i64 = 2_000_000;

/// The longest step that the arithmetic takes at once, in half microseconds: 4 ms.
pub(super) const LONGEST: i64 = 8_000;

/// 1/256 of a count per second.
pub(super) const SPEED: i64 = 256;

/// Parts of a count: half a part of speed for half a microsecond makes one of them.
pub(super) const PARTS: i64 = 2 * TICKS * SPEED;

/// The highest speed, in counts per second.
pub(super) const TOP_SPEED: i64 = 1 << 36;

/// The highest acceleration, in counts per square second.
pub(super) const TOP_ACCELERATION: i64 = 1 << 40;

/// The most that a call simulates, in half microseconds: a second.
const CALL: i64 = TICKS;

/// A span in half microseconds, rounded down; a second at most.
pub(super) fn ticks(span: Duration) -> i64 {
    if span.as_secs() > 0 {
        return CALL;
    }
    i64::from(span.subsec_nanos() / 500)
}

/// Where something is and how fast it moves.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) struct Motion {
    /// In whole counts, rounded down.
    pub(super) count: i64,
    /// What is above that, from 0 to below [`PARTS`].
    pub(super) part: i64,
    /// In 1/256 count per second.
    pub(super) speed: i64,
    /// What the last division of an acceleration left over, from 0 to below [`TICKS`].
    rest: i64,
}

impl Motion {
    pub(super) const fn at(count: i64) -> Self {
        Self { count, part: 0, speed: 0, rest: 0 }
    }

    /// The speed after an acceleration in counts per square second for a time.
    pub(super) fn faster(&mut self, acceleration: i64, ticks: i64) {
        let gain = acceleration * SPEED * ticks + self.rest;
        self.speed = clamp(self.speed + gain.div_euclid(TICKS), -TOP_SPEED * SPEED, TOP_SPEED * SPEED);
        self.rest = gain.rem_euclid(TICKS);
    }

    /// The place after a time in which the speed went from one to the other, evenly.
    pub(super) fn travel(&mut self, from: i64, to: i64, ticks: i64) {
        self.shift((from + to) * ticks);
    }

    /// The place so many parts further.
    pub(super) fn shift(&mut self, parts: i64) {
        let sum = self.part + parts;
        self.count = self.count.saturating_add(sum.div_euclid(PARTS));
        self.part = sum.rem_euclid(PARTS);
    }

    /// Stands still where it is.
    pub(super) fn rest(&mut self) {
        self.speed = 0;
        self.rest = 0;
    }

    /// Stands still at a place.
    pub(super) fn stand(&mut self, count: i64, part: i64) {
        self.count = count;
        self.part = part;
        self.rest();
    }
}

/// `Ord::clamp` for constants.
pub(super) const fn clamp(value: i64, low: i64, high: i64) -> i64 {
    if value < low {
        low
    } else if value > high {
        high
    } else {
        value
    }
}
