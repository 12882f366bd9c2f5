//! Touch probe, 60B8h and 60B9h: the place of the axis at an index pulse or at an edge of an input.

use crate::homing::interpreter::Crossing;
use crate::homing::Event;

use super::super::memory::{Memory, Slot};
use super::super::number::low16;
use super::super::slots::Slots;
use super::units::Scale;

/// Bits of one probe, those of the second are eight higher.
mod bit {
    /// It is on.
    pub(super) const ON: u16 = 1;
    /// It latches every event, not the first only.
    pub(super) const CONTINUOUS: u16 = 1 << 1;
    /// It waits for the index pulse, not for its input.
    pub(super) const INDEX: u16 = 1 << 2;
    /// It latches at the rising edge.
    pub(super) const RISING: u16 = 1 << 4;
    /// It latches at the falling edge.
    pub(super) const FALLING: u16 = 1 << 5;
    /// Status: a place is latched at the rising edge.
    pub(super) const HAS_RISING: u16 = 1 << 1;
    /// Status: a place is latched at the falling edge.
    pub(super) const HAS_FALLING: u16 = 1 << 2;
    /// Status: the trigger is the index pulse.
    pub(super) const BY_INDEX: u16 = 1 << 6;
    /// Status: changes with every place that is latched.
    pub(super) const TOGGLE: u16 = 1 << 7;
}

/// A probe.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
struct Probe {
    status: u16,
    level: bool,
    was: bool,
}

/// Both probes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Probes {
    probes: [Probe; 2],
}

/// What the axis has done in a cycle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passed<'a> {
    pub(super) crossings: &'a [Crossing],
    pub(super) position: i64,
    /// The count at which the position is 0.
    pub(super) origin: i64,
    pub(super) scale: Scale,
}

impl Probes {
    /// Sets the input of a probe: 0 or 1.
    pub(super) fn set(&mut self, probe: usize, level: bool) {
        if let Some(probe) = self.probes.get_mut(probe) {
            probe.level = level;
        }
    }

    /// Looks at what happened in a cycle.
    pub(super) fn step(&mut self, memory: &mut Memory<'_, '_>, slots: &Slots, passed: &Passed<'_>) {
        if !slots.probe_status.exists() {
            return;
        }
        let function = low16(memory.used(slots.probe_function));
        let [first, second] = &mut self.probes;
        first.step(memory, function, passed, (slots.probe_1_rising, slots.probe_1_falling));
        second.step(memory, function >> 8, passed, (slots.probe_2_rising, slots.probe_2_falling));
        memory.put(slots.probe_status, i64::from(first.status | second.status << 8));
    }
}

impl Probe {
    fn step(&mut self, memory: &mut Memory<'_, '_>, function: u16, passed: &Passed<'_>, slots: (Slot, Slot)) {
        let (rises, falls) = (self.level && !self.was, !self.level && self.was);
        self.was = self.level;
        if function & bit::ON == 0 {
            self.status = 0;
            return;
        }
        let source = if function & bit::INDEX != 0 { bit::BY_INDEX } else { 0 };
        self.status = self.status & !bit::BY_INDEX | bit::ON | source;
        let index = passed.crossings.iter().find(|crossing| crossing.event == Event::Index);
        let edges = [
            (bit::RISING, bit::HAS_RISING, rises, slots.0),
            (bit::FALLING, bit::HAS_FALLING, falls, slots.1),
        ];
        for (wanted, has, happens, slot) in edges {
            let place =
                if source == 0 { happens.then_some(passed.position) } else { index.map(|at| at.position) };
            let free = function & bit::CONTINUOUS != 0 || self.status & has == 0;
            if let Some(place) = place.filter(|_| free && function & wanted != 0) {
                self.status = (self.status | has) ^ bit::TOGGLE;
                memory.put(slot, passed.scale.outward(place.saturating_sub(passed.origin)));
            }
        }
    }
}
