//! The virtual drive with the model of a generated crate: SDO, process data, time, alarms.

use core::hint::black_box;
use core::time::Duration;

use drivewright_runtime::model::EsmState;
use drivewright_runtime::sim::{cells, Config, Link, VirtualDrive};
use drivewright_runtime::Address;
use savch_sdv3_e::MODEL;

const CELLS: usize = cells(&MODEL);

fn act(drive: &mut VirtualDrive<'_, '_>, bytes: &mut [u8]) {
    let address = Address::new(black_box(0x6040), black_box(0));
    match black_box(0_u8) {
        0 => _ = black_box(drive.upload(address, bytes)),
        1 => _ = black_box(drive.download(address, bytes)),
        2 => _ = black_box(drive.request(EsmState::PreOp)),
        3 => _ = black_box(drive.request(EsmState::SafeOp)),
        4 => _ = black_box(drive.request(EsmState::Op)),
        5 => _ = black_box(drive.request(EsmState::Init)),
        6 => _ = black_box(drive.receive(bytes)),
        7 => _ = black_box(drive.send(bytes)),
        8 => _ = black_box(drive.raise("OF", black_box(0x25))),
        9 => _ = black_box(drive.raise_for_good("OF", black_box(0x25))),
        10 => _ = black_box(drive.end_cause("OF", black_box(0x25))),
        11 => drive.set_probe(black_box(1), black_box(true)),
        _ => drive.advance(Duration::from_micros(black_box(u64::MAX))),
    }
    black_box((
        drive.emergency(),
        drive.alarms().count(),
        drive.value(address),
        drive.statusword(),
        drive.mode(),
    ));
}

/// Everything of this file.
pub fn run(bytes: &mut [u8]) {
    let mut memory = [0; CELLS];
    let mut config = Config::default();
    config.cycle = Duration::from_micros(black_box(u64::MAX));
    config.counts_per_revolution = black_box(u32::MAX);
    config.ramp_speed = black_box(0);
    config.quick_stop_ramp = black_box(0);
    config.target_jump = black_box(u8::MAX);
    let length = black_box(CELLS).min(memory.len());
    let room = memory.get_mut(..length).unwrap_or_default();
    let Ok(mut drive) = VirtualDrive::new(&MODEL, room, config) else { return };
    while black_box(true) {
        act(&mut drive, bytes);
    }
    let mut link = Link::new(&mut drive, Duration::from_micros(black_box(u64::MAX)));
    _ = black_box(link.start());
    crate::client::run(link);
}
