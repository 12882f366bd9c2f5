//! A trajectory generator in integers: where an axis has to be, and how fast, at each moment.
//!
//! Places are in units of the axis, speed in 1/256 unit per second, acceleration in units per square second. A move ends
//! exactly on its target, never goes beyond it and never turns on the way; a target that lies too near to brake for, or
//! behind the axis, is reached after braking to a halt. Each ramp is straight, so a move is a trapezoid or a triangle.
//! Times are rounded up to half microseconds and speeds down, so a ramp is never steeper than asked.
//!
//! ```
//! use core::time::Duration;
//! use drivewright_runtime::sim::planner::{Limits, Planner};
//!
//! let mut planner = Planner::at(0);
//! // 1000 units at 1000 units/s, with ramps of 10,000 units/s²: 0.1 s to be quick, 0.9 s on the way, 0.1 s to brake.
//! planner.move_to(1_000, Limits { velocity: 256 * 1_000, acceleration: 10_000, deceleration: 10_000 });
//! let mut steps = 0;
//! while !planner.done() {
//!     planner.step(Duration::from_millis(1));
//!     steps += 1;
//! }
//! assert_eq!(steps, 1_100);
//! assert_eq!((planner.point().position, planner.point().velocity), (1_000, 0));
//! ```

mod leg;
mod route;
mod slope;
#[cfg(test)]
mod tests;

use core::time::Duration;

pub use slope::Slope;

use super::motion::{self, clamp, SPEED, TOP_ACCELERATION, TOP_SPEED};
use leg::{Leg, Place};

/// How fast a move may be. What is beyond the arithmetic is taken for the nearest that is not.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Limits {
    /// In 1/256 unit per second: 1 to 2^44.
    pub velocity: i64,
    /// To become faster, in units per square second: 1 to 2^40.
    pub acceleration: i64,
    /// To become slower, in units per square second: 1 to 2^40.
    pub deceleration: i64,
}

impl Limits {
    fn clamped(self) -> Self {
        Self {
            velocity: clamp(self.velocity, 1, TOP_SPEED * SPEED),
            acceleration: clamp(self.acceleration, 1, TOP_ACCELERATION),
            deceleration: clamp(self.deceleration, 1, TOP_ACCELERATION),
        }
    }
}

/// A moment of a trajectory.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Point {
    /// In units of the axis, rounded down.
    pub position: i64,
    /// In 1/256 unit per second.
    pub velocity: i64,
    /// In units per square second.
    pub acceleration: i64,
}

/// What the planner is after.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
enum Goal {
    Hold,
    Place(i64, Limits),
    /// As a place, to which a stop leads.
    Stop(i64, Limits),
    Speed(i64, Limits),
}

/// The most legs of a way: ramp, two cruises that differ by the smallest speed, ramp.
const LEGS: usize = 4;

/// A trajectory generator.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Planner {
    place: Place,
    /// 1 or -1: the direction of motion.
    sign: i64,
    /// In 1/256 unit per second, in the direction of motion.
    speed: i64,
    /// Of the speed, in 2^-32 of its unit, and half of one above that: so the speed is rounded to the nearest.
    fraction: i64,
    goal: Goal,
    legs: [Leg; LEGS],
    /// The leg that is on its way; beyond the last where there is none.
    leg: usize,
}

impl Planner {
    /// Holds a place.
    pub const fn at(position: i64) -> Self {
        Self {
            place: Place::at(position),
            sign: 1,
            speed: 0,
            fraction: Leg::HALF,
            goal: Goal::Hold,
            legs: [Leg::NONE; LEGS],
            leg: LEGS,
        }
    }

    /// Takes over a motion: from this place and speed, in 1/256 unit per second, on; it goes on at that speed.
    pub fn seed(&mut self, position: i64, velocity: i64) {
        *self = Self::at(position);
        let velocity = clamp(velocity, -TOP_SPEED * SPEED, TOP_SPEED * SPEED);
        if velocity != 0 {
            self.sign = velocity.signum();
            self.speed = velocity.abs();
            self.goal =
                Goal::Speed(velocity, Limits { velocity: self.speed, acceleration: 1, deceleration: 1 });
            self.follow(&[Leg::endless(self.speed)]);
        }
    }

    /// Moves to a target from wherever the axis is and however fast, at once. The same call again changes nothing.
    pub fn move_to(&mut self, target: i64, limits: Limits) {
        let goal = Goal::Place(target, limits.clamped());
        if goal != self.goal {
            self.goal = goal;
            self.head_for(target, limits.clamped());
        }
    }

    /// Ramps to a speed in 1/256 unit per second and keeps it; the velocity of `limits` does not count. A change of
    /// direction brakes to a halt with the deceleration first. The same call again changes nothing.
    pub fn run_at(&mut self, velocity: i64, limits: Limits) {
        let velocity = clamp(velocity, -TOP_SPEED * SPEED, TOP_SPEED * SPEED);
        let goal = Goal::Speed(velocity, limits.clamped());
        if goal != self.goal {
            self.goal = goal;
            self.speed_up(velocity, limits.clamped());
        }
    }

    /// Brakes with a deceleration in units per square second, to the first whole unit where that is possible. The same
    /// call again changes nothing.
    pub fn stop(&mut self, deceleration: i64) {
        let limits = Limits { velocity: self.speed, acceleration: deceleration, deceleration }.clamped();
        if matches!(self.goal, Goal::Stop(_, own) if own.deceleration == limits.deceleration) {
            return;
        }
        let target = self.halt(limits.deceleration);
        self.goal = Goal::Stop(target, limits);
        self.head_for(target, limits);
    }

    /// Stands at a place from now on, without a way to it.
    pub fn hold(&mut self, position: i64) {
        *self = Self::at(position);
    }

    /// Goes on by a time, rounded down to half microseconds, a second at most; gives where to be then.
    pub fn step(&mut self, dt: Duration) -> Point {
        let mut left = motion::ticks(dt);
        while left > 0 && (self.moves() || self.set_off()) {
            left -= self.run(left);
        }
        self.point()
    }

    /// Where to be now.
    pub fn point(&self) -> Point {
        let acceleration = self.legs.get(self.leg).map_or(0, Leg::acceleration);
        Point {
            position: self.place.unit,
            velocity: self.sign * self.speed,
            acceleration: self.sign * acceleration,
        }
    }

    /// Whether the target, or the speed, is reached. The planner alone says so: the axis may lag behind.
    pub fn done(&self) -> bool {
        match self.goal {
            Goal::Hold => true,
            Goal::Place(target, _) | Goal::Stop(target, _) => {
                !self.moves() && self.place == Place::at(target)
            }
            Goal::Speed(velocity, _) => {
                self.sign * self.speed == velocity && self.legs.get(self.leg).map_or(true, Leg::is_endless)
            }
        }
    }

    /// The target of a move, or where a stop leads.
    pub const fn target(&self) -> Option<i64> {
        match self.goal {
            Goal::Place(target, _) | Goal::Stop(target, _) => Some(target),
            Goal::Hold | Goal::Speed(..) => None,
        }
    }

    /// Whether a leg is on its way.
    fn moves(&self) -> bool {
        self.legs.get(self.leg).is_some_and(|leg| leg.left > 0)
    }

    /// Plans the way that is left after braking; gives whether there is one.
    fn set_off(&mut self) -> bool {
        match self.goal {
            Goal::Place(target, limits) | Goal::Stop(target, limits) if self.place != Place::at(target) => {
                self.head_for(target, limits);
            }
            Goal::Speed(velocity, limits) if self.sign * self.speed != velocity => {
                self.speed_up(velocity, limits);
            }
            _ => {}
        }
        self.moves()
    }

    /// Runs along the present leg, at most so many half microseconds; gives how many.
    fn run(&mut self, most: i64) -> i64 {
        let Some(leg) = self.legs.get_mut(self.leg) else { return most };
        let ticks = most.min(leg.left).min(motion::LONGEST);
        let (to, fraction) = leg.speed_after(self.speed, self.fraction, ticks);
        self.place =
            leg.within(self.place.after(self.sign, i128::from((self.speed + to) * ticks)), self.sign);
        (self.speed, self.fraction) = (to, fraction);
        if leg.ends_after(ticks) {
            self.speed = leg.to;
            self.place = leg.end.unwrap_or(self.place);
            self.leg = self.leg.saturating_add(1);
            self.begin();
        }
        ticks
    }

    /// Goes along these legs from now on.
    fn follow(&mut self, legs: &[Leg]) {
        self.legs = [Leg::NONE; LEGS];
        self.legs.iter_mut().zip(legs).for_each(|(own, leg)| *own = *leg);
        self.leg = 0;
        self.begin();
    }

    /// Takes the speed with which the present leg begins; legs without time are passed over.
    fn begin(&mut self) {
        self.fraction = Leg::HALF;
        while let Some(leg) = self.legs.get(self.leg) {
            if leg.left > 0 {
                self.speed = leg.from;
                return;
            }
            self.leg = self.leg.saturating_add(1);
        }
    }
}
