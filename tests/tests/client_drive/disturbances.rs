//! What wires and supplies do: each call ends, and nothing is enabled again by itself.

use std::time::Duration;

use drivewright_runtime::AbortCode;
use drivewright_runtime::cia402::{Mode, State};
use drivewright_runtime::client::home::Homing;
use drivewright_runtime::client::image::Image;
use drivewright_runtime::client::moves::MoveTo;
use drivewright_runtime::prelude::Value;
use drivewright_runtime::procedure::Policy;
use drivewright_runtime::sim::Disturbance;

use crate::{LONG, TURN, Test, cycles, drive, on};

const EVERYTHING: [Disturbance; 13] = [
    Disturbance::LostRequest,
    Disturbance::LostAnswer,
    Disturbance::LateAnswer(200),
    Disturbance::LateAnswer(700),
    Disturbance::WrongAbort(AbortCode::GENERAL),
    Disturbance::ShortAnswer,
    Disturbance::LongAnswer,
    Disturbance::LostCycle,
    Disturbance::FrozenInputs,
    Disturbance::ShortInputs,
    Disturbance::NoTorque,
    Disturbance::MainsDip,
    Disturbance::SupplyDip,
];

/// All that a program does; how far it comes is up to what goes wrong.
fn program(drive: &mut Test) -> Vec<bool> {
    vec![
        drive.enable(Mode::PROFILE_POSITION).is_ok(),
        drive.home(Homing::method(35).within(LONG)).is_ok(),
        drive.move_to(MoveTo::to(i64::from(TURN)).velocity(Value::rpm(600)).within(LONG)).is_ok(),
        drive.velocity(Value::rpm(100), LONG).is_ok(),
        drive.quick_stop().is_ok(),
        drive.reset_fault().is_ok(),
        drive.disable().is_ok(),
    ]
}

#[test]
fn every_disturbance_at_every_place_ends() {
    for what in EVERYTHING {
        for after in [0, 1, 2, 3, 5, 8, 13, 21, 34, 55, 100, 200, 400] {
            for times in [1, 5, 150] {
                for image in
                    [Image::of(&savch_sdv3_e::MODEL, 0x1600, 0x1A00).unwrap(), Image::new(&[], &[]).unwrap()]
                {
                    let mut drive = on(image);
                    drive.bus().disturb(what, after, times);
                    program(&mut drive);
                }
            }
        }
    }
}

#[test]
fn stuck_bits_of_the_statusword_end() {
    for bit in 0..16 {
        for value in [0, 1 << bit] {
            let mut drive = drive();
            drive.bus().disturb(Disturbance::StuckStatus { mask: 1 << bit, value }, 40, 1_000_000);
            program(&mut drive);
        }
    }
}

#[test]
fn what_left_operation_does_not_come_back_by_itself() {
    for what in [Disturbance::NoTorque, Disturbance::MainsDip, Disturbance::SupplyDip, Disturbance::LostCycle]
    {
        let mut drive = drive();
        drive.enable(Mode::PROFILE_VELOCITY).unwrap();
        drive.velocity(Value::rpm(100), LONG).unwrap();
        drive.bus().disturb(what, 5, 300);
        let tripped = (0..2_000).filter(|_| drive.cycle().is_err()).count();
        assert_eq!(tripped, 1, "{what:?}: told once");
        assert!(!drive.client().axis().is_enabled());
        drive.bus().calm();
        cycles(&mut drive, 500);
        assert_ne!(drive.bus().drive().state(), State::OperationEnabled, "{what:?}");
    }
}

#[test]
fn one_lost_cycle_and_one_lost_answer_are_borne() {
    for what in [Disturbance::LostCycle, Disturbance::FrozenInputs, Disturbance::ShortInputs] {
        for after in 0..60 {
            let mut drive = drive();
            drive.bus().disturb(what, after, 1);
            drive
                .enable(Mode::PROFILE_POSITION)
                .unwrap_or_else(|error| panic!("{what:?} after {after}: {error}"));
            drive.move_to(MoveTo::to(i64::from(TURN)).velocity(Value::rpm(600))).unwrap();
        }
    }
    for after in 0..12 {
        // Shorter than the watchdog of the process data, which rest meanwhile.
        let policy = Policy { answer_within: Duration::from_millis(20), retries: 2 };
        let mut drive = drive().with_policy(policy);
        drive.bus().disturb(Disturbance::LostAnswer, after, 2);
        drive.enable(Mode::PROFILE_POSITION).unwrap();
        drive.home(Homing::method(35)).unwrap();
    }
}
