//! Chance that is the same in every run.

/// A sequence that is the same in every run.
pub struct Dice(pub u64);

impl Dice {
    /// The next number below `n`.
    ///
    /// # Panics
    ///
    /// Where `n` is 0.
    pub fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap_or_default() % n
    }
}
