//! What the axis does, in the entries that show it.

use crate::homing::interpreter::Levels;

use super::super::memory::Memory;
use super::super::number::{bits, extend};
use super::super::plant::Plant;
use super::super::slots::Slots;
use super::units::{Scale, Units};

/// Where the axis should be, and how.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Demand {
    /// In counts of the axis.
    pub(super) position: i64,
    /// In 1/256 count per second.
    pub(super) velocity: i64,
    /// In 0.1 % of rated.
    pub(super) torque: i64,
}

/// A number and what it is in the unit of the dictionary: a division is only done where the number has changed.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
struct Shown {
    number: i64,
    shown: i64,
}

impl Shown {
    fn of(&mut self, scale: Scale, number: i64) -> i64 {
        if self.number != number {
            *self = Self { number, shown: extend(bits(scale.outward(number)), 32, true) };
        }
        self.shown
    }
}

/// What was shown last.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Report {
    demand: Shown,
    actual: Shown,
    error: Shown,
    velocity_demand: Shown,
    velocity: Shown,
    torque_demand: Shown,
    torque: Shown,
}

impl Report {
    /// Writes what is seen of the axis; `origin` is the count at which the position is 0.
    pub(super) fn write(
        &mut self,
        memory: &mut Memory<'_, '_>,
        slots: &Slots,
        units: &Units,
        (plant, demand, origin): (&Plant, &Demand, i64),
    ) {
        let wrapped = |number: i64| extend(bits(number), 32, true);
        let actual = plant.position().saturating_sub(origin);
        let wanted = demand.position.saturating_sub(origin);
        memory.put(slots.position_demand, self.demand.of(units.position, wanted));
        memory.put(slots.position_demand_counts, wrapped(wanted));
        memory.put(slots.position, self.actual.of(units.position, actual));
        memory.put(slots.position_counts, wrapped(actual));
        memory.put(slots.following_error, self.error.of(units.position, wanted.saturating_sub(actual)));
        memory.put(slots.velocity_demand, self.velocity_demand.of(units.velocity, demand.velocity));
        memory.put(slots.velocity, self.velocity.of(units.velocity, plant.velocity()));
        let torque = self.torque.of(units.torque, i64::from(plant.torque()));
        memory.put(slots.torque_demand, self.torque_demand.of(units.torque, demand.torque));
        memory.put(slots.torque, torque);
        memory.put(slots.current, torque);
        if slots.digital_inputs.exists() {
            memory.put(slots.digital_inputs, inputs(plant.levels()));
        }
    }
}

/// 60FDh: negative limit, positive limit, home switch.
fn inputs(levels: Levels) -> i64 {
    i64::from(levels.negative_limit) | i64::from(levels.positive_limit) << 1 | i64::from(levels.home) << 2
}
