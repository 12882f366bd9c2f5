//! The virtual drive on the model of the SDV3-E: what its manual prints is what it does. Expected values come from the
//! manual and from CiA 402.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod alarms;
mod bus;
mod chaos;
mod homing;
mod modes;
mod process_data;
mod sdo;
mod states;

use std::time::Duration;

use drivewright_runtime::AbortCode;
use drivewright_runtime::Address;
use drivewright_runtime::DataType;
use drivewright_runtime::DriveModel;
use drivewright_runtime::sim::plant::{Plant, PlantConfig};
use drivewright_runtime::sim::{Config, NoAnswer, VirtualDrive, cells};
use savch_sdv3_e::MODEL;

/// Counts of the encoder in a user unit: 6093h as the drive ships.
const GEAR: i64 = 16;
/// Counts of a revolution: the default of the configuration.
const REVOLUTION: i64 = 131_072;
/// User units of a revolution.
const TURN: i64 = REVOLUTION / GEAR;

const fn at(index: u16, sub: u8) -> Address {
    Address::new(index, sub)
}

/// A drive that has started up.
struct Rig {
    drive: VirtualDrive<'static, 'static>,
}

impl Rig {
    fn new() -> Self {
        Self::with(Config::default(), PlantConfig::default())
    }

    fn with(config: Config, axis: PlantConfig) -> Self {
        Self::of(&MODEL, config, axis)
    }

    fn of(model: &'static DriveModel<'static>, config: Config, axis: PlantConfig) -> Self {
        let memory = vec![0; cells(model)].leak();
        let drive = VirtualDrive::new(model, memory, config).unwrap();
        let mut rig = Self { drive: drive.with_axis(Plant::new(axis).unwrap()) };
        rig.drive.advance(Duration::from_millis(100));
        rig
    }

    /// Enabled in a mode.
    fn enabled(mode: i64) -> Self {
        let mut rig = Self::new();
        rig.enable(mode);
        rig
    }

    fn enable(&mut self, mode: i64) {
        self.write(0x6060, 0, mode).unwrap();
        for word in [0x06, 0x07, 0x0F] {
            self.word(word);
        }
        assert_eq!(self.status() & 0x6F, 0x27, "{:04X}", self.status());
    }

    fn run(&mut self, millis: u64) {
        self.drive.advance(Duration::from_millis(millis));
    }

    /// Runs until the statusword has these bits; fails after a minute.
    fn until(&mut self, mask: u16, value: u16) -> u64 {
        for millis in 0..60_000 {
            if self.status() & mask == value {
                return millis;
            }
            self.run(1);
        }
        panic!("statusword {:04X}, expected {value:04X} under {mask:04X}", self.status());
    }

    /// The position once the axis rests: the target counts as reached within a window.
    fn settled(&mut self) -> i64 {
        self.run(500);
        self.read(0x6064, 0)
    }

    fn status(&self) -> u16 {
        self.drive.statusword().0
    }

    /// Writes the controlword, lets a cycle pass, and gives the statusword.
    fn word(&mut self, word: i64) -> u16 {
        self.write(0x6040, 0, word).unwrap();
        self.run(1);
        self.status()
    }

    fn type_of(index: u16, sub: u8) -> DataType {
        MODEL.object(at(index, sub)).unwrap().data_type()
    }

    fn write(&mut self, index: u16, sub: u8, value: i64) -> Result<(), AbortCode> {
        let data = value.to_le_bytes();
        self.write_bytes(index, sub, &data[..Self::type_of(index, sub).bytes()])
    }

    fn write_bytes(&mut self, index: u16, sub: u8, data: &[u8]) -> Result<(), AbortCode> {
        self.drive.download(at(index, sub), data).map_err(|why| match why {
            NoAnswer::Abort(code) => code,
            other => panic!("{other}"),
        })
    }

    fn read(&mut self, index: u16, sub: u8) -> i64 {
        let mut data = [0; 8];
        let length = self.drive.upload(at(index, sub), &mut data).unwrap();
        i64::try_from(Self::type_of(index, sub).decode_int(&data[..length]).unwrap()).unwrap()
    }
}
