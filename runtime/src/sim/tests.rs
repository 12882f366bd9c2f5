//! The drive as a whole, on a small model made by hand that follows CiA 402: expected values are those of the standard.

use core::time::Duration;

use super::plant::{Plant, PlantConfig, Switches};
use super::samples::{at, MODEL};
use super::*;
use crate::cia402::State;
use crate::model::EsmState;

const REVOLUTION: i64 = 131_072;

/// Runs a check on a drive that has started up.
fn with(check: impl FnOnce(&mut VirtualDrive<'_, '_>)) {
    let mut cells = [0; cells(&MODEL)];
    let mut drive = VirtualDrive::new(&MODEL, &mut cells, Config::default()).unwrap();
    drive.advance(Duration::from_millis(100));
    check(&mut drive);
}

fn write(drive: &mut VirtualDrive<'_, '_>, index: u16, value: i64) {
    let length = MODEL.object(at(index, 0)).unwrap().data_type().bytes();
    drive.download(at(index, 0), &value.to_le_bytes()[..length]).unwrap();
}

/// A word for a cycle; gives the statusword.
fn word(drive: &mut VirtualDrive<'_, '_>, word: i64) -> u16 {
    write(drive, 0x6040, word);
    drive.step();
    drive.statusword().0
}

fn enable(drive: &mut VirtualDrive<'_, '_>, mode: i64) {
    write(drive, 0x6060, mode);
    for command in [6, 7, 15] {
        word(drive, command);
    }
    assert_eq!(drive.state(), State::OperationEnabled);
}

fn until(drive: &mut VirtualDrive<'_, '_>, mask: u16, value: u16) {
    let reached = (0..60_000).any(|_| {
        drive.step();
        drive.statusword().0 & mask == value
    });
    assert!(reached, "{:04X}", drive.statusword().0);
}

#[test]
fn a_quick_stop_by_its_ramp_that_stays() {
    with(|drive| {
        write(drive, 0x605A, 6);
        enable(drive, 3);
        write(drive, 0x60FF, 100_000);
        until(drive, 0x0400, 0);
        until(drive, 0x0400, 0x0400);
        assert_eq!(word(drive, 2) & 0x6F, 0x07);
        drive.advance(Duration::from_millis(500));
        assert_eq!((drive.state(), drive.axis().standstill()), (State::QuickStopActive, true));
        assert_eq!(word(drive, 15) & 0x6F, 0x27, "transition 16");
    });
}

#[test]
fn bit_6_is_relative_and_bit_12_of_speed_is_zero() {
    with(|drive| {
        enable(drive, 1);
        write(drive, 0x6081, 100_000);
        write(drive, 0x607A, 10_000);
        for (command, turns) in [(0x1F, 1), (0x5F, 2), (0x1F, 1)] {
            word(drive, command);
            word(drive, 0x0F);
            until(drive, 0x1400, 0x0400);
            drive.advance(Duration::from_millis(500));
            assert_eq!(drive.axis().position(), turns * REVOLUTION, "{command:X}");
        }
        write(drive, 0x6060, 3);
        drive.step();
        assert_eq!(drive.statusword().0 & 0x1400, 0x1400, "speed zero, and as wanted");
        write(drive, 0x60FF, 100_000);
        until(drive, 0x1400, 0x0400);
    });
}

#[test]
fn torque_is_limited_and_follows() {
    with(|drive| {
        enable(drive, 4);
        write(drive, 0x6072, 500);
        write(drive, 0x6071, 800);
        drive.step();
        drive.step();
        assert_eq!((drive.value(at(0x6074, 0)), drive.value(at(0x6077, 0))), (Some(500), Some(500)));
        assert_eq!(drive.statusword().0 & 0x0400, 0x0400);
    });
}

#[test]
fn homing_finds_the_edge_and_sets_zero() {
    with(|drive| {
        write(drive, 0x6098, 17);
        enable(drive, 6);
        assert_eq!(word(drive, 0x1F) & 0x3400, 0);
        until(drive, 0x3400, 0x1400);
        assert_eq!(drive.origin(), Switches::default().negative_limit.unwrap());
        write(drive, 0x6098, 15);
        word(drive, 0x0F);
        assert_eq!(word(drive, 0x1F) & 0x3400, 0x2400, "reserved");
    });
}

#[test]
fn a_drive_without_an_alarm_for_it_shows_bits_only() {
    with(|drive| {
        enable(drive, 6);
        write(drive, 0x6060, 1);
        drive.step();
        assert_eq!((drive.state(), drive.mode().0), (State::OperationEnabled, 1));
        drive.allow_torque(false);
        drive.step();
        assert_eq!((drive.state(), drive.statusword().0), (State::SwitchOnDisabled, 0x0240));
    });
}

#[test]
fn an_axis_of_the_user_is_where_it_says() {
    let mut cells = [0; cells(&MODEL)];
    let drive = VirtualDrive::new(&MODEL, &mut cells, Config::default()).unwrap();
    let axis = Plant::new(PlantConfig { start: 777, ..PlantConfig::default() }).unwrap();
    let mut drive = drive.with_axis(axis);
    drive.advance(Duration::from_millis(100));
    assert_eq!((drive.origin(), drive.axis().position()), (777, 777));
    assert_eq!(drive.request(EsmState::Op), Err(BusRefusal::InvalidChange));
}

#[test]
fn assumptions_have_reasons() {
    let mut about: std::vec::Vec<&str> = VirtualDrive::assumptions().map(|row| row.about).collect();
    assert!(VirtualDrive::assumptions().all(|row| !row.is.is_empty() && !row.because.is_empty()));
    let rows = about.len();
    about.sort_unstable();
    about.dedup();
    assert_eq!(about.len(), rows);
}
