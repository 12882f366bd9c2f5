//! The drive of `fake` on a bus: a dictionary, process data by layout, and a clock that only cycles and waiting move.

use core::time::Duration;
use std::collections::BTreeMap;

use drivewright_runtime::cia402::{Controlword, Mode};
use drivewright_runtime::client::axis::{AxisPolicy, Outputs};
use drivewright_runtime::client::drive::Drive;
use drivewright_runtime::client::image::Image;
use drivewright_runtime::client::session::Client;
use drivewright_runtime::pdo::MapEntry;
use drivewright_runtime::prelude::*;
use drivewright_runtime::time::Instant;
use drivewright_runtime::transport::{Refusal, Transport};
use drivewright_runtime::AbortCode;

use crate::fake::Fake;

const fn object(index: u16, sub: u8, data_type: DataType, access: Access) -> ObjectDesc<'static> {
    ObjectDesc::new(Address::new(index, sub), data_type, access, Mapping::RxTx, "an entry")
}

static UNITS: [UnitDesc<'static>; 2] = [
    UnitDesc::new("0.1 rpm", QuantityKind::Velocity, 1, 10),
    UnitDesc::new("user position", QuantityKind::UserPosition, 1, 1),
];
static OBJECTS: [ObjectDesc<'static>; 21] = [
    object(0x603F, 0, DataType::UNSIGNED16, Access::Ro),
    object(0x6040, 0, DataType::UNSIGNED16, Access::Rw),
    object(0x6041, 0, DataType::UNSIGNED16, Access::Ro),
    object(0x605A, 0, DataType::INTEGER16, Access::Rw),
    object(0x6060, 0, DataType::INTEGER8, Access::Rw),
    object(0x6061, 0, DataType::INTEGER8, Access::Ro),
    object(0x6064, 0, DataType::INTEGER32, Access::Ro).unit(1),
    object(0x606C, 0, DataType::INTEGER32, Access::Ro).unit(0),
    object(0x6071, 0, DataType::INTEGER16, Access::Rw),
    object(0x6072, 0, DataType::UNSIGNED16, Access::Rw),
    object(0x6077, 0, DataType::INTEGER16, Access::Ro),
    object(0x607A, 0, DataType::INTEGER32, Access::Rw).unit(1),
    object(0x607C, 0, DataType::INTEGER32, Access::Rw).unit(1),
    object(0x6081, 0, DataType::UNSIGNED32, Access::Rw).range(0, 60_000).unit(0),
    object(0x6083, 0, DataType::UNSIGNED32, Access::Rw),
    object(0x6098, 0, DataType::INTEGER8, Access::Rw),
    object(0x6099, 1, DataType::UNSIGNED32, Access::Rw).range(1, 60_000).unit(0),
    object(0x6099, 2, DataType::UNSIGNED32, Access::Rw).range(1, 60_000).unit(0),
    object(0x60FF, 0, DataType::INTEGER32, Access::Rw).range(-60_000, 60_000).unit(0),
    object(0x6402, 0, DataType::UNSIGNED16, Access::Ro),
    object(0x6502, 0, DataType::UNSIGNED32, Access::Ro),
];
static ALARMS: [AlarmDesc<'static>; 4] = [
    AlarmDesc::new("Er.1", 1, 0x8611, "Following error").with_reset(Reset::Resettable),
    AlarmDesc::new("Er.2", 2, 0x7300, "Encoder").with_reset(Reset::PowerCycle),
    AlarmDesc::new("Er.3", 3, 0x2310, "Overcurrent").with_reset(Reset::PowerCycle),
    AlarmDesc::new("Er.4", 4, 0x2310, "Overload").with_reset(Reset::Resettable),
];
static TEXTS: [AlarmText<'static>; 1] =
    [AlarmText::new("Er.1", 1, &["The axis is blocked."], &["Free the axis.", "Raise 6065h."])];
pub(crate) static MODEL: DriveModel<'static> = DriveModel::new(Identity::new("acme-x3", "Acme", "X3"))
    .with_objects(&OBJECTS)
    .with_units(&UNITS)
    .with_alarms(&ALARMS);
pub(crate) static ALARM_TEXTS: &[AlarmText<'static>] = &TEXTS;

/// Everything that a cycle needs.
pub(crate) static RX: [MapEntry; 5] = [
    MapEntry::from_word(0x6040_0010),
    MapEntry::from_word(0x607A_0020),
    MapEntry::from_word(0x60FF_0020),
    MapEntry::from_word(0x6071_0010),
    MapEntry::from_word(0x6060_0008),
];
pub(crate) static TX: [MapEntry; 3] =
    [MapEntry::from_word(0x6041_0010), MapEntry::from_word(0x6064_0020), MapEntry::from_word(0x6061_0008)];

/// What a bus does wrong.
#[derive(Clone, Copy, Default)]
pub(crate) struct Faults {
    /// No SDO answer at all.
    pub(crate) mute: bool,
    /// SDO answers have this many bytes, whatever was asked.
    pub(crate) answer_bytes: Option<usize>,
    /// Process data have this many bytes.
    pub(crate) frame_bytes: Option<usize>,
    /// Every SDO transfer is refused.
    pub(crate) refuses: bool,
    /// The cable is off after so many cycles.
    pub(crate) cut_after: Option<usize>,
}

pub(crate) struct Bus {
    pub(crate) fake: Fake,
    pub(crate) faults: Faults,
    pub(crate) dictionary: BTreeMap<Address, Vec<u8>>,
    pub(crate) written: Vec<(Address, Vec<u8>)>,
    pub(crate) frames: Vec<Vec<u8>>,
    image: Image<'static>,
    outputs: Outputs,
    now: u64,
}

pub(crate) type Outcome<T> = Result<T, Refusal<&'static str>>;

impl Bus {
    pub(crate) fn new(fake: Fake, image: Image<'static>) -> Self {
        let known =
            [(0x605A, 0, vec![2, 0]), (0x6502, 0, vec![0xAD, 0x03, 0, 0]), (0x6072, 0, vec![0xE8, 3])];
        let dictionary = known.map(|(index, sub, bytes)| (Address::new(index, sub), bytes)).into();
        let (faults, outputs) = (Faults::default(), Outputs::default());
        Self { fake, faults, dictionary, written: vec![], frames: vec![], image, outputs, now: 0 }
    }

    fn cycle(&mut self) -> Option<Vec<u8>> {
        self.now += 1_000;
        let sample = self.fake.cycle(self.outputs)?;
        let entry = |entry: &MapEntry| self.live(entry.address()).unwrap_or(vec![0; 4]);
        let _ = sample;
        Some(self.image.tx().iter().flat_map(entry).collect())
    }

    /// What the drive shows now.
    fn live(&self, address: Address) -> Option<Vec<u8>> {
        let sample = self.fake.sample();
        Some(match address.index() {
            0x603F => self.fake.error_code.to_le_bytes().into(),
            0x6041 => sample.statusword.0.to_le_bytes().into(),
            0x6061 => sample.mode?.0.to_le_bytes().into(),
            0x6064 => sample.position?.to_le_bytes().into(),
            _ => return self.dictionary.get(&address).cloned(),
        })
    }

    fn set(&mut self, address: Address, bytes: &[u8]) {
        let number = |bytes: &[u8]| {
            let mut four = if bytes.last().is_some_and(|b| b & 0x80 != 0) { [0xFF; 4] } else { [0; 4] };
            four[..bytes.len()].copy_from_slice(bytes);
            i32::from_le_bytes(four)
        };
        match address.index() {
            0x6040 => self.outputs.controlword = Controlword(number(bytes) as u16),
            0x6060 => self.outputs.mode = Mode(number(bytes) as i8),
            0x607A => self.outputs.position = number(bytes),
            0x60FF => self.outputs.velocity = number(bytes),
            0x6071 => self.outputs.torque = number(bytes) as i16,
            _ => drop(self.dictionary.insert(address, bytes.into())),
        }
    }

    fn read(&mut self, address: Address, into: &mut [u8]) -> Outcome<usize> {
        if self.faults.mute {
            return Err(Refusal::NoAnswer);
        }
        let mut bytes = match self.live(address) {
            Some(bytes) if !self.faults.refuses => bytes,
            _ => return Err(Refusal::Abort(AbortCode::NO_OBJECT)),
        };
        bytes.resize(self.faults.answer_bytes.unwrap_or(bytes.len()), 0xAA);
        into.get_mut(..bytes.len()).ok_or(Refusal::TooLong)?.copy_from_slice(&bytes);
        Ok(bytes.len())
    }

    fn write(&mut self, address: Address, data: &[u8]) -> Outcome<()> {
        match (self.faults.mute, self.faults.refuses) {
            (true, _) => Err(Refusal::NoAnswer),
            (_, true) => Err(Refusal::Abort(AbortCode::DEVICE_STATE)),
            _ => {
                self.written.push((address, data.into()));
                self.set(address, data);
                Ok(())
            }
        }
    }

    fn swap(&mut self, outputs: &[u8], inputs: &mut [u8]) -> Outcome<usize> {
        if self.faults.cut_after.is_some_and(|cycles| self.frames.len() >= cycles) {
            return Err(Refusal::Link("the cable is off"));
        }
        self.frames.push(outputs.into());
        let mut at = 0;
        for entry in self.image.rx() {
            let next = at + usize::from(entry.bits() / 8);
            self.set(entry.address(), &outputs[at..next]);
            at = next;
        }
        let mut bytes = self.cycle().ok_or(Refusal::NoAnswer)?;
        bytes.resize(self.faults.frame_bytes.unwrap_or(bytes.len()), 0xAA);
        inputs.get_mut(..bytes.len()).ok_or(Refusal::TooLong)?.copy_from_slice(&bytes);
        Ok(bytes.len())
    }

    /// Waiting lets the drive run: without process data it takes what was written.
    fn idle(&mut self, until: Instant) {
        while self.now < until.micros() {
            self.cycle();
        }
    }
}

impl Transport for Bus {
    type Error = &'static str;

    fn upload(&mut self, address: Address, into: &mut [u8], _: Duration) -> Outcome<usize> {
        self.read(address, into)
    }

    fn download(&mut self, address: Address, data: &[u8], _: Duration) -> Outcome<()> {
        self.write(address, data)
    }

    fn exchange(&mut self, outputs: &[u8], inputs: &mut [u8]) -> Outcome<usize> {
        self.swap(outputs, inputs)
    }

    fn now(&mut self) -> Instant {
        Instant::from_micros(self.now)
    }

    fn wait(&mut self, until: Instant) {
        self.idle(until);
    }
}

/// A drive with everything in process data.
pub(crate) fn drive(fake: Fake) -> Drive<'static, Bus> {
    drive_with(fake, Image::new(&RX, &TX).unwrap(), AxisPolicy::default())
}

pub(crate) fn drive_with(fake: Fake, image: Image<'static>, policy: AxisPolicy) -> Drive<'static, Bus> {
    Drive::new(Client::new(&MODEL, image, policy), Bus::new(fake, image))
}
