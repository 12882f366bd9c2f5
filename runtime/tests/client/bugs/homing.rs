//! Homing.

use core::time::Duration;

use drivewright_runtime::cia402::{HomingState, Mode, ModeBits, State, Statusword};
use drivewright_runtime::client::axis::{Axis, AxisErrorKind, AxisPolicy, Progress};
use drivewright_runtime::client::error::{ClientError, DriveError};
use drivewright_runtime::client::home::Homing;

use super::{enabled, failure, off, policy};
use crate::bus::drive;
use crate::fake::{cycles, run, Fake};

const LONG: Duration = Duration::from_secs(10);
const ATTAINED: u16 = ModeBits::HOMING_ATTAINED | Statusword::TARGET_REACHED;

fn homing(bits: u16, fake: Fake, policy: AxisPolicy) -> (Axis, Fake) {
    let (mut axis, mut fake) = enabled(Mode::HOMING, policy, fake);
    fake.bits = bits;
    axis.home(LONG);
    (axis, fake)
}

#[test]
fn b20_homing_is_judged_after_its_start_only() {
    // What stands there before is nothing of this homing, whatever it is.
    for before in [0, Statusword::TARGET_REACHED, ATTAINED, ModeBits::HOMING_ERROR, ModeBits::HOMING_ATTAINED]
    {
        let (mut axis, mut fake) = homing(before, off(), AxisPolicy::default());
        assert_eq!(run(&mut axis, &mut fake), Progress::Done, "{before:04X}");
        let started = fake.heard.iter().position(|outputs| outputs.controlword.mode_4()).unwrap();
        assert!(fake.heard.len() > started + 50, "the drive takes 50 cycles");
        assert!(axis.is_homed());
    }
}

#[test]
fn b21_an_old_attained_is_no_success() {
    let (mut axis, mut fake) =
        homing(ATTAINED, off().with(|q| q.ignores_homing = true), AxisPolicy::default());
    let expected = AxisErrorKind::HomingNotStarted(HomingState::Completed);
    assert_eq!(failure(&mut axis, &mut fake), expected);
    assert!(!axis.is_homed());
    assert!(!fake.heard.last().unwrap().controlword.mode_4() || !axis.outputs().controlword.mode_4());
    // A drive that is known to keep bit 12 is believed when homing has had the time to start.
    let keeps = policy(|policy| policy.homing_clears_attained = false);
    let (mut axis, mut fake) = homing(ATTAINED, off().with(|q| q.keeps_attained = true), keeps);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
}

#[test]
fn b21_homing_on_the_spot_is_a_success_of_its_own() {
    let (mut axis, mut fake) =
        homing(Statusword::TARGET_REACHED, off().with(|q| q.homing_cycles = 0), AxisPolicy::default());
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
}

#[test]
fn b22_not_started_is_normal_before_and_an_error_if_it_lasts() {
    let idle = Statusword::TARGET_REACHED;
    let (mut axis, mut fake) = homing(idle, off().with(|q| q.ignores_homing = true), AxisPolicy::default());
    assert_eq!(failure(&mut axis, &mut fake), AxisErrorKind::HomingNotStarted(HomingState::NotStarted));
    // A short standstill at a reversal is no interruption, a long one is.
    for (cycles_idle, ends) in [(100, false), (600, true)] {
        let (mut axis, mut fake) =
            homing(idle, off().with(|q| q.homes_for_ever = true), AxisPolicy::default());
        cycles(&mut axis, &mut fake, 100);
        fake.bits = idle;
        cycles(&mut axis, &mut fake, cycles_idle);
        let interrupted =
            matches!(axis.progress(), Progress::Failed(e) if e.kind == AxisErrorKind::HomingInterrupted);
        assert_eq!(interrupted, ends, "{:?}", axis.progress());
    }
}

#[test]
fn b23_the_time_out_is_given_or_follows_from_the_way() {
    use drivewright_runtime::prelude::Value;
    let homing = Homing::method(1).travel(Value::revolutions(100), Value::rpm(100), Value::rpm(10));
    // A minute there, a minute back, 12 seconds for two revolutions at 10 rpm, two for ramps.
    assert_eq!(homing.time_out(), Duration::from_secs(60 + 60 + 12 + 2));
    assert_eq!(homing.within(LONG).time_out(), LONG);
    let (mut axis, mut fake) = enabled(Mode::HOMING, AxisPolicy::default(), off());
    fake.quirks.homes_for_ever = true;
    axis.home(Duration::from_secs(3));
    let Progress::Failed(error) = run(&mut axis, &mut fake) else { panic!() };
    assert_eq!(error.kind, AxisErrorKind::HomingTooLong(HomingState::InProgress));
    assert_eq!(error.waited, Duration::from_secs(3));
    cycles(&mut axis, &mut fake, 2);
    assert!(!fake.heard.last().unwrap().controlword.mode_4(), "homing is ended, too");
}

#[test]
fn b24_nothing_homes_but_a_call() {
    let mut drive = drive(off());
    drive.bus().fake.ends_quick_stop_at_once = true;
    drive.enable(Mode::HOMING).unwrap();
    for _ in 0..100 {
        drive.cycle().unwrap();
    }
    drive.quick_stop().unwrap();
    drive.disable().unwrap();
    assert!(drive.bus().fake.heard.iter().all(|outputs| !outputs.controlword.mode_4()));
    assert!(!drive.client().axis().is_homed());
}

#[test]
fn b25_method_0_is_no_homing() {
    let mut drive = drive(off());
    drive.enable(Mode::PROFILE_POSITION).unwrap();
    let refused = DriveError::Client(ClientError::NotAHomingMethod { method: 0 });
    assert_eq!(drive.home(Homing::method(0)), Err(refused));
    assert!(drive.bus().written.is_empty());
}

#[test]
fn b25_a_homed_axis_can_skip_it() {
    let mut drive = drive(off());
    drive.enable(Mode::PROFILE_POSITION).unwrap();
    drive.home(Homing::method(1).unless_homed()).unwrap();
    let cycles = drive.bus().fake.heard.len();
    drive.home(Homing::method(1).unless_homed()).unwrap();
    assert_eq!(drive.bus().fake.heard.len(), cycles);
}

#[test]
fn b27_a_master_learns_who_owns_the_position() {
    let (mut axis, mut fake) = enabled(Mode::CYCLIC_POSITION, AxisPolicy::default(), off());
    assert!(!axis.position_is_owned_by_drive());
    axis.select_mode(Mode::HOMING);
    assert!(axis.position_is_owned_by_drive(), "from the moment on in which it is asked for");
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    axis.home(LONG);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    assert!(axis.position_is_owned_by_drive());
    fake.position = -70_000;
    cycles(&mut axis, &mut fake, 1);
    axis.select_mode(Mode::CYCLIC_POSITION);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    assert!(!axis.position_is_owned_by_drive());
    assert_eq!(axis.outputs().position, -70_000, "the target follows the new zero");
    fake.fault(1);
    cycles(&mut axis, &mut fake, 3);
    assert!(axis.position_is_owned_by_drive());
}

#[test]
fn a_homing_that_fails_tells_its_state() {
    let (mut axis, mut fake) = homing(0, off().with(|q| q.homing_fails = true), AxisPolicy::default());
    assert_eq!(failure(&mut axis, &mut fake), AxisErrorKind::HomingFailed(HomingState::ErrorStopped));
    let (mut axis, mut fake) = homing(0, off(), AxisPolicy::default());
    cycles(&mut axis, &mut fake, 30);
    fake.bits = ModeBits::HOMING_ERROR | ATTAINED;
    assert_eq!(failure(&mut axis, &mut fake), AxisErrorKind::HomingFailed(HomingState::Reserved));
}

#[test]
fn homing_needs_operation_and_its_mode() {
    let (mut axis, mut fake) = enabled(Mode::CYCLIC_POSITION, AxisPolicy::default(), off());
    axis.home(LONG);
    let shown = Some(Mode::CYCLIC_POSITION);
    assert_eq!(failure(&mut axis, &mut fake), AxisErrorKind::WrongMode { shown });
    let mut drive = drive(Fake::new(State::SwitchedOn));
    let error = drive.home(Homing::method(1)).unwrap_err();
    assert!(matches!(error, DriveError::Client(ClientError::Axis(e)) if e.kind == AxisErrorKind::NotEnabled));
    assert!(drive.bus().written.is_empty(), "nothing was written");
}
