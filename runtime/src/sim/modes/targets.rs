//! What each mode makes of its targets.

use crate::cia402::{Mode, ModeBits, Statusword};
use crate::homing::interpreter::{Levels, Run};
use crate::rule::Occasion;

use super::super::config::HomeOffset;
use super::super::device::Order;
use super::super::events::Incident;
use super::super::planner::Limits;
use super::super::plant::Setpoint;
use super::super::rules;
use super::cyclic::Cyclic;
use super::homing::Outcome;
use super::set_points::SetPoints;
use super::units::distance;
use super::{Context, Lead, Modes};

impl<'m> Modes<'m> {
    /// What the axis is told where it follows the mode.
    pub(super) fn follow(&mut self, context: &Context<'_, 'm, '_>) -> (Setpoint, Option<Incident>) {
        let setpoint = match self.active {
            Mode::PROFILE_POSITION => self.profile_position(context),
            Mode::PROFILE_VELOCITY => self.profile_velocity(context),
            Mode::PROFILE_TORQUE => self.profile_torque(context),
            Mode::HOMING => self.home(context),
            Mode::CYCLIC_POSITION => return self.cyclic_position(context),
            Mode::CYCLIC_VELOCITY => self.cyclic_velocity(context),
            Mode::CYCLIC_TORQUE => self.torque(self.wanted_torque(context)),
            _ => {
                self.lead(Lead::Position);
                self.planner.stop(self.units.deceleration);
                self.after(context.cycle)
            }
        };
        (setpoint, None)
    }

    fn limits(&self) -> Limits {
        let units = &self.units;
        Limits {
            velocity: units.profile_velocity,
            acceleration: units.acceleration,
            deceleration: units.deceleration,
        }
    }

    /// A place within the software limits.
    fn within(&mut self, place: i64) -> i64 {
        let Some((min, max)) = self.units.limits else { return place };
        let (min, max) = (min.saturating_add(self.origin), max.saturating_add(self.origin));
        let held = place.max(min).min(max);
        self.limited |= held != place;
        held
    }

    /// Whether a switch or a software limit forbids to go on in the direction of this sign.
    fn blocked(&self, sign: i64) -> bool {
        let levels = self.plant.levels();
        let place = self.plant.position().saturating_sub(self.origin);
        let (min, max) = self.units.limits.unwrap_or((i64::MIN, i64::MAX));
        (sign < 0 && (levels.negative_limit || place <= min))
            || (sign > 0 && (levels.positive_limit || place >= max))
    }

    fn profile_position(&mut self, context: &Context<'_, 'm, '_>) -> Setpoint {
        self.lead(Lead::Position);
        let (units, origin, here) = (self.units, self.origin, self.plant.position());
        let raw = context.memory.used(context.slots.target_position);
        let relative = (context.word & ModeBits::RELATIVE != 0) != self.words.set_is_absolute;
        let reached = self.at_target();
        let last = self.planner.target().unwrap_or(here);
        let target = |before: Option<i64>| {
            let way = units.position.inward(raw);
            way.saturating_add(if relative { before.unwrap_or(last) } else { origin })
        };
        self.points.step(context.word, reached, target);
        if let Some(target) = self.points.current() {
            let target = self.within(target);
            let way = target.saturating_sub(self.plant.position());
            if self.blocked(way.signum()) && distance(target, here) > 0 {
                (self.limited, self.heads) = (true, false);
                self.planner.stop(self.units.quick_stop);
            } else if self.units.profile_velocity > 0 {
                self.heads = true;
                self.planner.move_to(target, self.limits());
            } else {
                self.heads = false;
                self.planner.stop(self.units.deceleration);
            }
        }
        self.after(context.cycle)
    }

    /// The wanted speed, within a limit and not beyond the ends of the way.
    fn wanted_speed(&mut self, context: &Context<'_, 'm, '_>, most: i64) -> i64 {
        let (memory, slots) = (context.memory, context.slots);
        let raw = memory.used(slots.target_velocity);
        let offset =
            if self.active == Mode::CYCLIC_VELOCITY { memory.used(slots.velocity_offset) } else { 0 };
        let wanted = self.units.velocity.inward(raw.saturating_add(offset));
        let speed = wanted.max(most.saturating_neg()).min(most);
        let blocked = self.blocked(speed.signum());
        self.limited |= blocked || speed != wanted;
        if blocked {
            0
        } else {
            speed
        }
    }

    fn profile_velocity(&mut self, context: &Context<'_, 'm, '_>) -> Setpoint {
        self.lead(Lead::Velocity);
        let speed = self.wanted_speed(context, self.units.max_velocity);
        self.planner.run_at(speed, self.limits());
        self.after(context.cycle)
    }

    fn cyclic_velocity(&mut self, context: &Context<'_, 'm, '_>) -> Setpoint {
        self.lead = Lead::Nothing;
        let velocity = self.wanted_speed(context, self.units.max_motor_speed);
        Setpoint::Velocity { velocity, acceleration: 0 }
    }

    fn wanted_torque(&self, context: &Context<'_, 'm, '_>) -> i32 {
        let (memory, slots) = (context.memory, context.slots);
        let offset = if self.active == Mode::CYCLIC_TORQUE { memory.used(slots.torque_offset) } else { 0 };
        let raw = memory.used(slots.target_torque).saturating_add(offset);
        let torque = i32::try_from(self.units.torque.inward(raw)).unwrap_or(0);
        let (positive, negative) = self.units.torque_limits;
        torque.max(negative.saturating_neg()).min(positive)
    }

    /// A torque, which ends where it would make the motor faster than it may be.
    fn torque(&mut self, torque: i32) -> Setpoint {
        self.lead = Lead::Nothing;
        let speed = self.plant.velocity();
        let faster = torque != 0 && (torque > 0) == (speed > 0);
        let held = faster && speed.saturating_abs() >= self.units.max_motor_speed;
        self.limited |= held;
        Setpoint::Torque { torque: if held { 0 } else { torque } }
    }

    fn profile_torque(&mut self, context: &Context<'_, 'm, '_>) -> Setpoint {
        let wanted = self.wanted_torque(context);
        let torque = match self.units.torque_slope {
            Some(slope) => self.slope.step(wanted, slope, context.cycle),
            None => wanted,
        };
        self.torque(torque)
    }

    pub(super) fn torque_reached(&self, context: &Context<'_, 'm, '_>) -> bool {
        self.demand.torque == i64::from(self.wanted_torque(context))
    }

    /// Whether the speed is as wanted, and whether the axis stands: bits 10 and 12, or where the drive has them.
    pub(super) fn speed_bits(&self, context: &Context<'_, 'm, '_>) -> u16 {
        let wanted = match (self.order, context.word & crate::cia402::Controlword::HALT) {
            (Order::Follow, 0) => {
                self.units.velocity.inward(context.memory.used(context.slots.target_velocity))
            }
            _ => 0,
        };
        let speed = self.plant.velocity();
        let reached = distance(speed, wanted) <= self.units.velocity_window.max(1);
        let stands = speed.saturating_abs() <= self.units.velocity_threshold;
        (if reached { Statusword::TARGET_REACHED } else { 0 })
            | (if stands { self.words.stands(self.active) } else { 0 })
    }

    fn cyclic_position(&mut self, context: &Context<'_, 'm, '_>) -> (Setpoint, Option<Incident>) {
        if self.lead != Lead::Nothing {
            self.cyclic = Cyclic::at(self.plant.position());
            self.lead = Lead::Nothing;
        }
        let mut incident = None;
        if self.cyclic.is_fresh() {
            let raw = context.memory.used(context.slots.target_position);
            let wanted = self.units.position.inward(raw).saturating_add(self.units.position_offset);
            let wanted = self.within(wanted.saturating_add(self.origin));
            let reach = self.cyclic.reach(self.units.max_motor_speed, context.cycle);
            let most = reach.saturating_mul(i64::from(context.config.target_jump));
            incident = (most > 0 && self.cyclic.jumps(wanted, most)).then_some(Incident::Command);
            let last = self.cyclic.last();
            let way = wanted.saturating_sub(last).max(reach.saturating_neg()).min(reach);
            let blocked = self.blocked(way.signum());
            self.limited |= blocked;
            self.cyclic.target(if blocked || incident.is_some() { last } else { last.saturating_add(way) });
        }
        let point = self.cyclic.step(context.cycle);
        (Setpoint::Position { target: point.position, velocity: point.velocity, acceleration: 0 }, incident)
    }

    /// A start of homing, or its end: bit 4.
    pub(super) fn look_at_homing(&mut self, context: &Context<'_, 'm, '_>) {
        self.homing.watch(&self.plant);
        let starts = self.homing.look(context.word);
        if self.order != Order::Follow {
            self.homing.interrupt();
        }
        if starts {
            let run = self.run(context);
            self.homing.start(run);
        }
    }

    /// The program of the method that is set; `None` where the drive has a homing error instead.
    fn run(&self, context: &Context<'_, 'm, '_>) -> Option<Run<'m>> {
        let memory = context.memory;
        let broken = rules::broken(memory, Occasion::StartHoming).next().is_some();
        if broken || self.order != Order::Follow {
            return None;
        }
        let number = super::super::number::signed8(memory.used(context.slots.homing_method));
        let home =
            self.home.filter(|home| distance(*home, self.plant.position()) <= self.units.position_window);
        let levels = Levels { at_home: home.is_some(), ..self.plant.levels() };
        Run::start(memory.model().homing(number)?, levels).ok()
    }

    fn home(&mut self, context: &Context<'_, 'm, '_>) -> Setpoint {
        self.lead(Lead::Position);
        let outcome = self.homing.step(&self.plant, &mut self.planner, &self.units, context.cycle);
        if let Outcome::Home(place) = outcome {
            let offset = match context.config.home_offset {
                HomeOffset::ZeroIsHomePlusOffset => self.units.home_offset,
                HomeOffset::HomeIsOffset => self.units.home_offset.saturating_neg(),
            };
            self.home = Some(place);
            self.origin = place.saturating_add(offset);
            self.points = SetPoints::none(context.word);
        }
        self.after(context.cycle)
    }
}
