//! What the drive watches: following error, overload, speed.

use core::time::Duration;

use super::super::config::Config;
use super::super::events::Incident;
use super::super::memory::Memory;
use super::super::plant::Plant;
use super::super::slots::Slots;
use super::units::{distance, micros, Units};

/// Rated torque, in 0.1 % of it.
const RATED: i64 = 1_000;

/// What is watched.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Watch {
    /// For how long the following error is too large.
    late: Duration,
    /// The square of the torque above rated torque, times microseconds.
    heat: i64,
    follows: bool,
}

impl Watch {
    /// Whether the following error is within its window.
    pub(super) const fn follows(&self) -> bool {
        self.follows
    }

    /// Looks at the axis after a cycle; `demand` is where it should be, where that is known.
    pub(super) fn step(
        &mut self,
        (memory, slots): (&Memory<'_, '_>, &Slots),
        (config, units): (&Config, &Units),
        (plant, demand): (&Plant, Option<i64>),
        cycle: Duration,
    ) -> Option<Incident> {
        let within = units.following_window.map_or(true, |window| {
            demand.map_or(true, |demand| distance(demand, plant.position()) <= window)
        });
        self.follows = within;
        self.late = if within { Duration::ZERO } else { self.late.saturating_add(cycle) };
        let time = u64::try_from(memory.used(slots.following_time)).unwrap_or(0);
        let late = !within && self.late > Duration::from_millis(time);
        let overspeed = plant.velocity().saturating_abs() / 6 > units.max_motor_speed / 5;
        let overload = self.heats(plant, config, cycle);
        match (late, overload, overspeed) {
            (true, ..) => Some(Incident::FollowingError),
            (_, true, _) => Some(Incident::Overload),
            (.., true) => Some(Incident::Overspeed),
            _ => None,
        }
    }

    /// Whether the motor has become too hot.
    fn heats(&mut self, plant: &Plant, config: &Config, cycle: Duration) -> bool {
        let torque = i64::from(plant.torque());
        let above = torque.saturating_mul(torque).saturating_sub(RATED * RATED);
        self.heat = self.heat.saturating_add(above.saturating_mul(micros(cycle))).max(0);
        let most = micros(config.overload_time).saturating_mul(3 * RATED * RATED);
        let hot = self.heat > most;
        if hot {
            self.heat = most;
        }
        hot
    }
}
