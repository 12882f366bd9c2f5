//! Modes of operation.

use core::time::Duration;

use drivewright_runtime::cia402::{Mode, State};
use drivewright_runtime::client::axis::{Axis, AxisErrorKind, AxisPolicy, Modes, Progress};

use super::{enabled, failure, off, policy};
use crate::fake::{cycles, run};

#[test]
fn b08_a_refused_mode_is_an_error() {
    let (mut axis, mut fake) = enabled(Mode::CYCLIC_VELOCITY, AxisPolicy::default(), off());
    fake.quirks.refuses_modes = true;
    axis.select_mode(Mode::CYCLIC_TORQUE);
    let expected = AxisErrorKind::ModeNotTaken {
        asked: Mode::CYCLIC_TORQUE,
        shown: Some(Mode::CYCLIC_VELOCITY),
        halted: false,
    };
    assert_eq!(failure(&mut axis, &mut fake), expected);
    fake.quirks.refuses_modes = false;
    cycles(&mut axis, &mut fake, 100);
    assert_eq!(fake.mode, Mode::CYCLIC_VELOCITY, "what was refused does not come later, by surprise");
    assert_eq!(fake.state, State::OperationEnabled);
}

#[test]
fn b09_the_mode_that_is_shown_already_is_a_success() {
    let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), off());
    (fake.mode, fake.quirks.refuses_modes) = (Mode::HOMING, true);
    axis.select_mode(Mode::HOMING);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    axis.select_mode(Mode::HOMING);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
}

#[test]
fn b10_a_mode_of_the_maker_is_a_mode() {
    for number in i8::MIN..=i8::MAX {
        let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), off());
        axis.select_mode(Mode(number));
        assert_eq!(run(&mut axis, &mut fake), Progress::Done, "{number}");
        assert_eq!(fake.mode, Mode(number));
        assert!(format!("{}", Mode(number)).contains(&number.to_string()));
    }
}

#[test]
fn b11_halt_is_never_set_by_the_way_and_can_be_released_for_a_mode() {
    let (_, fake) = enabled(Mode::PROFILE_VELOCITY, AxisPolicy::default(), off());
    assert!(fake.heard.iter().all(|outputs| !outputs.controlword.halt()));
    let halted = |policy: AxisPolicy| {
        let (mut axis, mut fake) = enabled(Mode::PROFILE_VELOCITY, policy, off());
        fake.quirks.halt_blocks_modes = true;
        axis.halt(true);
        cycles(&mut axis, &mut fake, 5);
        axis.select_mode(Mode::HOMING);
        (run(&mut axis, &mut fake), fake.heard.last().unwrap().controlword.halt())
    };
    let (progress, halt) = halted(AxisPolicy::default());
    let Progress::Failed(error) = progress else { panic!("{progress:?}") };
    assert!(matches!(error.kind, AxisErrorKind::ModeNotTaken { halted: true, .. }));
    assert!(error.to_string().contains("halt is set"), "{error}");
    assert!(halt, "it is up to the program to release it");
    assert_eq!(halted(policy(|policy| policy.mode_needs_halt_off = true)), (Progress::Done, false));
}

#[test]
fn b12_modes_are_checked_against_the_bits_of_6502h() {
    for number in 1..=11 {
        let all = Modes::NONE.with(Mode(number));
        assert_eq!(all.0.count_ones(), 1);
        assert_eq!(Mode(number).supported_bit(), Some(all.0));
        assert!((1..=11).all(|other| all.has(Mode(other)) == (other == number)));
    }
    let policy = policy(|policy| policy.modes = Modes(0x225));
    let mut axis = Axis::new(policy);
    axis.enable(Mode::CYCLIC_POSITION);
    let Progress::Failed(error) = axis.progress() else { panic!("at once") };
    let (asked, supported) = (Mode::CYCLIC_POSITION, Modes(0x225));
    assert_eq!(error.kind, AxisErrorKind::ModeNotSupported { asked, supported });
}

#[test]
fn b15_the_mode_comes_before_the_states_and_no_mode_is_told() {
    let (_, fake) = enabled(Mode::CYCLIC_VELOCITY, AxisPolicy::default(), off());
    let first = |bits| fake.heard.iter().position(|outputs| outputs.controlword.0 & 0x0F == bits).unwrap();
    let mode = fake.heard.iter().position(|outputs| outputs.mode == Mode::CYCLIC_VELOCITY).unwrap();
    assert!(mode < first(0x06) && first(0x06) < first(0x0F));
    let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), off());
    fake.quirks.refuses_modes = true;
    axis.enable(Mode::CYCLIC_VELOCITY);
    let Progress::Failed(error) = run(&mut axis, &mut fake) else { panic!() };
    assert!(error.to_string().contains("no mode of operation is selected"), "{error}");
    assert_eq!(error.waited, Duration::from_secs(1));
    assert_eq!(fake.state, State::SwitchOnDisabled);
}

#[test]
fn b15_a_drive_that_shows_the_mode_in_operation_only_can_be_told_of() {
    let policy = policy(|policy| policy.mode_before_enable = false);
    let (mut axis, mut fake) = (Axis::new(policy), off());
    fake.quirks.mode_in_operation_only = true;
    axis.enable(Mode::CYCLIC_VELOCITY);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    assert_eq!((fake.mode, fake.state), (Mode::CYCLIC_VELOCITY, State::OperationEnabled));
}

#[test]
fn b26_modes_are_shown_decoded() {
    let modes = Modes(u32::from_le_bytes([0x25, 0x02, 0, 0]));
    let expected = "profile position (1), profile velocity (3), homing (6), cyclic synchronous torque (10)";
    assert_eq!(modes.to_string(), expected);
    let mut axis = Axis::new(policy(|policy| policy.modes = modes));
    axis.select_mode(Mode::CYCLIC_POSITION);
    let Progress::Failed(error) = axis.progress() else { panic!() };
    assert!(error.to_string().contains(expected), "{error}");
}
