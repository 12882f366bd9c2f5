//! Every mode that the manual lists, and the option codes.

use drivewright_runtime::Address;
use drivewright_runtime::cia402::{Mode, State};
use drivewright_runtime::client::axis::{AxisErrorKind, Request};
use drivewright_runtime::client::error::{ClientError, DriveError};
use drivewright_runtime::client::home::Homing;
use drivewright_runtime::client::image::Image;
use drivewright_runtime::client::moves::MoveTo;
use drivewright_runtime::client::session::Plan;
use drivewright_runtime::prelude::*;
use savch_sdv3_e::MODEL;

use crate::{LONG, TURN, cycles, drive, kind, on, position};

/// 6067h as the drive ships.
const WINDOW: i32 = 100;

fn is_near(position: i32, expected: i32) -> bool {
    position.abs_diff(expected) <= WINDOW.unsigned_abs()
}

#[test]
fn profile_position_absolute_relative_and_at_once() {
    let mut drive = drive();
    drive.enable(Mode::PROFILE_POSITION).unwrap();
    drive.move_to(MoveTo::to(i64::from(TURN)).velocity(Value::rpm(600))).unwrap();
    assert!(is_near(position(&mut drive), TURN));
    drive.move_to(MoveTo::by(i64::from(-3 * TURN))).unwrap();
    assert!(is_near(position(&mut drive), -2 * TURN), "{}", position(&mut drive));
    // On the way to somewhere else, back at once.
    let away = drive.move_to(MoveTo::to(i64::from(100 * TURN)).within(std::time::Duration::from_millis(200)));
    assert_eq!(kind(away), AxisErrorKind::TimedOut);
    drive.move_to(MoveTo::to(0).immediately()).unwrap();
    assert!(is_near(position(&mut drive), 0));
}

#[test]
fn profile_velocity_and_a_jog() {
    let mut drive = drive();
    drive.enable(Mode::PROFILE_VELOCITY).unwrap();
    drive.velocity(Value::rpm(-500), LONG).unwrap();
    let speed = drive.cycle().unwrap().unwrap().velocity.unwrap();
    assert!((-5_100..=-4_900).contains(&speed), "{speed} in 0.1 rpm");
    drive.velocity(0, LONG).unwrap();
    let mut held = 0;
    drive
        .jog(Value::rpm(30), LONG, || {
            held += 1;
            held < 100
        })
        .unwrap();
    let speed = drive.cycle().unwrap().unwrap().velocity.unwrap();
    assert!(speed.abs() <= 100, "{speed} in 0.1 rpm");
}

#[test]
fn profile_torque() {
    let mut drive = drive();
    drive.enable(Mode::PROFILE_TORQUE).unwrap();
    drive.torque(Value::percent_torque(5), LONG).unwrap();
    cycles(&mut drive, 20);
    assert!(drive.cycle().unwrap().unwrap().velocity.unwrap() > 0, "it turns");
    drive.torque(0, LONG).unwrap();
}

#[test]
fn homing_by_switch_and_on_the_spot() {
    let mut drive = drive();
    drive.enable(Mode::CYCLIC_POSITION).unwrap();
    let homing = |method| {
        Homing::method(method).travel(Value::revolutions(60), Value::rpm(1_200), Value::rpm(60)).offset(0)
    };
    for method in [1, 17, 3, 35] {
        drive.home(homing(method)).unwrap();
        assert!(drive.client().axis().is_homed());
        assert_eq!(drive.client().axis().outputs().mode, Mode::CYCLIC_POSITION, "the mode of before");
        cycles(&mut drive, 10);
        assert!(drive.client().axis().is_enabled(), "the new zero is no jump");
    }
    // 15 is reserved: no method of this drive.
    let refused = drive.home(homing(15)).unwrap_err();
    assert_eq!(refused, DriveError::Client(ClientError::NotAHomingMethod { method: 15 }));
}

#[test]
fn cyclic_position_follows_a_path() {
    let mut drive = drive();
    drive.enable(Mode::CYCLIC_POSITION).unwrap();
    let start = drive.client().axis().outputs().position;
    for step in 1..=500 {
        drive.client_mut().axis_mut().target_position(start + step * 10).unwrap();
        drive.cycle().unwrap();
    }
    cycles(&mut drive, 300);
    let end = position(&mut drive);
    assert!(is_near(end, start + 5_000), "{start} to {end}");
}

#[test]
fn cyclic_velocity_and_cyclic_torque() {
    let mut drive = drive();
    drive.enable(Mode::CYCLIC_VELOCITY).unwrap();
    drive.client_mut().axis_mut().target_velocity(1_000).unwrap();
    cycles(&mut drive, 300);
    let speed = drive.cycle().unwrap().unwrap().velocity.unwrap();
    assert!((900..=1_100).contains(&speed), "{speed} in 0.1 rpm");
    // Another mode under power takes nothing over.
    drive.enable(Mode::CYCLIC_TORQUE).unwrap();
    assert_eq!(drive.client().axis().outputs().velocity, 0);
    drive.client_mut().axis_mut().target_torque(-50).unwrap();
    cycles(&mut drive, 50);
    drive.enable(Mode::CYCLIC_POSITION).unwrap();
    cycles(&mut drive, 500);
    assert!(drive.client().axis().is_enabled(), "{:?}", drive.client().axis().trip());
}

#[test]
fn a_mode_that_the_manual_does_not_list_is_refused() {
    let mut drive = drive();
    let refused = kind(drive.enable(Mode::INTERPOLATED_POSITION));
    assert!(
        matches!(refused, AxisErrorKind::ModeNotSupported { .. }),
        "6502h says that there is one: erratum E003"
    );
}

#[test]
fn a_quick_stop_by_every_option_code() {
    for (code, stays) in [(0, false), (1, false), (5, true)] {
        let mut drive = drive();
        drive.write(Address::new(0x605A, 0), code).unwrap();
        drive.enable(Mode::PROFILE_VELOCITY).unwrap();
        drive.velocity(Value::rpm(500), LONG).unwrap();
        drive.quick_stop().unwrap();
        cycles(&mut drive, 2_000);
        let state = drive.cycle().unwrap().unwrap().statusword.state();
        assert_eq!(
            state,
            Some(if stays { State::QuickStopActive } else { State::SwitchOnDisabled }),
            "{code}"
        );
        let resumed = drive.resume();
        if stays {
            resumed.unwrap();
        } else {
            assert_eq!(kind(resumed), AxisErrorKind::NotQuickStopped);
        }
    }
}

#[test]
fn from_every_state_to_every_state() {
    let goals = [State::SwitchOnDisabled, State::ReadyToSwitchOn, State::SwitchedOn, State::OperationEnabled];
    for from in goals {
        for to in goals {
            let mut drive = drive();
            drive.select_mode(Mode::PROFILE_VELOCITY).unwrap();
            drive.reach(from).unwrap();
            assert_eq!(drive.bus().drive().state(), from);
            drive.reach(to).unwrap();
            assert_eq!(drive.bus().drive().state(), to, "from {from}");
        }
    }
}

#[test]
fn by_sdo_alone_and_with_a_short_layout() {
    // 1602h carries controlword and target velocity, 1A02h statusword and velocity: the rest goes by SDO.
    for image in [Image::new(&[], &[]).unwrap(), Image::of(&MODEL, 0x1602, 0x1A02).unwrap()] {
        let mut drive = on(image);
        // Assigned as the image has it.
        for (assign, index) in [(0x1C12, 0x1602), (0x1C13, 0x1A02)] {
            let bus = drive.bus();
            bus.drive().request(EsmState::PreOp).unwrap();
            bus.drive().download(Address::new(assign, 0), &[0]).unwrap();
            bus.drive().download(Address::new(assign, 1), &u16::to_le_bytes(index)).unwrap();
            bus.drive().download(Address::new(assign, 0), &[1]).unwrap();
        }
        if !image.is_empty() {
            drive.bus().link().start().unwrap();
        }
        drive.enable(Mode::PROFILE_POSITION).unwrap();
        drive.move_to(MoveTo::to(i64::from(TURN)).velocity(Value::rpm(600))).unwrap();
        let there = i32::try_from(drive.read(Address::new(0x6064, 0)).unwrap()).unwrap();
        assert!(is_near(there, TURN), "{there}");
        drive.run(Plan::goal(Request::Shutdown)).unwrap();
        assert_eq!(drive.bus().drive().state(), State::ReadyToSwitchOn);
    }
}
