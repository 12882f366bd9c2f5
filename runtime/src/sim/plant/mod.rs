//! A physical axis with the inner loops of its drive, in integers: equal traces on every host.
//!
//! It has inertia, dry and viscous friction, a load, a torque limit, hard stops without rebound, limit switches, a home
//! switch and the index pulse of the encoder. A step is divided into parts of 1 ms at most, for which the loops are
//! stable. An edge that the axis crosses between two steps is told at its own place, as drive hardware latches it, and
//! all that is crossed in a step is told in the order of the motion, turning points included.
//!
//! The loops feed dry friction forward, with the value of the axis; that keeps the axis from hunting around its target.
//!
//! ```
//! use core::time::Duration;
//! use drivewright_runtime::sim::plant::{Plant, Setpoint};
//!
//! let mut axis = Plant::default();
//! for _ in 0..100 {
//!     axis.step(Setpoint::Position { target: 1_000, velocity: 0, acceleration: 0 }, Duration::from_millis(4));
//! }
//! assert_eq!(axis.position(), 1_000);
//! assert!(axis.standstill());
//! ```

mod config;
mod crossed;
mod drive;
mod switches;
#[cfg(test)]
mod tests;

use core::time::Duration;

pub use config::{ConfigError, Loops, PlantConfig, ASSUMPTIONS};
pub use switches::{Band, Switches};

use super::motion::{self, Motion, PARTS, TOP_ACCELERATION};
use crate::homing::interpreter::{Crossing, Levels};
use crate::homing::Side;
use crossed::Crossed;

/// What the drive is told to do in a step. Speed is in 1/256 count per second, acceleration in counts per square second,
/// torque in 0.1 % of rated. What is beyond the arithmetic is taken for the nearest that is not: 2^53 counts, 2^36 counts
/// per second, 2^40 counts per square second.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Setpoint {
    /// No torque: the axis coasts.
    Off,
    /// Position control.
    Position {
        /// Where to be at the end of the step, in counts.
        target: i64,
        /// How fast to be on the way: feed-forward, 0 if it is not known.
        velocity: i64,
        /// Acceleration on the way: feed-forward, 0 if it is not known.
        acceleration: i64,
    },
    /// Speed control.
    Velocity {
        /// How fast to be.
        velocity: i64,
        /// Acceleration on the way: feed-forward, 0 if it is not known.
        acceleration: i64,
    },
    /// Torque control.
    Torque {
        /// The torque of the motor.
        torque: i32,
    },
}

/// A physical axis with the inner loops of its drive.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Plant {
    config: PlantConfig,
    motion: Motion,
    /// Deceleration by viscous friction for each count per second, in 1/4096 1/s.
    damping: i64,
    /// Torque for each count per square second, in 2^-64 of 0.1 % of rated: what a division would give, but quicker.
    torque_each: i128,
    /// Dry friction and load as accelerations, in counts per square second.
    friction: i64,
    load: i64,
    /// The lowest and the highest acceleration that the torque limits allow.
    allowed: (i64, i64),
    /// Acceleration by the motor in the last part of the step.
    drive: i64,
    /// The integral of the speed loop, in 1/256 count per square second.
    integral: i64,
    /// Up to where nothing is crossed: from the first count, up to but without the second.
    clear: (i64, i64),
    /// What the switches say in that range.
    levels: Levels,
    contact: Option<Side>,
    /// For how long the torque has been at its limit without motion, in half microseconds.
    stalled: i64,
    crossed: Crossed,
}

impl Default for Plant {
    fn default() -> Self {
        Self::of(PlantConfig::default())
    }
}

impl Plant {
    /// An axis that stands at its start, without load, with all of its torque allowed.
    pub fn new(config: PlantConfig) -> Result<Self, ConfigError> {
        config.check()?;
        Ok(Self::of(config))
    }

    fn of(config: PlantConfig) -> Self {
        let mut plant = Self {
            motion: Motion::at(config.start),
            damping: config.damping(),
            friction: acceleration(&config, config.coulomb),
            load: 0,
            allowed: (0, 0),
            drive: 0,
            integral: 0,
            clear: (0, 0),
            levels: Levels::default(),
            torque_each: torque_each(&config),
            contact: None,
            stalled: 0,
            crossed: Crossed::default(),
            config,
        };
        plant.limit_torque(config.torque, config.torque);
        plant.look_around();
        plant
    }

    /// Moves the axis on by a time, rounded down to half microseconds; a second at most.
    pub fn step(&mut self, setpoint: Setpoint, dt: Duration) {
        self.crossed.clear();
        let mut left = motion::ticks(dt);
        while left > 0 {
            let part = left.min(drive::LONGEST);
            self.drive(setpoint, left, part);
            self.push(part);
            self.watch_stall(part);
            left -= part;
        }
    }

    /// Limits the torque of the motor in each direction; both are amounts, in 0.1 % of rated. The motor has no more than
    /// its configuration says; less than nothing is nothing.
    pub fn limit_torque(&mut self, positive: i32, negative: i32) {
        let amount = |torque: i32| acceleration(&self.config, torque.min(self.config.torque).max(0));
        self.allowed = (-amount(negative), amount(positive));
    }

    /// Puts a load on the axis that drives it in positive direction, in 0.1 % of rated torque; -10000 to 10000.
    pub fn set_load(&mut self, torque: i32) {
        self.load = acceleration(&self.config, torque.clamp(-10_000, 10_000));
    }

    /// What the axis is made of.
    pub const fn config(&self) -> &PlantConfig {
        &self.config
    }

    /// What the encoder says, in counts.
    pub const fn position(&self) -> i64 {
        self.motion.count
    }

    /// Speed in 1/256 count per second.
    pub const fn velocity(&self) -> i64 {
        self.motion.speed
    }

    /// Torque of the motor, in 0.1 % of rated.
    pub fn torque(&self) -> i32 {
        let torque = i128::from(self.drive) * self.torque_each + (1 << 63);
        i32::try_from(torque >> 64).unwrap_or(0)
    }

    /// What the switches say, and whether the axis stands.
    pub fn levels(&self) -> Levels {
        Levels { standstill: self.standstill(), ..self.levels }
    }

    /// Whether the axis stands: it is not faster than the configuration says.
    pub const fn standstill(&self) -> bool {
        self.motion.speed.unsigned_abs() <= self.config.standstill.unsigned_abs()
    }

    /// For how long the torque has been at a limit without motion.
    pub fn stalled(&self) -> Duration {
        Duration::from_nanos(self.stalled.unsigned_abs().saturating_mul(500))
    }

    /// The hard stop that the axis touches.
    pub const fn contact(&self) -> Option<Side> {
        self.contact
    }

    /// In which direction the motor drives; positive without torque.
    pub const fn driven(&self) -> Side {
        if self.drive < 0 {
            Side::Negative
        } else {
            Side::Positive
        }
    }

    /// What was crossed in the last step, in the order of the motion; the first eight of it.
    pub fn crossings(&self) -> &[Crossing] {
        self.crossed.all()
    }

    /// Whether more was crossed in the last step than [`Self::crossings`] holds.
    pub const fn crossed_more(&self) -> bool {
        self.crossed.more()
    }

    /// What the motor, the load and friction do to the axis.
    fn push(&mut self, ticks: i64) {
        let from = self.motion.speed;
        let damping = ((from >> 4) * self.damping) >> 16;
        let free = motion::clamp(self.drive + self.load - damping, -TOP_ACCELERATION, TOP_ACCELERATION);
        let against = if from == 0 { free } else { from };
        if from == 0 && free.abs() <= self.friction {
            self.motion.rest();
            return;
        }
        self.motion.faster(free - self.friction * against.signum(), ticks);
        let to = self.motion.speed;
        if from.signum() * to.signum() < 0 {
            self.turn(from, to, free, ticks);
        } else {
            self.motion.travel(from, to, ticks);
            self.moved();
        }
    }

    /// Motion that comes to a halt within the time, and may go on in the other direction.
    fn turn(&mut self, from: i64, to: i64, free: i64, ticks: i64) {
        let until = (ticks * from.abs()).checked_div(from.abs() + to.abs()).unwrap_or(ticks);
        self.motion.rest();
        self.motion.travel(from, 0, until);
        self.moved();
        if free.abs() > self.friction && until < ticks {
            self.motion.faster(free - self.friction * free.signum(), ticks - until);
            self.motion.travel(0, self.motion.speed, ticks - until);
            self.moved();
        }
    }

    /// Keeps the axis between its hard stops, and tells what it has crossed.
    fn moved(&mut self) {
        let (low, high) = (self.config.lower_stop, self.config.upper_stop);
        self.contact = None;
        if self.motion.count > high {
            self.motion.stand(high, PARTS - 1);
            self.contact = Some(Side::Positive);
        } else if self.motion.count < low {
            self.motion.stand(low, 0);
            self.contact = Some(Side::Negative);
        }
        if self.motion.count < self.clear.0 || self.motion.count >= self.clear.1 {
            self.cross();
        }
    }

    /// Tells all edges and pulses between the range that was clear and the place where the axis is.
    fn cross(&mut self) {
        let (count, switches) = (self.motion.count, self.config.switches);
        while count >= self.clear.1 && !self.crossed.more() {
            let edge = self.clear.1;
            self.crossed.add(switches.crossings(edge, Side::Positive));
            self.clear = (edge, switches.above(edge).unwrap_or(i64::MAX));
        }
        while count < self.clear.0 && !self.crossed.more() {
            let edge = self.clear.0;
            self.crossed.add(switches.crossings(edge, Side::Negative));
            self.clear = (switches.below(edge.saturating_sub(1)).unwrap_or(i64::MIN), edge);
        }
        self.look_around();
    }

    /// Finds up to where nothing is crossed.
    fn look_around(&mut self) {
        let (count, switches) = (self.motion.count, &self.config.switches);
        self.clear = (switches.below(count).unwrap_or(i64::MIN), switches.above(count).unwrap_or(i64::MAX));
        self.levels = switches.levels(count);
    }

    fn watch_stall(&mut self, ticks: i64) {
        let (low, high) = self.allowed;
        let at_limit = self.drive != 0 && (self.drive <= low || self.drive >= high);
        self.stalled = if at_limit && self.standstill() { self.stalled.saturating_add(ticks) } else { 0 };
    }
}

/// What a torque does to the axis, in counts per square second.
fn acceleration(config: &PlantConfig, torque: i32) -> i64 {
    i64::from(torque) * config.acceleration / 1_000
}

/// What acceleration says of torque, rounded up so that a whole torque comes back whole.
fn torque_each(config: &PlantConfig) -> i128 {
    (1_000_i128 << 64).checked_div(i128::from(config.acceleration)).map_or(0, |each| each.saturating_add(1))
}
