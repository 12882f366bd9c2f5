//! Modes of operation on top of the physical axis: from the words and set-points of a cycle to what the axis is told.

mod cyclic;
mod homing;
mod probe;
mod report;
mod set_points;
mod supervise;
mod targets;
mod units;
mod words;

use core::time::Duration;

use crate::cia402::{Controlword, Mode, ModeBits, Reaction, Statusword, StopOption};
use crate::rule::Occasion;

use super::config::Config;
use super::device::Order;
use super::events::Incident;
use super::memory::Memory;
use super::number::{signed16, signed8};
use super::planner::{Planner, Slope};
use super::plant::{Plant, Setpoint};
use super::slots::Slots;
use cyclic::Cyclic;
use homing::Homing;
use probe::{Passed, Probes};
use report::{Demand, Report};
use set_points::SetPoints;
use supervise::Watch;
use units::{distance, Units};
use words::Words;

/// What a cycle gives.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surroundings {
    pub(crate) order: Order,
    pub(crate) word: Controlword,
    pub(crate) cycle: Duration,
}

/// What a mode works on.
struct Context<'a, 'm, 's> {
    memory: &'a Memory<'m, 's>,
    slots: &'a Slots,
    config: &'a Config,
    word: u16,
    cycle: Duration,
}

/// What the axis was last led by: the planner goes on from there, or takes over the motion of the axis.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Lead {
    Nothing,
    Position,
    Velocity,
}

/// The modes of operation, and the axis.
#[derive(Debug)]
#[allow(clippy::struct_excessive_bools)] // They are no state together.
pub(crate) struct Modes<'m> {
    plant: Plant,
    planner: Planner,
    units: Units,
    words: Words,
    /// The units may have changed.
    stale: bool,
    active: Mode,
    /// A value of 6060h that is not followed, which is asked about once; and whether only while homing runs.
    refused: Option<(i64, bool)>,
    /// The count of the axis at which the position is 0.
    origin: i64,
    /// The count of the axis at which home was found.
    home: Option<i64>,
    lead: Lead,
    order: Order,
    points: SetPoints,
    /// The planner is on its way to the present set-point, or there.
    heads: bool,
    /// The axis is braked although the drive is enabled.
    brakes: bool,
    homing: Homing<'m>,
    cyclic: Cyclic,
    slope: Slope,
    watch: Watch,
    demand: Demand,
    report: Report,
    probes: Probes,
    /// Something inside the drive holds the axis back.
    limited: bool,
    bits: u16,
}

impl<'m> Modes<'m> {
    pub(crate) fn new(memory: &Memory<'m, '_>, slots: &Slots, config: &Config, plant: Plant) -> Self {
        let place = plant.position();
        Self {
            planner: Planner::at(place),
            units: Units::of(memory, slots, config),
            words: Words::of(memory, slots),
            stale: true,
            active: Mode::NONE,
            refused: None,
            origin: place,
            home: None,
            lead: Lead::Nothing,
            order: Order::Off,
            points: SetPoints::none(0),
            heads: false,
            brakes: false,
            homing: Homing::default(),
            cyclic: Cyclic::at(place),
            slope: Slope::at(0),
            watch: Watch::default(),
            demand: Demand { position: place, ..Demand::default() },
            report: Report::default(),
            probes: Probes::default(),
            limited: false,
            bits: 0,
            plant,
        }
    }

    /// The supply comes back: the position is 0 where the axis is, and home is not known.
    pub(crate) fn restart(&mut self, memory: &Memory<'m, '_>, slots: &Slots, config: &Config) {
        *self = Self::new(memory, slots, config, self.plant.clone());
    }

    pub(crate) const fn active(&self) -> Mode {
        self.active
    }

    pub(crate) const fn plant(&self) -> &Plant {
        &self.plant
    }

    pub(crate) fn plant_mut(&mut self) -> &mut Plant {
        &mut self.plant
    }

    /// Sets the input of a touch probe.
    pub(crate) fn set_probe(&mut self, probe: usize, level: bool) {
        self.probes.set(probe, level);
    }

    /// The count of the axis at which the position is 0.
    pub(crate) const fn origin(&self) -> i64 {
        self.origin
    }

    pub(crate) const fn is_homing(&self) -> bool {
        self.homing.runs()
    }

    /// Values were written that may be parameters.
    pub(crate) fn refresh(&mut self) {
        self.stale = true;
        self.cyclic.data();
    }

    /// Process data came; `parameters`: not only set-points.
    pub(crate) fn received(&mut self, parameters: bool) {
        self.stale |= parameters;
        self.cyclic.data();
    }

    /// A cycle without supply.
    pub(crate) fn coast(&mut self, cycle: Duration) {
        self.plant.step(Setpoint::Off, cycle);
    }

    /// Whether the axis stands and nothing moves it.
    pub(crate) fn stands(&self) -> bool {
        // The last part of a count may take the planner long: at a speed that counts as none.
        let slow = self.planner.point().velocity.abs() <= self.plant.config().standstill;
        self.plant.standstill() && (self.lead == Lead::Nothing || slow)
    }

    /// Bits 10 to 13 of the statusword.
    pub(crate) const fn bits(&self) -> u16 {
        self.bits
    }

    /// The drive is enabled: what was asked for before does not count.
    pub(crate) fn enable(&mut self, word: Controlword) {
        self.lead = Lead::Nothing;
        self.points = SetPoints::none(word.0);
        self.homing.interrupt();
        self.cyclic = Cyclic::at(self.plant.position());
        self.slope = Slope::at(0);
    }

    /// One cycle.
    pub(crate) fn step(
        &mut self,
        memory: &mut Memory<'m, '_>,
        slots: &Slots,
        config: &Config,
        around: &Surroundings,
    ) -> Option<Incident> {
        if core::mem::take(&mut self.stale) {
            self.units = Units::of(memory, slots, config);
            self.plant.limit_torque(self.units.torque_limits.0, self.units.torque_limits.1);
        }
        self.order = around.order;
        let context = Context { memory, slots, config, word: around.word.0, cycle: around.cycle };
        let changed = self.change_mode(&context);
        let (setpoint, incident) = self.setpoint(&context);
        self.plant.step(setpoint, around.cycle);
        self.note(setpoint);
        let watched = self.supervise(&context);
        self.compose(&context);
        memory.put(slots.mode_display, i64::from(self.active.0));
        let passed = Passed {
            crossings: self.plant.crossings(),
            position: self.plant.position(),
            origin: self.origin,
            scale: self.units.position,
        };
        self.probes.step(memory, slots, &passed);
        self.report.write(memory, slots, &self.units, (&self.plant, &self.demand, self.origin));
        changed.or(incident).or(watched)
    }

    /// 6061h follows 6060h, where the drive has the mode and no homing runs.
    fn change_mode(&mut self, context: &Context<'_, 'm, '_>) -> Option<Incident> {
        let raw = context.memory.used(context.slots.mode);
        let wanted = Mode(signed8(raw));
        if wanted == self.active {
            self.refused = None;
            return None;
        }
        if self.refused.is_some_and(|(value, homes)| value == raw && (!homes || self.homing.runs())) {
            return None;
        }
        if !supports(context, wanted) {
            self.refused = Some((raw, false));
            return None;
        }
        if self.homing.runs() && context.memory.model().rules_on(Some(Occasion::WhileHoming)).next().is_some()
        {
            self.refused = Some((raw, true));
            return Some(Incident::Mode);
        }
        self.refused = None;
        self.enter(wanted, context.word);
        None
    }

    fn enter(&mut self, mode: Mode, word: u16) {
        self.active = mode;
        self.points = SetPoints::none(word);
        self.homing.enter(word);
        self.cyclic = Cyclic::at(self.plant.position());
        self.slope = Slope::at(self.plant.torque());
    }

    /// What the axis is told in this cycle.
    fn setpoint(&mut self, context: &Context<'_, 'm, '_>) -> (Setpoint, Option<Incident>) {
        self.limited = false;
        self.brakes = false;
        if self.active == Mode::HOMING {
            self.look_at_homing(context);
        }
        match self.order {
            Order::Off => {
                self.lead = Lead::Nothing;
                (Setpoint::Off, None)
            }
            Order::Stop(reaction) => (self.brake(reaction, context.cycle), None),
            Order::Follow if context.word & Controlword::HALT != 0 => {
                (self.brake(halt(context), context.cycle), None)
            }
            Order::Follow => self.follow(context),
        }
    }

    /// The axis brakes, and is held where it stands then.
    fn brake(&mut self, reaction: Reaction, cycle: Duration) -> Setpoint {
        if reaction == Reaction::Coast {
            self.lead = Lead::Nothing;
            return Setpoint::Off;
        }
        self.lead(Lead::Position);
        (self.brakes, self.heads) = (true, false);
        self.planner.stop(match reaction {
            Reaction::SlowDownRamp => self.units.deceleration,
            Reaction::QuickStopRamp => self.units.quick_stop,
            _ => self.plant.config().acceleration,
        });
        self.after(cycle)
    }

    /// The planner leads from now on: from where it is, or from the motion of the axis.
    fn lead(&mut self, lead: Lead) {
        let goes_on = self.lead == lead || (self.lead == Lead::Position && lead == Lead::Velocity);
        if !goes_on {
            self.planner.seed(self.plant.position(), self.plant.velocity());
        }
        self.lead = lead;
    }

    /// What the axis is told where the planner leads.
    fn after(&mut self, cycle: Duration) -> Setpoint {
        self.planner.step(cycle);
        self.planned()
    }

    fn planned(&self) -> Setpoint {
        let point = self.planner.point();
        let (target, velocity, acceleration) = (point.position, point.velocity, point.acceleration);
        match self.lead {
            Lead::Velocity => Setpoint::Velocity { velocity, acceleration },
            _ => Setpoint::Position { target, velocity, acceleration },
        }
    }

    /// Keeps what the axis was told.
    fn note(&mut self, setpoint: Setpoint) {
        let (position, velocity) = (self.plant.position(), self.plant.velocity());
        let torque = i64::from(self.plant.torque());
        self.demand = match setpoint {
            Setpoint::Off => Demand { position, velocity: 0, torque: 0 },
            Setpoint::Position { target, velocity, .. } => Demand { position: target, velocity, torque },
            Setpoint::Velocity { velocity, .. } => Demand { position, velocity, torque },
            Setpoint::Torque { torque } => Demand { position, velocity, torque: i64::from(torque) },
        };
    }

    fn supervise(&mut self, context: &Context<'_, 'm, '_>) -> Option<Incident> {
        let demand = (self.order != Order::Off).then_some(self.demand.position);
        let watched = self.watch.step(
            (context.memory, context.slots),
            (context.config, &self.units),
            (&self.plant, demand),
            context.cycle,
        );
        let longest = context.config.homing_time;
        if self.homing.runs() && !longest.is_zero() && self.homing.time() > longest {
            self.homing.fail();
            return Some(Incident::HomingTime);
        }
        watched
    }

    /// The bits of the mode, as far as the drive shows them.
    fn compose(&mut self, context: &Context<'_, 'm, '_>) {
        let enabled = self.order != Order::Off;
        let bit = |set: bool, mask: u16| if set { mask } else { 0 };
        let own = match self.active {
            Mode::HOMING => self.homing.bits(self.stands()),
            _ if !enabled => 0,
            Mode::PROFILE_POSITION => {
                bit(self.at_target(), Statusword::TARGET_REACHED)
                    | bit(self.points.acknowledged(), ModeBits::SET_POINT_ACKNOWLEDGE)
                    | bit(!self.watch.follows(), ModeBits::FOLLOWING_ERROR)
            }
            Mode::PROFILE_VELOCITY => self.speed_bits(context),
            Mode::PROFILE_TORQUE => bit(self.torque_reached(context), Statusword::TARGET_REACHED),
            Mode::CYCLIC_POSITION => {
                bit(self.at_demand(), Statusword::TARGET_REACHED)
                    | bit(self.order == Order::Follow, ModeBits::FOLLOWS_TARGET)
                    | bit(!self.watch.follows(), ModeBits::FOLLOWING_ERROR)
            }
            Mode::CYCLIC_VELOCITY => {
                self.speed_bits(context) | bit(self.order == Order::Follow, ModeBits::FOLLOWS_TARGET)
            }
            Mode::CYCLIC_TORQUE => bit(self.order == Order::Follow, ModeBits::FOLLOWS_TARGET),
            _ => 0,
        };
        let limited = bit(enabled && self.limited, Statusword::INTERNAL_LIMIT);
        // Where a drive tells standstill by the bit of the internal limit, that is what the bit means.
        let limit = if self.words.stands(self.active) == Statusword::INTERNAL_LIMIT { 0 } else { limited };
        self.bits = (own | limit) & self.words.shown(self.active);
    }

    /// Whether the axis stands where it should be.
    fn at_demand(&self) -> bool {
        let near = distance(self.demand.position, self.plant.position()) <= self.units.position_window;
        near && self.plant.velocity().saturating_abs() <= self.slow()
    }

    /// Whether the set-point is reached, or with halt, the axis stands.
    fn at_target(&self) -> bool {
        if self.brakes {
            return self.stands();
        }
        let there = self.points.current().is_none() || self.heads && self.planner.done();
        there && self.at_demand() && self.planner.point().velocity == 0
    }

    /// The speed up to which the axis stands: 606Fh, or what the axis says.
    fn slow(&self) -> i64 {
        self.units.velocity_threshold.max(self.plant.config().standstill)
    }
}

/// Whether the drive has a mode: its table of modes, or the values that 6060h takes.
fn supports(context: &Context<'_, '_, '_>, mode: Mode) -> bool {
    let model = context.memory.model();
    let listed = || model.modes().is_empty() || model.mode(mode.0).is_some();
    let object = context.memory.object(context.slots.mode);
    let allowed = object.and_then(|object| model.allowed_of(object));
    let takes = allowed.map_or_else(listed, |values| values.contains(&i64::from(mode.0)));
    words::is_known(mode) && (mode == Mode::NONE || takes)
}

/// How halt stops the axis.
fn halt(context: &Context<'_, '_, '_>) -> Reaction {
    let default = i64::from(context.config.halt_option);
    let code = signed16(context.memory.used_or(context.slots.halt_option, default));
    StopOption::halt(code).map_or(Reaction::SlowDownRamp, |option| option.reaction)
}
