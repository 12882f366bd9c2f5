//! Homing: the result is that of this homing.

use std::time::Duration;

use drivewright_runtime::cia402::{HomingState, Mode};
use drivewright_runtime::client::axis::{AxisErrorKind, AxisPolicy, Progress};

use super::{DISABLED, ENABLED, READY, Rig, SWITCHED_ON};

/// Bits 10, 12 and 13.
const REACHED: u16 = 0x0400;
const ATTAINED: u16 = 0x1000;

const MINUTE: Duration = Duration::from_mins(1);

fn homing() -> Rig {
    let mut rig = Rig::enabled(AxisPolicy::default(), Mode::HOMING);
    rig.axis.home(MINUTE);
    rig
}

#[test]
fn b20_what_is_shown_before_the_start_is_no_result() {
    let mut rig = homing();
    let mut word = 0;
    while word & 0x10 == 0 {
        word = rig.see(ENABLED | REACHED | ATTAINED).controlword.0;
        assert_eq!(rig.axis.progress(), Progress::Pending);
    }
    // The drive has not seen bit 4 yet.
    rig.stay(ENABLED | REACHED | ATTAINED, 3);
    assert_eq!(rig.axis.progress(), Progress::Pending);
    rig.stay(ENABLED, 20);
    rig.until_the_end(ENABLED | REACHED | ATTAINED);
    assert_eq!(rig.axis.progress(), Progress::Done);
}

#[test]
fn b21_an_old_home_is_not_that_of_this_homing() {
    let mut rig = homing();
    rig.until_the_end(ENABLED | REACHED | ATTAINED);
    assert_eq!(rig.failed(), Some(AxisErrorKind::HomingNotStarted(HomingState::Completed)));
    assert!(!rig.axis.is_homed());
}

#[test]
fn b22_not_started_is_normal_before_the_start() {
    let mut rig = homing();
    while rig.see(ENABLED | REACHED).controlword.0 & 0x10 == 0 {
        assert_eq!(rig.axis.progress(), Progress::Pending);
    }
    rig.stay(ENABLED | REACHED, 3);
    rig.stay(ENABLED, 5);
    rig.until_the_end(ENABLED | REACHED | ATTAINED);
    assert_eq!(rig.axis.progress(), Progress::Done);
}

#[test]
fn b23_homing_takes_as_long_as_it_was_given() {
    let mut rig = homing();
    rig.stay(ENABLED | REACHED, 5);
    rig.stay(ENABLED, 4_500);
    assert_eq!(rig.axis.progress(), Progress::Pending, "after 45 of 60 seconds");
    rig.stay(ENABLED, 2_000);
    assert_eq!(rig.failed(), Some(AxisErrorKind::HomingTooLong(HomingState::InProgress)));
    assert_eq!(rig.axis.outputs().controlword.0 & 0x10, 0, "it is ended");
}

#[test]
fn b24_no_homing_without_a_call() {
    let mut rig = Rig::new(AxisPolicy::default());
    rig.axis.enable(Mode::HOMING);
    rig.shown.mode = Some(Mode::HOMING);
    let mut sent = Vec::new();
    for word in [DISABLED, READY, SWITCHED_ON, ENABLED] {
        sent.extend(rig.stay(word, 20));
    }
    assert_eq!(rig.axis.progress(), Progress::Done);
    assert!(sent.iter().all(|o| !o.controlword.mode_4()));
}

#[test]
fn b27_the_drive_owns_the_position_while_it_homes() {
    let mut rig = homing();
    rig.stay(ENABLED, 10);
    assert!(rig.axis.position_is_owned_by_drive());
    let rig = Rig::enabled(AxisPolicy::default(), Mode::CYCLIC_POSITION);
    assert!(!rig.axis.position_is_owned_by_drive());
}
