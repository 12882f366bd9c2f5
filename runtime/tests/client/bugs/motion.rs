//! Set-points, targets, units, writes.

use core::time::Duration;

use drivewright_runtime::abort::AbortCode;
use drivewright_runtime::cia402::{Controlword, Mode, ModeBits, State};
use drivewright_runtime::client::axis::{Axis, AxisErrorKind, AxisPolicy, Progress, SetPoint, StepLimits};
use drivewright_runtime::client::error::{ClientError, DriveError};
use drivewright_runtime::client::image::Image;
use drivewright_runtime::client::moves::MoveTo;
use drivewright_runtime::client::object::Cause;
use drivewright_runtime::client::session::Client;
use drivewright_runtime::prelude::*;

use super::{enabled, failure, off, policy};
use crate::bus::{drive, drive_with, MODEL, RX, TX};
use crate::fake::{cycles, run, Fake};

const LONG: Duration = Duration::from_secs(10);

fn positioning(fake: Fake, policy: AxisPolicy) -> (Axis, Fake) {
    enabled(Mode::PROFILE_POSITION, policy, fake)
}

#[test]
fn b28_the_target_is_there_before_the_edge() {
    let (mut axis, mut fake) = positioning(off(), AxisPolicy::default());
    axis.move_to(SetPoint::to(1_000), LONG);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    let edge = fake.heard.iter().position(|outputs| outputs.controlword.mode_4()).unwrap();
    assert_eq!((fake.heard[edge].position, fake.heard[edge - 1].position), (1_000, 1_000));
    // By SDO, the controlword is the last to be written.
    let image = Image::new(&[], &[]).unwrap();
    let mut drive = drive_with(off(), image, AxisPolicy::default());
    drive.enable(Mode::PROFILE_POSITION).unwrap();
    drive.move_to(MoveTo::to(77)).unwrap();
    let written = &drive.bus().written;
    let target = written.iter().position(|(at, _)| at.index() == 0x607A).unwrap();
    let edge = written.iter().position(|(at, bytes)| at.index() == 0x6040 && bytes[0] & 0x10 != 0).unwrap();
    assert!(target < edge);
}

#[test]
fn b29_every_set_point_has_an_edge_of_its_own() {
    let (mut axis, mut fake) = positioning(off(), AxisPolicy::default());
    for target in [100, 200, 200, -300] {
        let before = fake.heard.len();
        axis.move_to(SetPoint::to(target), LONG);
        assert_eq!(run(&mut axis, &mut fake), Progress::Done);
        assert_eq!(fake.position, target);
        let bits: Vec<bool> =
            fake.heard[before..].iter().map(|outputs| outputs.controlword.mode_4()).collect();
        let edges = bits.windows(2).filter(|pair| !pair[0] && pair[1]).count();
        assert_eq!((edges, bits.last()), (1, Some(&false)));
    }
}

#[test]
fn b29_a_hand_shake_that_fails_is_an_error() {
    let refuse = |change: fn(&mut crate::fake::Quirks)| {
        let (mut axis, mut fake) = positioning(off().with(change), AxisPolicy::default());
        axis.move_to(SetPoint::to(1), Duration::from_secs(3));
        let kind = failure(&mut axis, &mut fake);
        cycles(&mut axis, &mut fake, 2);
        assert!(!fake.heard.last().unwrap().controlword.mode_4());
        kind
    };
    assert_eq!(refuse(|quirks| quirks.never_acknowledges = true), AxisErrorKind::NotAcknowledged);
    assert_eq!(refuse(|quirks| quirks.acknowledge_stays = true), AxisErrorKind::AcknowledgeStays);
}

#[test]
fn b30_bit_12_may_be_high_before_the_first_set_point() {
    let high = || off().with(|quirks| quirks.acknowledge_is_high = true);
    let (mut axis, mut fake) = positioning(high(), AxisPolicy::default());
    axis.move_to(SetPoint::to(5), LONG);
    assert_eq!(failure(&mut axis, &mut fake), AxisErrorKind::AcknowledgeStays, "as the standard has it");
    let (mut axis, mut fake) = positioning(high(), policy(|policy| policy.acknowledge_may_be_high = true));
    axis.move_to(SetPoint::to(5), LONG);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    axis.move_to(SetPoint::to(6), LONG);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    assert_eq!(fake.position, 6);
}

#[test]
fn a_relative_move_and_one_at_once_have_their_bits() {
    let bits = |set_point: SetPoint, policy: AxisPolicy| {
        let (mut axis, mut fake) = positioning(off(), policy);
        axis.move_to(set_point, LONG);
        cycles(&mut axis, &mut fake, 6);
        let word = fake.heard.iter().map(|outputs| outputs.controlword).find(|word| word.mode_4());
        word.unwrap().0 & (ModeBits::RELATIVE | ModeBits::CHANGE_IMMEDIATELY)
    };
    let standard = AxisPolicy::default();
    assert_eq!(bits(SetPoint::to(1), standard), 0);
    assert_eq!(bits(SetPoint::by(1), standard), ModeBits::RELATIVE);
    assert_eq!(bits(SetPoint::to(1).immediately(), standard), ModeBits::CHANGE_IMMEDIATELY);
    let inverted = policy(|policy| policy.relative_bit_is_inverted = Some(true));
    assert_eq!(bits(SetPoint::to(1), inverted), ModeBits::RELATIVE);
    assert_eq!(bits(SetPoint::by(1), inverted), 0);
}

#[test]
fn b31_the_target_follows_the_axis_until_it_is_in_operation() {
    let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), off());
    fake.position = 1_203_441;
    axis.enable(Mode::CYCLIC_POSITION);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    assert_eq!(fake.position, 1_203_441);
    let enabling = fake.heard.iter().filter(|outputs| outputs.controlword.enable_operation());
    assert!(enabling.clone().count() > 0 && enabling.clone().all(|outputs| outputs.position == 1_203_441));
    // From then on it is held: an axis that is pushed away is not followed.
    fake.position = 1_203_000;
    cycles(&mut axis, &mut fake, 5);
    assert_eq!(axis.outputs().position, 1_203_441);
}

#[test]
fn b31_a_target_elsewhere_is_refused_with_both_values() {
    let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), off());
    fake.position = 1_203_441;
    axis.enable_with_target(0);
    let expected = AxisErrorKind::SeedTooFar { target: 0, actual: 1_203_441, limit: 1_000 };
    assert_eq!(failure(&mut axis, &mut fake), expected);
    assert!(fake.heard.iter().all(|outputs| outputs.controlword.0 == 0), "nothing has been sent");
    axis.enable_with_target(1_203_000);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    assert_eq!(fake.position, 1_203_000);
    // Without a position there is nothing to seed from.
    let mut blind = Axis::new(AxisPolicy::default());
    blind.enable(Mode::CYCLIC_POSITION);
    let sample = drivewright_runtime::client::axis::Sample { position: None, ..fake.sample() };
    blind.step(LONG, Some(sample));
    assert!(matches!(blind.progress(), Progress::Failed(e) if e.kind == AxisErrorKind::NoActualPosition));
}

#[test]
fn b31_a_jump_of_a_cyclic_target_is_refused_with_both_values() {
    let limits = StepLimits { position: Some(50), velocity: Some(10), torque: Some(5) };
    let policy = policy(|policy| policy.step_limits = limits);
    let (mut axis, mut fake) = (Axis::new(policy), off());
    fake.position = 1_000_000;
    axis.enable(Mode::CYCLIC_POSITION);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    // The first one is measured by the limit of the seed: a program that starts at 0 is caught.
    let kind = axis.target_position(0).unwrap_err().kind;
    assert_eq!(kind, AxisErrorKind::TargetJumps { from: 1_000_000, to: 0, limit: 1_000 });
    axis.target_position(1_000_900).unwrap();
    cycles(&mut axis, &mut fake, 1);
    let kind = axis.target_position(1_000_951).unwrap_err().kind;
    assert_eq!(kind, AxisErrorKind::TargetJumps { from: 1_000_900, to: 1_000_951, limit: 50 });
    // Two in a cycle are measured from the same place.
    axis.target_position(1_000_950).unwrap();
    assert!(axis.target_position(1_001_000).is_err());
    cycles(&mut axis, &mut fake, 2);
    assert_eq!(fake.position, 1_000_950);
    let (mut axis, _) = enabled(Mode::CYCLIC_VELOCITY, policy, off());
    assert!(axis.target_velocity(11).is_err() && axis.target_velocity(-10).is_ok());
    let (mut axis, _) = enabled(Mode::PROFILE_VELOCITY, policy, off());
    assert!(axis.target_velocity(30_000).is_ok(), "the drive makes the ramp");
    let (mut axis, _) = enabled(Mode::CYCLIC_TORQUE, policy, off());
    assert!(axis.target_torque(i16::MIN).is_err() && axis.target_torque(5).is_ok());
}

#[test]
fn b31_a_change_of_the_mode_does_not_jump() {
    let (mut axis, mut fake) = positioning(off(), AxisPolicy::default());
    axis.move_to(SetPoint::to(50_000), LONG);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    fake.position = 49_000;
    cycles(&mut axis, &mut fake, 1);
    axis.select_mode(Mode::CYCLIC_POSITION);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    cycles(&mut axis, &mut fake, 5);
    assert_eq!(fake.position, 49_000, "the old set-point is no target of the new mode");
}

#[test]
fn b32_velocity_and_torque_are_zero_before_operation() {
    for mode in [Mode::PROFILE_VELOCITY, Mode::CYCLIC_VELOCITY] {
        let (mut axis, mut fake) = enabled(mode, AxisPolicy::default(), off());
        axis.target_velocity(500).unwrap();
        cycles(&mut axis, &mut fake, 3);
        fake.state = State::SwitchOnDisabled;
        cycles(&mut axis, &mut fake, 3);
        let before = fake.heard.len();
        axis.enable(mode);
        assert_eq!(run(&mut axis, &mut fake), Progress::Done);
        cycles(&mut axis, &mut fake, 10);
        assert!(fake.heard[before..].iter().all(|outputs| outputs.velocity == 0), "nothing is left over");
    }
    // Where the target is not mapped, 0 is written before the axis is enabled.
    let image = Image::new(&RX[..2], &TX).unwrap();
    let mut drive = drive_with(off(), image, AxisPolicy::default());
    drive.enable(Mode::CYCLIC_VELOCITY).unwrap();
    assert!(drive.bus().written.contains(&(Address::new(0x60FF, 0), vec![0; 4])));
}

#[test]
fn b38_there_is_one_formula_for_a_unit_both_ways() {
    let scale = Scale::<UserPosition, Angle>::new(1, 10_000).unwrap();
    let image = Image::new(&RX, &TX).unwrap();
    let client = Client::new(&MODEL, image, AxisPolicy::default()).with_scale(scale);
    let target = Address::new(0x607A, 0);
    for quarters in [-7, -1, 0, 1, 2, 400] {
        let value = Value::degrees(90 * quarters);
        let count = client.count(target, value.into()).unwrap();
        assert_eq!(count, 2_500 * i64::from(quarters));
        let handle: Object<i32, Rw, RxTx, UserPosition> = Object::new(0x607A, 0);
        assert_eq!(handle.value_with(&scale, i32::try_from(count).unwrap()), Ok(value));
    }
    let velocity = Address::new(0x60FF, 0);
    assert_eq!(client.count(velocity, Value::rpm(-3).into()), Ok(-30));
    let wrong = client.count(velocity, Value::degrees(1).into()).unwrap_err();
    assert_eq!(
        wrong.to_string(),
        "error[UNIT]: 60FF:00 measures velocity, not angle\n  do     : give the value in this unit, or as a raw count"
    );
    assert!(matches!(client.count(velocity, Value::rpm(6_001).into()), Err(ClientError::Range(_))));
    let bare = Client::new(&MODEL, image, AxisPolicy::default());
    assert_eq!(bare.count(target, Value::degrees(1).into()), Err(ClientError::NoScale));
}

#[test]
fn b39_nothing_is_written_that_the_profile_does_not_list() {
    let mut drive = drive(off());
    drive.enable(Mode::PROFILE_POSITION).unwrap();
    // 6084h is not in the profile of this drive.
    let error = drive.move_to(MoveTo::to(1).deceleration(100)).unwrap_err();
    let DriveError::Client(ClientError::Access(error)) = error else { panic!("{error}") };
    assert_eq!((error.address, error.cause), (Address::new(0x6084, 0), Cause::NotInProfile));
    assert!(drive.bus().written.is_empty(), "not even what comes before it");
}

#[test]
fn b40_a_write_to_what_process_data_carry_is_refused() {
    let mut drive = drive(off());
    for index in [0x6040, 0x607A, 0x60FF, 0x6071, 0x6060] {
        let error = drive.write(Address::new(index, 0), 1).unwrap_err();
        let DriveError::Client(ClientError::Access(error)) = error else { panic!("{error}") };
        assert_eq!(error.cause, Cause::MappedInRxPdo);
    }
    assert!(drive.bus().written.is_empty());
    drive.write(Address::new(0x6081, 0), Value::rpm(30)).unwrap();
    assert_eq!(drive.bus().written, [(Address::new(0x6081, 0), vec![0x2C, 1, 0, 0])]);
    // The drive may say it as well.
    assert_eq!(AbortCode::MAPPED_IN_RX_PDO.0, 0x0601_0006);
    // The bits of the mode are kept under every command.
    let word = Controlword(0x0170).with_command(drivewright_runtime::cia402::Command::QuickStop);
    assert_eq!(word.0, 0x0172);
}
