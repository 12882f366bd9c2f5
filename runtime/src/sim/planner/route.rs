//! Finds the legs of a way.

use core::cmp::Ordering;

use super::leg::{Leg, Place};
use super::{Limits, Planner};
use crate::sim::motion::{PARTS, SPEED, TICKS};

impl Planner {
    /// Finds the way to a target from here.
    pub(super) fn head_for(&mut self, target: i64, limits: Limits) {
        let to_go = self.place.to(target);
        let ahead = match to_go.cmp(&0) {
            Ordering::Less => -1,
            Ordering::Equal => self.sign,
            Ordering::Greater => 1,
        };
        let length = to_go.abs();
        if self.speed > 0 && (ahead != self.sign || !can_stop(self.speed, length, limits.deceleration)) {
            self.brake(limits.deceleration);
            return;
        }
        self.sign = ahead;
        if length == 0 {
            self.speed = 0;
            self.follow(&[]);
            return;
        }
        let legs = way(self.speed, length, limits);
        let mut end = self.place;
        let ended = legs.map(|leg| {
            end = end.after(ahead, leg.length());
            leg.ending(end)
        });
        let [first, second, third, last] = ended;
        self.follow(&[first, second, third, last.ending(Place::at(target))]);
    }

    /// Finds the way to a speed.
    pub(super) fn speed_up(&mut self, velocity: i64, limits: Limits) {
        if self.speed > 0 && velocity.signum() * self.sign <= 0 {
            self.brake(limits.deceleration);
            return;
        }
        if velocity == 0 {
            self.follow(&[]);
            return;
        }
        self.sign = velocity.signum();
        let leg = Leg::new(self.speed, velocity.abs(), ramp(self.speed, velocity.abs(), limits));
        let end = self.place.after(self.sign, leg.length());
        self.follow(&[leg.ending(end), Leg::endless(velocity.abs())]);
    }

    /// Brakes to a halt; the rest of the way is found there.
    fn brake(&mut self, deceleration: i64) {
        let leg = Leg::new(self.speed, 0, ramp_ticks(self.speed, deceleration));
        let end = self.place.after(self.sign, leg.length());
        self.follow(&[leg.ending(end)]);
    }

    /// The first whole unit at which the axis can halt.
    pub(super) fn halt(&self, deceleration: i64) -> i64 {
        let length = i128::from(self.speed) * i128::from(ramp_ticks(self.speed, deceleration));
        let end = self.place.after(self.sign, length);
        if self.sign > 0 && end.part > 0 {
            end.unit.saturating_add(1)
        } else {
            end.unit
        }
    }
}

/// Half microseconds in which a speed is gained or lost, rounded up.
fn ramp_ticks(speed: i64, acceleration: i64) -> i64 {
    let per_second = i128::from(acceleration.max(1)) * i128::from(SPEED);
    let ticks = (i128::from(speed) * i128::from(TICKS) + per_second - 1).checked_div(per_second);
    ticks.and_then(|ticks| i64::try_from(ticks).ok()).unwrap_or(i64::MAX - 1)
}

/// Half microseconds from one speed to another.
fn ramp(from: i64, to: i64, limits: Limits) -> i64 {
    let rate = if to > from { limits.acceleration } else { limits.deceleration };
    ramp_ticks((to - from).abs(), rate)
}

/// Whether the axis can halt within a length. The speed may be rounded up, and a ramp too: without room for that, an axis
/// that brakes for its target could not be sent to it again.
fn can_stop(speed: i64, length: i128, deceleration: i64) -> bool {
    let at_least = (speed - 2).max(0);
    let braking = i128::from(at_least) * i128::from(ramp_ticks(at_least, deceleration));
    braking <= length + 4 * i128::from(speed)
}

/// Ramp, cruise at two speeds that differ by the smallest step, and ramp to a halt, of this length in all.
fn way(from: i64, length: i128, limits: Limits) -> [Leg; 4] {
    let top = top_speed(from, length, limits);
    let up = ramp(from, top, limits).max(1);
    let down = ramp_ticks(top, limits.deceleration).max(1);
    let ramps = i128::from(from + top) * i128::from(up) + i128::from(top) * i128::from(down);
    let cruise = (length - ramps).max(0);
    let twice = 2 * i128::from(top.max(1));
    let cruise = cruise.saturating_add(twice - 1).checked_div(twice).unwrap_or(0);
    // The top speed at which the whole time, rounded up, covers the length: not above the one asked for.
    let time = i128::from(up) + 2 * cruise + i128::from(down);
    let first = i128::from(from) * i128::from(up);
    let left = (length - first).max(0);
    let even = left.checked_div(time).unwrap_or(0);
    // What the rounding of this speed leaves is covered by a part of the cruise that is one step faster.
    let quick = ((left - even * time) / 2).min(cruise);
    let even = i64::try_from(even).unwrap_or(0).min(top);
    let short = |ticks: i128| i64::try_from(ticks).unwrap_or(i64::MAX - 1);
    [
        Leg::new(from, even, up),
        Leg::new(even + 1, even + 1, short(quick)),
        Leg::new(even, even, short(cruise - quick)),
        Leg::new(even, 0, down),
    ]
}

/// The speed that a way comes to, rounded.
fn top_speed(from: i64, length: i128, limits: Limits) -> i64 {
    let wanted = limits.velocity;
    let up = i128::from(ramp(from, wanted, limits));
    let down = i128::from(ramp_ticks(wanted, limits.deceleration));
    let needed = i128::from(from + wanted) * up + i128::from(wanted) * down;
    if needed <= length {
        return wanted;
    }
    if from >= wanted {
        return from;
    }
    triangle(from, length, limits).max(from).max(1).min(wanted)
}

/// The speed at which a triangle changes from one ramp to the other. With `h = a d / (a + d)` it is
/// `v² = 2 h length + from² h / a`; for speeds in 1/256 and lengths in parts, `2 length` becomes `2 length / 15625`.
fn triangle(from: i64, length: i128, limits: Limits) -> i64 {
    const UNITS: i128 = PARTS as i128 / (SPEED * SPEED) as i128;
    let (a, d) = (i128::from(limits.acceleration), i128::from(limits.deceleration));
    // In 2^-16.
    let both = ((a * d) << 16).checked_div(a + d).unwrap_or(0);
    let way = (length.saturating_mul(both * 2) / UNITS) >> 16;
    let had = (i128::from(from) * i128::from(from)).checked_mul(d).and_then(|e| e.checked_div(a + d));
    let square = way.saturating_add(had.unwrap_or(0));
    i64::try_from(root(square.unsigned_abs())).unwrap_or(i64::MAX)
}

/// The square root, rounded down.
fn root(square: u128) -> u128 {
    let mut guess = 1_u128 << ((128 - square.leading_zeros()).div_ceil(2));
    loop {
        let next = (guess + square.checked_div(guess).unwrap_or(0)) / 2;
        if next >= guess {
            return guess;
        }
        guess = next;
    }
}
