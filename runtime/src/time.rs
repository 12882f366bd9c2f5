//! Time as it is injected: moments on a clock that the caller owns.

use core::time::Duration;

/// A moment: microseconds since a start that the caller chooses. A `u64` of them lasts for half a million years.
///
/// ```
/// use core::time::Duration;
/// use drivewright_runtime::time::Instant;
///
/// let start = Instant::from_micros(250);
/// let later = start.after(Duration::from_millis(1));
/// assert_eq!(later.micros(), 1_250);
/// assert_eq!(later.since(start), Duration::from_millis(1));
/// assert_eq!(start.since(later), Duration::ZERO, "what lies ahead is not negative time");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Instant(u64);

impl Instant {
    /// The start of the clock.
    pub const START: Self = Self(0);

    /// So many microseconds after the start of the clock.
    pub const fn from_micros(micros: u64) -> Self {
        Self(micros)
    }

    /// Microseconds since the start of the clock.
    pub const fn micros(self) -> u64 {
        self.0
    }

    /// How long ago `earlier` was; nothing if it lies ahead.
    pub const fn since(self, earlier: Self) -> Duration {
        Duration::from_micros(self.0.saturating_sub(earlier.0))
    }

    /// So much later; the end of the clock at most.
    #[must_use]
    pub const fn after(self, span: Duration) -> Self {
        Self(self.0.saturating_add(micros(span)))
    }
}

/// A span in microseconds, rounded down; `u64::MAX` at most.
pub const fn micros(span: Duration) -> u64 {
    span.as_secs().saturating_mul(1_000_000).saturating_add(span.subsec_micros() as u64)
}
