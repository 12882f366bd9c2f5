//! A value that follows its target at a limited rate: torque by its slope, 6087h.

use core::time::Duration;

use crate::sim::motion::{self, clamp, TICKS};

/// A value that follows its target.
///
/// ```
/// use core::time::Duration;
/// use drivewright_runtime::sim::planner::Slope;
///
/// let mut torque = Slope::at(0);
/// // 0.1 % of rated each: 10 % with a slope of 100 % in a second lasts for 100 ms.
/// for _ in 0..99 {
///     torque.step(100, 1_000, Duration::from_millis(1));
/// }
/// assert_eq!(torque.value(), 99);
/// assert_eq!(torque.step(100, 1_000, Duration::from_millis(1)), 100);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Slope {
    value: i32,
    /// What the last division left over.
    rest: i64,
}

impl Slope {
    /// Starts with a value.
    pub const fn at(value: i32) -> Self {
        Self { value, rest: 0 }
    }

    /// The value now.
    pub const fn value(&self) -> i32 {
        self.value
    }

    /// Whether the value is there.
    pub const fn done(&self, target: i32) -> bool {
        self.value == target
    }

    /// Goes on by a time, rounded down to half microseconds, a second at most; `rate` is the most that the value changes in
    /// a second. At a rate of 0 or less it stays.
    pub fn step(&mut self, target: i32, rate: i64, dt: Duration) -> i32 {
        let sum = clamp(rate, 0, 1 << 40) * motion::ticks(dt) + self.rest;
        let change = sum / TICKS;
        let to_go = i64::from(target) - i64::from(self.value);
        let arrives = to_go.abs() <= change;
        self.rest = if arrives { 0 } else { sum % TICKS };
        let value = if arrives { i64::from(target) } else { i64::from(self.value) + change * to_go.signum() };
        self.value = i32::try_from(value).unwrap_or(target);
        self.value
    }
}
