//! Modes of operation on top of the physical axis.

use core::time::Duration;

use crate::cia402::{Controlword, Mode};

use super::config::Config;
use super::device::Order;
use super::events::Incident;
use super::memory::Memory;
use super::slots::Slots;

/// What a cycle gives.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surroundings {
    pub(crate) order: Order,
    pub(crate) word: Controlword,
    pub(crate) cycle: Duration,
}

/// The modes.
#[derive(Debug)]
pub(crate) struct Modes<'m> {
    active: Mode,
    model: core::marker::PhantomData<&'m ()>,
}

impl<'m> Modes<'m> {
    pub(crate) fn new(_memory: &Memory<'m, '_>, _slots: &Slots, _config: &Config) -> Self {
        Self { active: Mode::NONE, model: core::marker::PhantomData }
    }
    pub(crate) const fn active(&self) -> Mode {
        self.active
    }
    pub(crate) fn is_homing(&self) -> bool {
        false
    }
    pub(crate) fn refresh(&mut self) {}
    pub(crate) fn coast(&mut self, _cycle: Duration) {}
    pub(crate) fn stands(&self) -> bool {
        true
    }
    pub(crate) fn bits(&self) -> u16 {
        0
    }
    pub(crate) fn enable(&mut self, _memory: &mut Memory<'m, '_>, _slots: &Slots) {}
    pub(crate) fn restart(&mut self, _memory: &Memory<'m, '_>, _slots: &Slots, _config: &Config) {}
    pub(crate) fn step(
        &mut self,
        memory: &mut Memory<'m, '_>,
        slots: &Slots,
        _config: &Config,
        _around: &Surroundings,
    ) -> Option<Incident> {
        self.active = Mode(super::number::signed8(memory.used(slots.mode)));
        memory.put(slots.mode_display, memory.used(slots.mode));
        None
    }
}
