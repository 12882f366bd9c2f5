//! What the drive does in a cycle, and with its supplies.

use core::time::Duration;

use crate::address::Address;
use crate::cia402::{Controlword, State, Statusword, StopOption, Transition};
use crate::model::EsmState;
use crate::rule::Occasion;

use super::alarms::Alarms;
use super::device::{Device, Inputs, StopOptions, Times};
use super::drive::VirtualDrive;
use super::events::Incident;
use super::memory::Slot;
use super::modes::Surroundings;
use super::number::{low16, signed16};
use super::rules;

/// The shortest cycle.
const SHORTEST: Duration = Duration::from_nanos(62_500);

/// A span in nanoseconds, of which 64 bits last for 584 years.
const fn nanos(span: Duration) -> u64 {
    span.as_secs().saturating_mul(1_000_000_000).saturating_add(span.subsec_nanos() as u64)
}

impl VirtualDrive<'_, '_> {
    /// Lets time pass: as many cycles as there are in it, the rest is kept for the next call.
    pub fn advance(&mut self, span: Duration) {
        let cycle = nanos(self.config.cycle.max(SHORTEST));
        self.rest = self.rest.saturating_add(nanos(span));
        while let Some(rest) = self.rest.checked_sub(cycle) {
            self.rest = rest;
            self.step();
        }
    }

    /// One cycle of the drive, [`Config::cycle`](super::Config::cycle) long.
    pub fn step(&mut self) {
        let cycle = self.config.cycle.max(SHORTEST);
        self.now = self.now.after(cycle);
        if !self.supply {
            self.modes.coast(cycle);
            return;
        }
        self.watch(cycle);
        self.watch_probes();
        let word = Controlword(low16(self.memory.used(self.slots.controlword)));
        let options = self.options();
        let transition = self.change_state(word, options, cycle);
        self.transition = transition;
        self.act_on(transition, word);
        let order = self.device.order(options);
        let incident = self.modes.step(
            &mut self.memory,
            &self.slots,
            &self.config,
            &Surroundings { order, word, cycle },
        );
        if let Some(incident) = incident {
            self.report(incident, false);
        }
        if self.modes.stands() {
            self.memory.standstill();
        }
        self.publish();
    }

    /// Process data that do not come, and a supply that is not there.
    fn watch(&mut self, cycle: Duration) {
        self.silent = self.silent.saturating_add(cycle);
        let watched = self.esm == EsmState::Op && !self.config.watchdog.is_zero();
        if watched && self.silent > self.config.watchdog {
            self.esm = EsmState::SafeOp;
            self.report(Incident::Watchdog, false);
        }
        if !self.mains
            && matches!(self.state(), State::SwitchedOn | State::OperationEnabled | State::QuickStopActive)
        {
            self.report(Incident::Undervoltage, true);
        }
    }

    /// Rules of the touch probe, when its function changes.
    fn watch_probes(&mut self) {
        let slot = self.slots.probe_function;
        let function = self.memory.used(slot);
        if core::mem::replace(&mut self.probes, function) != function {
            self.check_rules(slot, Address::new(0x60B8, 0));
        }
    }

    fn options(&self) -> StopOptions {
        let of = |slot: Slot, default: i16| signed16(self.memory.used_or(slot, i64::from(default)));
        let (slots, config) = (&self.slots, &self.config);
        let off = StopOption { reaction: crate::cia402::Reaction::Coast, stays: false };
        StopOptions {
            quick_stop: StopOption::quick_stop(of(slots.quick_stop_option, config.quick_stop_option))
                .unwrap_or(off),
            shutdown: StopOption::disable(of(slots.shutdown_option, config.shutdown_option)).unwrap_or(off),
            disable: StopOption::disable(of(slots.disable_option, config.disable_option)).unwrap_or(off),
            fault: StopOption::fault(of(slots.fault_option, config.fault_option)).unwrap_or(off),
        }
    }

    fn change_state(
        &mut self,
        word: Controlword,
        options: StopOptions,
        cycle: Duration,
    ) -> Option<Transition> {
        if self.state() == State::Fault
            && word.fault_reset()
            && !self.device.previous().fault_reset()
            && !self.local
        {
            self.alarms.reset(self.esm != EsmState::Init);
        }
        let inputs = Inputs {
            word,
            options,
            standstill: self.modes.stands(),
            power: self.mains && self.torque_allowed,
            fault: self.alarms.is_active(),
            persists: self.alarms.is_active(),
            local: self.local,
        };
        let times = Times { cycle, start_up: self.config.start_up, stop: self.config.stop_time };
        self.device.step(&inputs, &times)
    }

    /// What a transition does besides leading to another state.
    fn act_on(&mut self, transition: Option<Transition>, word: Controlword) {
        match transition.map(Transition::number) {
            Some(4) => {
                let broken = rules::broken(&self.memory, Occasion::Enable).next();
                if let Some(alarm) = broken.and_then(|rule| rules::alarm(self.model(), rule)) {
                    self.raise_alarm(alarm, false);
                }
                self.modes.enable(word);
            }
            Some(16) => self.modes.enable(word),
            _ => {}
        }
    }

    /// What the drive shows in its dictionary.
    pub(super) fn publish(&mut self) {
        let word = self.compose();
        let slots = self.slots;
        self.memory.put(slots.statusword, i64::from(word.0));
        self.memory.put(slots.error_code, i64::from(self.alarms.code()));
        self.memory.put(slots.error_register, i64::from(self.alarms.register()));
    }

    fn compose(&self) -> Statusword {
        let (_, state) = self.state().pattern();
        let bit = |set: bool, mask: u16| if set { mask } else { 0 };
        let power = bit(self.mains && self.torque_allowed, Statusword::VOLTAGE_ENABLED);
        let warning = bit(self.warning, Statusword::WARNING);
        let remote = bit(!self.local && self.state() != State::NotReadyToSwitchOn, Statusword::REMOTE);
        Statusword(state | power | warning | remote | self.modes.bits())
    }

    /// Switches the control supply. Off, the drive answers nothing and the axis runs out; on, it starts up with what was
    /// kept, without alarms, in `PreOP`.
    pub fn set_supply(&mut self, on: bool) {
        if on && !self.supply {
            self.memory.power_up();
            self.device = Device::new();
            self.alarms = Alarms::new(self.model());
            self.modes.restart(&self.memory, &self.slots, &self.config);
            self.esm = EsmState::PreOp;
            self.silent = Duration::ZERO;
        }
        self.supply = on;
        self.publish();
    }

    /// Switches the control supply off and on.
    pub fn power_cycle(&mut self) {
        self.set_supply(false);
        self.set_supply(true);
    }

    /// Switches the main supply, of which the motor lives. Without it the drive is not switched on, and one that is has an
    /// alarm, if it has one for it.
    pub fn set_mains(&mut self, on: bool) {
        self.mains = on;
        if on {
            self.ended(Incident::Undervoltage);
        }
    }

    /// Allows torque, as an input for safe torque off does. This is a simulation, not a safety function.
    pub fn allow_torque(&mut self, allowed: bool) {
        self.torque_allowed = allowed;
    }

    /// Operates the drive at its panel: the controlword has no effect, and writes are refused.
    pub fn operate_locally(&mut self, local: bool) {
        self.local = local;
    }

    /// Sets or clears the warning, bit 7 of the statusword.
    pub fn warn(&mut self, warning: bool) {
        self.warning = warning;
    }
}
