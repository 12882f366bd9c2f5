//! Fault reset.

use drivewright_runtime::cia402::Mode;
use drivewright_runtime::client::axis::{AxisErrorKind, AxisPolicy, Progress};

use super::{CYCLE, DISABLED, FAULT, Rig, words};

#[test]
fn b05_a_reset_is_one_edge_that_falls_again() {
    let mut rig = Rig::new(AxisPolicy::default());
    rig.axis.reset_fault();
    let sent = words(&rig.until_the_end(FAULT));
    let edges = sent.windows(2).filter(|w| w[0] & 0x80 == 0 && w[1] & 0x80 != 0).count();
    assert_eq!((edges, sent[0] & 0x80, sent[sent.len() - 1] & 0x80), (1, 0, 0), "{sent:02X?}");
    assert_eq!(rig.failed(), Some(AxisErrorKind::StillFaulted { code: None }));
}

#[test]
fn b05_a_reset_that_is_given_up_leaves_bit_7_low() {
    let mut rig = Rig::new(AxisPolicy::default());
    rig.axis.reset_fault();
    while rig.see(FAULT).controlword.0 & 0x80 == 0 {}
    // Nothing is heard any more.
    while rig.axis.progress() == Progress::Pending {
        rig.axis.step(CYCLE, None);
    }
    assert_eq!(rig.axis.outputs().controlword.0 & 0x80, 0);
    rig.axis.enable(Mode::HOMING);
    assert_eq!(rig.see(FAULT).controlword.0 & 0x80, 0);
}

#[test]
fn b06_each_level_of_the_edge_is_held() {
    let mut policy = AxisPolicy::default();
    policy.edge_hold = CYCLE * 7;
    let mut rig = Rig::new(policy);
    rig.axis.reset_fault();
    let sent = words(&rig.until_the_end(FAULT));
    let low = sent.iter().take_while(|word| *word & 0x80 == 0).count();
    let high = sent.iter().skip(low).take_while(|word| *word & 0x80 != 0).count();
    assert!(low >= 7 && high >= 7, "{low} cycles low, {high} high");
}

#[test]
fn b07_a_reset_ends_when_the_fault_is_gone_and_enables_nothing() {
    let mut rig = Rig::new(AxisPolicy::default());
    rig.axis.reset_fault();
    let mut sent = Vec::new();
    while rig.axis.outputs().controlword.0 & 0x80 == 0 {
        sent.push(rig.see(FAULT));
    }
    let after = rig.until_the_end(DISABLED);
    assert_eq!(rig.axis.progress(), Progress::Done);
    assert!(after.len() < 12, "{} cycles after the fault is gone", after.len());
    sent.extend(after);
    sent.extend(rig.stay(DISABLED, 20));
    assert!(words(&sent).iter().all(|word| word.trailing_zeros() >= 4));
}

#[test]
fn b14_enabling_a_drive_in_fault_fails_with_its_code() {
    let mut rig = Rig::new(AxisPolicy::default());
    rig.shown.error_code = Some(0x8611);
    rig.axis.enable(Mode::PROFILE_VELOCITY);
    rig.until_the_end(FAULT);
    assert_eq!(rig.failed(), Some(AxisErrorKind::Faulted { code: Some(0x8611) }));
}
