//! The inner loops of the drive: position, speed and torque limit.

use super::{acceleration, Plant, Setpoint};
use crate::sim::motion::{clamp, PARTS, SPEED, TICKS, TOP_ACCELERATION, TOP_SPEED};

/// The longest time for which the loops are stable, in half microseconds: 1 ms.
pub(super) const LONGEST: i64 = 2_000;

/// The highest speed, in 1/256 count per second.
const FASTEST: i64 = TOP_SPEED * SPEED;

/// The farthest target, in counts.
const FARTHEST: i64 = 1 << 53;

impl Plant {
    /// Sets the acceleration by the motor for the next part of a step; `left` of the step is left.
    pub(super) fn drive(&mut self, setpoint: Setpoint, left: i64, part: i64) {
        match setpoint {
            Setpoint::Off => self.open(0),
            Setpoint::Torque { torque } => {
                self.open(acceleration(&self.config, torque.clamp(-10_000, 10_000)));
            }
            Setpoint::Velocity { velocity, acceleration } => {
                self.close(clamp(velocity, -FASTEST, FASTEST), acceleration, part);
            }
            Setpoint::Position { target, velocity, acceleration } => {
                let velocity = clamp(velocity, -FASTEST, FASTEST);
                let wanted = velocity + self.correction(target, velocity, left);
                self.close(clamp(wanted, -FASTEST, FASTEST), acceleration, part);
            }
        }
    }

    /// Without a loop. The integral follows, so that closing the loop later makes no jump.
    fn open(&mut self, wanted: i64) {
        self.drive = clamp(wanted, self.allowed.0, self.allowed.1);
        self.integral = self.drive * SPEED;
    }

    /// Speed by which the position loop wants to be faster. It aims at the middle of a count and is content within it.
    fn correction(&self, target: i64, velocity: i64, left: i64) -> i64 {
        let to_go = velocity.saturating_mul(left) / TICKS;
        let place = self.motion.part / (PARTS / SPEED);
        let error =
            (clamp(target, -FARTHEST, FARTHEST) - self.motion.count) * SPEED + SPEED / 2 - place - to_go;
        if error.abs() < SPEED / 2 {
            return 0;
        }
        clamp(error, -FASTEST, FASTEST) * self.config.loops.position
    }

    /// The speed loop: proportional, integral, acceleration and dry friction fed forward.
    fn close(&mut self, wanted: i64, ahead: i64, ticks: i64) {
        let error = wanted - self.motion.speed;
        let at_once = clamp(error * self.config.loops.speed / SPEED, -TOP_ACCELERATION, TOP_ACCELERATION);
        let motion = if self.motion.speed == 0 { wanted } else { self.motion.speed };
        let ahead = clamp(ahead, -TOP_ACCELERATION, TOP_ACCELERATION) + self.friction * motion.signum();
        self.release(at_once);
        let sum = at_once + self.integral / SPEED + ahead;
        self.drive = clamp(sum, self.allowed.0, self.allowed.1);
        // No more of the integral while the torque is at the limit that it drives to.
        if (sum - self.drive).signum() * at_once.signum() <= 0 {
            let more = at_once * self.config.loops.integral * ticks * 2 / (TICKS * 2 / SPEED);
            self.integral = clamp(self.integral + more, self.allowed.0 * SPEED, self.allowed.1 * SPEED);
        }
    }

    /// Drops an integral that presses against a hard stop which the axis is to leave.
    fn release(&mut self, at_once: i64) {
        let leaves = |side: crate::homing::Side| match side {
            crate::homing::Side::Negative => at_once > 0 && self.integral < 0,
            crate::homing::Side::Positive => at_once < 0 && self.integral > 0,
        };
        if self.contact.is_some_and(leaves) {
            self.integral = 0;
        }
    }
}
