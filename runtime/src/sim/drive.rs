//! The virtual drive as its user sees it: supply, bus, SDO, process data, alarms, and time.

use core::time::Duration;

use crate::abort::AbortCode;
use crate::address::Address;
use crate::cia402::{Mode, State, Statusword, Transition};
use crate::mapping::Direction;
use crate::model::{AlarmDesc, DriveModel, EsmState};
use crate::rule::Occasion;
use crate::time::Instant;

use super::alarms::{ActiveAlarm, Alarms, Emergency, UnknownAlarm};
use super::config::Config;
use super::device::Device;
use super::events::{self, Incident};
use super::memory::{Memory, Slot, SpaceError};
use super::modes::Modes;
use super::network::{is_change, BusRefusal};
use super::number::low16;
use super::plant::Plant;
use super::process::Layout;
use super::server::{self, NoUpload, Situation};
use super::slots::Slots;
use super::{assumptions, history, rules};

/// A drive without hardware.
///
/// ```
/// use core::time::Duration;
/// use drivewright_runtime::cia402::State;
/// use drivewright_runtime::prelude::*;
/// use drivewright_runtime::sim::{cells, Config, VirtualDrive};
///
/// static OBJECTS: [ObjectDesc<'static>; 2] = [
///     ObjectDesc::new(Address::new(0x6040, 0), DataType::UNSIGNED16, Access::Rw, Mapping::Rx, "Controlword"),
///     ObjectDesc::new(Address::new(0x6041, 0), DataType::UNSIGNED16, Access::Ro, Mapping::Tx, "Statusword"),
/// ];
/// static MODEL: DriveModel<'static> = DriveModel::new(Identity::new("x3", "Acme", "X3")).with_objects(&OBJECTS);
///
/// let mut memory = [0; cells(&MODEL)];
/// let mut drive = VirtualDrive::new(&MODEL, &mut memory, Config::default()).unwrap();
/// drive.advance(Duration::from_millis(100));
/// assert_eq!(drive.state(), State::SwitchOnDisabled);
/// drive.download(Address::new(0x6040, 0), &[0x06, 0]).unwrap();
/// drive.advance(Duration::from_millis(1));
/// assert_eq!(drive.statusword().0, 0x0231);
/// ```
#[derive(Debug)]
#[allow(clippy::struct_excessive_bools)] // Each is a line of its own at the drive.
pub struct VirtualDrive<'m, 's> {
    pub(super) memory: Memory<'m, 's>,
    pub(super) slots: Slots,
    pub(super) config: Config,
    pub(super) device: Device,
    pub(super) alarms: Alarms<'m>,
    pub(super) modes: Modes<'m>,
    pub(super) now: Instant,
    /// Time that is told and makes no whole cycle yet, in nanoseconds.
    pub(super) rest: u64,
    pub(super) esm: EsmState,
    pub(super) received: Layout,
    /// Process data carry more than words and targets.
    pub(super) parameters: bool,
    pub(super) sent: Layout,
    /// Time since process data came.
    pub(super) silent: Duration,
    /// 60B8h in the last cycle: process data may carry it.
    pub(super) probes: i64,
    /// The transition of the last cycle.
    pub(super) transition: Option<Transition>,
    pub(super) supply: bool,
    pub(super) mains: bool,
    pub(super) torque_allowed: bool,
    pub(super) local: bool,
    pub(super) warning: bool,
}

/// Why a drive has no answer to an SDO request.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum NoAnswer {
    /// It refuses the request.
    Abort(AbortCode),
    /// It is off, starts up, or has no mailbox: Init.
    Silent,
    /// The answer has more bytes than there is room for.
    TooLong,
}

impl core::fmt::Display for NoAnswer {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Abort(code) => write!(f, "the drive refuses: {code}"),
            Self::Silent => f.write_str("the drive does not answer"),
            Self::TooLong => f.write_str("the answer is longer than there is room for"),
        }
    }
}

impl core::error::Error for NoAnswer {}

impl<'m, 's> VirtualDrive<'m, 's> {
    /// A drive whose supplies are switched on at this moment, in `PreOP`: the master has set up the mailbox.
    ///
    /// # Errors
    /// `memory` has fewer cells than [`cells`](super::cells) says.
    pub fn new(model: &'m DriveModel<'m>, memory: &'s mut [i64], config: Config) -> Result<Self, SpaceError> {
        let memory = Memory::new(model, memory)?;
        let slots = Slots::of(&memory);
        let axis = Modes::new(&memory, &slots, &config, Plant::default());
        let mut drive = Self {
            memory,
            slots,
            config,
            device: Device::new(),
            alarms: Alarms::new(model),
            modes: axis,
            now: Instant::START,
            rest: 0,
            esm: EsmState::PreOp,
            received: Layout::EMPTY,
            parameters: false,
            sent: Layout::EMPTY,
            silent: Duration::ZERO,
            probes: 0,
            transition: None,
            supply: true,
            mains: true,
            torque_allowed: true,
            local: false,
            warning: false,
        };
        drive.publish();
        Ok(drive)
    }

    /// The same drive on another axis.
    #[must_use]
    pub fn with_axis(mut self, axis: Plant) -> Self {
        self.modes = Modes::new(&self.memory, &self.slots, &self.config, axis);
        self
    }

    /// What is assumed where manuals are silent: [`ASSUMPTIONS`](super::ASSUMPTIONS).
    pub fn assumptions() -> impl Iterator<Item = &'static assumptions::Assumption> {
        assumptions::ASSUMPTIONS.iter()
    }

    /// The drive as data.
    pub fn model(&self) -> &'m DriveModel<'m> {
        self.memory.model()
    }

    /// The settings.
    pub const fn config(&self) -> &Config {
        &self.config
    }

    /// Time since it was made.
    pub const fn now(&self) -> Instant {
        self.now
    }

    /// The state of the state machine.
    pub const fn state(&self) -> State {
        self.device.state()
    }

    /// The transition that was made in the last cycle.
    pub const fn transition(&self) -> Option<Transition> {
        self.transition
    }

    /// The axis: where it is, how fast, what its switches say.
    pub const fn axis(&self) -> &Plant {
        self.modes.plant()
    }

    /// The axis, to put a load on it.
    pub fn axis_mut(&mut self) -> &mut Plant {
        self.modes.plant_mut()
    }

    /// Sets the input of a touch probe: 0 is the first, 1 the second; there are no others.
    pub fn set_probe(&mut self, probe: usize, level: bool) {
        self.modes.set_probe(probe, level);
    }

    /// The count of the axis at which the position is 0.
    pub const fn origin(&self) -> i64 {
        self.modes.origin()
    }

    /// The statusword as it is.
    pub fn statusword(&self) -> Statusword {
        Statusword(low16(self.memory.now(self.slots.statusword)))
    }

    /// The mode of operation that is active.
    pub const fn mode(&self) -> Mode {
        self.modes.active()
    }

    /// What the drive acts on for an entry; `None` if the dictionary has none there. For tests and displays: a master
    /// uses [`upload`](Self::upload).
    pub fn value(&self, address: Address) -> Option<i64> {
        self.memory.at(address)
    }

    /// The alarms that are active, in the order in which they came.
    pub fn alarms(&self) -> impl Iterator<Item = ActiveAlarm<'m>> + '_ {
        self.alarms.iter()
    }

    /// The oldest emergency message that was not taken yet.
    pub fn emergency(&mut self) -> Option<Emergency> {
        self.alarms.message()
    }

    /// Reads an entry over SDO; gives the number of bytes.
    ///
    /// # Errors
    /// As they are described.
    pub fn upload(&mut self, address: Address, into: &mut [u8]) -> Result<usize, NoAnswer> {
        self.answers()?;
        server::upload(&self.memory, address, into).map_err(|why| match why {
            NoUpload::Abort(code) => NoAnswer::Abort(code),
            NoUpload::TooLong => NoAnswer::TooLong,
        })
    }

    /// Writes an entry over SDO.
    ///
    /// # Errors
    /// As they are described.
    pub fn download(&mut self, address: Address, data: &[u8]) -> Result<(), NoAnswer> {
        self.answers()?;
        let situation = Situation {
            esm: self.esm,
            received: (self.esm == EsmState::Op).then_some(&self.received),
            homing: self.modes.is_homing(),
            local: self.local,
            keeps: self.config.keeps,
        };
        let written =
            server::download(&mut self.memory, &situation, address, data).map_err(NoAnswer::Abort)?;
        self.written(written.slot, written.address);
        Ok(())
    }

    /// Whether the drive answers SDO at all.
    fn answers(&self) -> Result<(), NoAnswer> {
        let up = self.supply && self.state() != State::NotReadyToSwitchOn && self.esm != EsmState::Init;
        up.then_some(()).ok_or(NoAnswer::Silent)
    }

    /// Alarms that a value raises, and values of which the drive keeps a copy in another form.
    fn written(&mut self, slot: Slot, address: Address) {
        self.check_rules(slot, address);
        self.modes.refresh();
    }

    /// The alarm of a rule that the present value breaks.
    pub(super) fn check_rules(&mut self, slot: Slot, address: Address) {
        let value = self.memory.used(slot);
        let model = self.model();
        let raised =
            rules::broken_by(&self.memory, address, value).find_map(|rule| rules::alarm(model, rule));
        if let Some(alarm) = raised {
            self.raise_alarm(alarm, false);
        }
    }

    /// The state of the EtherCAT state machine.
    pub const fn bus_state(&self) -> EsmState {
        self.esm
    }

    /// Asks for a state of the EtherCAT state machine.
    ///
    /// # Errors
    /// The state stays where it is refused.
    pub fn request(&mut self, wanted: EsmState) -> Result<(), BusRefusal> {
        if !self.supply {
            return Err(BusRefusal::Off);
        }
        if !is_change(self.esm, wanted) {
            return Err(BusRefusal::InvalidChange);
        }
        if self.esm == EsmState::PreOp && wanted == EsmState::SafeOp {
            self.lay_out()?;
        }
        if self.esm != wanted {
            self.leave_bus_state();
        }
        self.esm = wanted;
        self.silent = Duration::ZERO;
        Ok(())
    }

    /// From `PreOP` to `SafeOP`: what is exchanged is fixed.
    fn lay_out(&mut self) -> Result<(), BusRefusal> {
        let clock = if self.config.distributed_clocks { Occasion::Dc } else { Occasion::FreeRun };
        self.synchronize();
        if rules::broken(&self.memory, clock).next().is_some() {
            return Err(BusRefusal::CycleTime);
        }
        self.received = Layout::of(&self.memory, Direction::Rx).map_err(|_| BusRefusal::OutputMapping)?;
        self.sent = Layout::of(&self.memory, Direction::Tx).map_err(|_| BusRefusal::InputMapping)?;
        self.parameters = !self.received.is_of(&self.slots.set_points());
        Ok(())
    }

    /// What 1C32h and 1C33h say of the synchronization: distributed clocks with SYNC0 and their cycle, or free run.
    fn synchronize(&mut self) {
        let cycle = i64::try_from(self.config.cycle.as_nanos()).unwrap_or(i64::MAX);
        let (kind, cycle) = if self.config.distributed_clocks { (2, cycle) } else { (0, 0) };
        for index in [0x1C32, 0x1C33] {
            for (sub, value) in [(1, kind), (10, cycle)] {
                let slot = self.memory.slot(Address::new(index, sub));
                self.memory.put(slot, value);
            }
        }
    }

    /// A rule may forbid the change in this state: the state changes nevertheless, and there is an alarm.
    fn leave_bus_state(&mut self) {
        let broken = rules::broken(&self.memory, Occasion::EsmChange).next();
        if let Some(alarm) = broken.and_then(|rule| rules::alarm(self.model(), rule)) {
            self.raise_alarm(alarm, false);
        }
    }

    /// Bytes of the process data that the drive receives and sends: 0 before `SafeOP`.
    pub fn process_data_bytes(&self) -> (usize, usize) {
        match self.esm {
            EsmState::SafeOp | EsmState::Op => (self.received.bytes(), self.sent.bytes()),
            _ => (0, 0),
        }
    }

    /// Takes process data. They count in OP only; `false` where they are refused, which those of a wrong length are.
    pub fn receive(&mut self, data: &[u8]) -> bool {
        let taken = self.supply && self.esm == EsmState::Op && data.len() == self.received.bytes();
        if taken {
            self.received.unpack(&mut self.memory, data);
            self.modes.received(self.parameters);
            self.silent = Duration::ZERO;
        }
        taken
    }

    /// Gives process data, in `SafeOP` and `OP`; the number of bytes, or `None` where there are none or there is no room.
    pub fn send(&self, into: &mut [u8]) -> Option<usize> {
        let sends = self.supply && matches!(self.esm, EsmState::SafeOp | EsmState::Op);
        let length = self.sent.bytes();
        let room = into.get_mut(..length).filter(|_| sends)?;
        self.sent.pack(&self.memory, room);
        Some(length)
    }

    /// Raises an alarm, as if its cause had come and gone.
    ///
    /// # Errors
    /// The model has no such alarm.
    pub fn raise(&mut self, display: &str, number: u16) -> Result<(), UnknownAlarm> {
        let alarm = self.model().alarm(display, number).ok_or(UnknownAlarm)?;
        self.raise_alarm(alarm, false);
        Ok(())
    }

    /// Raises an alarm whose cause stays until [`end_cause`](Self::end_cause).
    ///
    /// # Errors
    /// The model has no such alarm.
    pub fn raise_for_good(&mut self, display: &str, number: u16) -> Result<(), UnknownAlarm> {
        let alarm = self.model().alarm(display, number).ok_or(UnknownAlarm)?;
        self.raise_alarm(alarm, true);
        Ok(())
    }

    /// The cause of an alarm is gone; a fault reset can clear it now.
    ///
    /// # Errors
    /// The model has no such alarm.
    pub fn end_cause(&mut self, display: &str, number: u16) -> Result<(), UnknownAlarm> {
        let alarm = self.model().alarm(display, number).ok_or(UnknownAlarm)?;
        self.alarms.end_cause(alarm);
        Ok(())
    }

    pub(super) fn raise_alarm(&mut self, alarm: &'m AlarmDesc<'m>, cause: bool) {
        if self.alarms.raise(alarm, cause, self.esm != EsmState::Init) {
            history::add(&mut self.memory, alarm);
        }
    }

    /// Raises the alarm that the drive has for this; nothing where it has none.
    pub(super) fn report(&mut self, incident: Incident, cause: bool) {
        if let Some(alarm) = events::alarm(self.model(), incident) {
            self.raise_alarm(alarm, cause);
        }
    }

    /// The alarm that the drive has for this can be reset again.
    pub(super) fn ended(&mut self, incident: Incident) {
        if let Some(alarm) = events::alarm(self.model(), incident) {
            self.alarms.end_cause(alarm);
        }
    }
}
