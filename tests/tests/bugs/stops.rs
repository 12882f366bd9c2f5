//! Quick stop and disabling.

use drivewright_runtime::cia402::{Mode, StopOption};
use drivewright_runtime::client::axis::{AxisErrorKind, AxisPolicy, Progress};

use super::{DISABLED, ENABLED, FAULT, NOT_READY, QUICK_STOP, READY, Rig, SWITCHED_ON, words};

#[test]
fn b01_a_quick_stop_that_has_ended_by_itself_is_done() {
    let mut rig = Rig::enabled(AxisPolicy::default(), Mode::PROFILE_VELOCITY);
    rig.axis.quick_stop();
    assert_eq!(rig.see(ENABLED).controlword.0 & 0x8F, 0x02);
    // Quick stop active was between two samples.
    rig.until_the_end(DISABLED);
    assert_eq!(rig.axis.progress(), Progress::Done);
}

#[test]
fn b02_a_quick_stop_is_done_where_nothing_moves() {
    for word in [NOT_READY, DISABLED, FAULT] {
        let mut rig = Rig::new(AxisPolicy::default());
        rig.axis.quick_stop();
        assert!(rig.until_the_end(word).len() < 10);
        assert_eq!(rig.axis.progress(), Progress::Done, "{word:04X}h");
    }
}

#[test]
fn b03_a_quick_stop_is_asked_for_where_power_is_on() {
    for word in [READY, SWITCHED_ON] {
        let mut rig = Rig::new(AxisPolicy::default());
        rig.axis.quick_stop();
        assert_eq!(words(&rig.stay(word, 2)), [0x02, 0x02]);
        rig.until_the_end(DISABLED);
        assert_eq!(rig.axis.progress(), Progress::Done);
    }
}

#[test]
fn b04_operation_does_not_come_back_out_of_a_quick_stop() {
    let policy = || {
        let mut policy = AxisPolicy::default();
        policy.quick_stop = StopOption::quick_stop(6);
        policy
    };
    let mut rig = Rig::enabled(policy(), Mode::PROFILE_VELOCITY);
    // The drive stops by itself, and the client is asked to enable.
    rig.stay(QUICK_STOP, 3);
    rig.axis.enable(Mode::PROFILE_VELOCITY);
    let sent = words(&rig.stay(QUICK_STOP, 20));
    assert!(sent.iter().all(|word| word & 0x0F != 0x0F), "{sent:02X?}");
    // On request it does, where 605Ah keeps the state.
    rig.axis.quick_stop();
    rig.until_the_end(QUICK_STOP);
    rig.axis.resume();
    assert_eq!(rig.see(QUICK_STOP).controlword.0 & 0x8F, 0x0F);
    let mut rig = Rig::enabled(AxisPolicy::default(), Mode::PROFILE_VELOCITY);
    rig.axis.quick_stop();
    rig.until_the_end(QUICK_STOP);
    rig.axis.resume();
    rig.until_the_end(QUICK_STOP);
    assert_eq!(rig.failed(), Some(AxisErrorKind::QuickStopNotKnown));
}
