//! Random numbers for tests: the same on every host and in every run.

use core::time::Duration;

/// A linear congruential generator with the constants of Knuth's MMIX.
pub(super) struct Lcg(u64);

impl Lcg {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 16
    }

    /// A number from `low` to `high`.
    pub(super) fn between(&mut self, low: i64, high: i64) -> i64 {
        let width = u64::try_from(high - low).unwrap() + 1;
        low + i64::try_from(self.next() % width).unwrap()
    }

    /// 1 or -1.
    pub(super) fn sign(&mut self) -> i64 {
        self.between(0, 1) * 2 - 1
    }

    /// A step from 62.5 µs to 4 ms.
    pub(super) fn step(&mut self) -> Duration {
        Duration::from_nanos(62_500 << self.between(0, 6))
    }
}
