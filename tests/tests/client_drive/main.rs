//! The client against the virtual drive of the SDV3-E: every mode, every option code, every alarm, every disturbance. Each
//! call ends, with what was asked for or with a typed error.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test")]

mod disturbances;
mod faults;
mod modes;

use std::convert::Infallible;
use std::time::Duration;

use drivewright_runtime::client::axis::{AxisErrorKind, AxisPolicy};
use drivewright_runtime::client::drive::Drive;
use drivewright_runtime::client::error::{ClientError, DriveError};
use drivewright_runtime::client::image::Image;
use drivewright_runtime::client::session::Client;
use drivewright_runtime::sim::plant::{Plant, PlantConfig};
use drivewright_runtime::sim::{Config, Disturbed, Link, VirtualDrive, cells};
use savch_sdv3_e::MODEL;

const CYCLE: Duration = Duration::from_millis(1);
const LONG: Duration = Duration::from_secs(30);
/// User units of a revolution: 131,072 counts of the configuration over 16 of 6093h.
const TURN: i32 = 8_192;

type Bus = Disturbed<'static, 'static, 'static>;
type Test = Drive<'static, Bus>;

/// Everything by process data.
fn drive() -> Test {
    on(Image::of(&MODEL, 0x1600, 0x1A00).unwrap())
}

fn on(image: Image<'static>) -> Test {
    let memory = vec![0; cells(&MODEL)].leak();
    let drive = VirtualDrive::new(&MODEL, memory, Config::default()).unwrap();
    let drive = Box::leak(Box::new(drive.with_axis(Plant::new(PlantConfig::default()).unwrap())));
    let mut bus = Disturbed::new(Link::new(drive, CYCLE));
    bus.link().start().unwrap();
    Drive::new(Client::new(&MODEL, image, AxisPolicy::default()), bus)
}

fn kind(result: Result<(), DriveError<Infallible>>) -> AxisErrorKind {
    match result {
        Err(DriveError::Client(ClientError::Axis(error))) => error.kind,
        other => panic!("{other:?}"),
    }
}

fn cycles(drive: &mut Test, n: usize) {
    for _ in 0..n {
        drive.cycle().unwrap();
    }
}

fn position(drive: &mut Test) -> i32 {
    drive.cycle().unwrap().unwrap().position.unwrap()
}
