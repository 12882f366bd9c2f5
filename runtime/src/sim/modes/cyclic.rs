//! Cyclic synchronous position: targets that come every bus cycle, joined by straight lines in the cycles of the drive.

use core::time::Duration;

use super::units::{distance, micros};

/// The most cycles of the drive in one of the bus.
const LONGEST: i64 = 64;

/// The line between two targets, in counts of the axis.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Cyclic {
    from: i64,
    to: i64,
    /// Cycles of the drive since the last target.
    gone: i64,
    /// Cycles of the drive that the line takes.
    length: i64,
    fresh: bool,
}

/// A place on the line: where to be, and how fast in 1/256 count per second.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Waypoint {
    pub(super) position: i64,
    pub(super) velocity: i64,
}

impl Cyclic {
    /// Stands at a place.
    pub(super) const fn at(position: i64) -> Self {
        Self { from: position, to: position, gone: 0, length: 1, fresh: true }
    }

    /// Data came from the bus.
    pub(super) fn data(&mut self) {
        self.fresh = true;
    }

    /// Whether data came since the last cycle.
    pub(super) const fn is_fresh(&self) -> bool {
        self.fresh
    }

    /// The target before the next one.
    pub(super) const fn last(&self) -> i64 {
        self.to
    }

    /// Takes a target; the line to it is as long as the one before took.
    pub(super) fn target(&mut self, to: i64) {
        let length = self.gone.clamp(1, LONGEST);
        *self = Self { from: self.to, to, gone: 0, length, fresh: false };
    }

    /// How far the next line may be at a speed, in counts.
    pub(super) fn reach(&self, velocity: i64, cycle: Duration) -> i64 {
        let time = micros(cycle).saturating_mul(self.gone.clamp(1, LONGEST));
        let way = i128::from(velocity) * i128::from(time) / 256_000_000;
        i64::try_from(way).unwrap_or(i64::MAX).saturating_add(1)
    }

    /// The next cycle of the drive.
    pub(super) fn step(&mut self, cycle: Duration) -> Waypoint {
        self.gone = self.gone.saturating_add(1);
        if self.gone > self.length {
            return Waypoint { position: self.to, velocity: 0 };
        }
        let way = self.to.saturating_sub(self.from);
        let part = way.saturating_mul(self.gone).checked_div(self.length).unwrap_or(way);
        let time = micros(cycle).saturating_mul(self.length);
        let velocity = way.saturating_mul(256_000_000).checked_div(time).unwrap_or(0);
        Waypoint { position: self.from.saturating_add(part), velocity }
    }

    /// Whether a target is farther from the one before than it may be.
    pub(super) fn jumps(&self, to: i64, most: i64) -> bool {
        distance(to, self.to) > most
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MS: Duration = Duration::from_millis(1);

    #[test]
    fn a_line_takes_as_long_as_a_bus_cycle() {
        let mut line = Cyclic::at(0);
        line.target(0);
        for _ in 0..4 {
            line.step(MS);
        }
        assert_eq!(line.reach(256_000, MS), 5, "a count a millisecond");
        line.target(40);
        let places: std::vec::Vec<i64> = (0..5).map(|_| line.step(MS).position).collect();
        assert_eq!(places, [10, 20, 30, 40, 40]);
        assert!(line.jumps(46, 5) && !line.jumps(45, 5));
    }

    #[test]
    fn the_speed_is_that_of_the_line() {
        let mut line = Cyclic::at(0);
        line.target(10);
        assert_eq!(line.step(MS), Waypoint { position: 10, velocity: 2_560_000 });
        assert_eq!(line.step(MS), Waypoint { position: 10, velocity: 0 }, "nothing came");
    }
}
