//! The hand-shake of profile position mode.

use std::time::Duration;

use drivewright_runtime::cia402::Mode;
use drivewright_runtime::client::axis::{AxisErrorKind, AxisPolicy, Progress, SetPoint};

use super::{ENABLED, Rig};

const ACKNOWLEDGE: u16 = 0x1000;
const REACHED: u16 = 0x0400;
const SECOND: Duration = Duration::from_secs(1);

fn moving(policy: AxisPolicy) -> Rig {
    let mut rig = Rig::enabled(policy, Mode::PROFILE_POSITION);
    rig.axis.move_to(SetPoint::to(9_000), SECOND);
    rig
}

/// Cycles until bit 4 is high.
fn raise(rig: &mut Rig, word: u16) -> usize {
    (1..100).find(|_| rig.see(word).controlword.mode_4()).unwrap_or(100)
}

#[test]
fn b28_the_target_goes_out_before_the_edge() {
    let mut rig = moving(AxisPolicy::default());
    let first = rig.see(ENABLED);
    assert_eq!((first.position, first.controlword.mode_4()), (9_000, false));
    assert!(raise(&mut rig, ENABLED) < 5);
    assert_eq!(rig.axis.outputs().position, 9_000);
}

#[test]
fn b29_bit_4_falls_so_that_the_next_set_point_can_rise() {
    let mut rig = moving(AxisPolicy::default());
    raise(&mut rig, ENABLED);
    assert!(rig.stay(ENABLED, 5).iter().all(|o| o.controlword.mode_4()), "until it is acknowledged");
    assert!(!rig.see(ENABLED | ACKNOWLEDGE).controlword.mode_4());
    rig.stay(ENABLED | ACKNOWLEDGE, 3);
    assert!(!rig.axis.set_point_is_taken(), "bit 12 is high still");
    rig.stay(ENABLED, 3);
    assert!(rig.axis.set_point_is_taken());
    rig.until_the_end(ENABLED | REACHED);
    assert_eq!(rig.axis.progress(), Progress::Done);
    rig.axis.move_to(SetPoint::to(10_000), SECOND);
    assert!(raise(&mut rig, ENABLED | REACHED) < 5, "the next one rises");
}

#[test]
fn b29_a_set_point_that_is_not_taken_is_an_error() {
    let mut rig = moving(AxisPolicy::default());
    rig.until_the_end(ENABLED);
    assert_eq!(rig.failed(), Some(AxisErrorKind::NotAcknowledged));
    assert!(!rig.see(ENABLED).controlword.mode_4());
}

#[test]
fn b30_bit_12_may_be_high_from_the_start_on_drives_that_do_so() {
    let mut rig = moving(AxisPolicy::default());
    assert_eq!(raise(&mut rig, ENABLED | ACKNOWLEDGE), 100);
    let mut policy = AxisPolicy::default();
    policy.acknowledge_may_be_high = true;
    let mut rig = moving(policy);
    assert!(raise(&mut rig, ENABLED | ACKNOWLEDGE) < 5);
}

#[test]
fn b41_every_controlword_has_one_owner() {
    // Bits of mode and maker stay through the reset of a fault, and the reset is in the same word.
    let mut rig = Rig::enabled(AxisPolicy::default(), Mode::CYCLIC_TORQUE);
    rig.axis.set_maker_bits(0x4000);
    rig.axis.select_mode(Mode::CYCLIC_POSITION);
    rig.stay(super::FAULT, 3);
    rig.axis.reset_fault();
    let sent = super::words(&rig.until_the_end(super::FAULT));
    assert!(sent.contains(&0x4080) && sent.iter().all(|word| [0x4000, 0x4080].contains(word)), "{sent:04X?}");
}
