//! Modes, targets and the way up.

use drivewright_runtime::cia402::{Controlword, Mode};
use drivewright_runtime::client::axis::{Axis, AxisErrorKind, AxisPolicy, Feedback, Progress};

use super::{CYCLE, DISABLED, ENABLED, READY, Rig, SWITCHED_ON};

#[test]
fn b08_a_mode_that_is_not_taken_is_an_error() {
    let mut rig = Rig::new(AxisPolicy::default());
    rig.axis.select_mode(Mode::HOMING);
    rig.until_the_end(DISABLED);
    let (asked, shown) = (Mode::HOMING, Some(Mode::NONE));
    assert_eq!(rig.failed(), Some(AxisErrorKind::ModeNotTaken { asked, shown, halted: false }));
}

#[test]
fn b09_a_mode_that_is_selected_already_is_done() {
    let mut rig = Rig::new(AxisPolicy::default());
    rig.shown.mode = Some(Mode::HOMING);
    rig.see(DISABLED);
    rig.axis.select_mode(Mode::HOMING);
    assert_eq!(rig.until_the_end(DISABLED).len(), 1);
    assert_eq!(rig.axis.progress(), Progress::Done);
}

#[test]
fn b11_halt_is_released_for_drives_that_need_it_and_never_set_by_itself() {
    for quirk in [false, true] {
        let mut policy = AxisPolicy::default();
        policy.mode_needs_halt_off = quirk;
        let mut rig = Rig::new(policy);
        rig.axis.halt(true);
        rig.axis.select_mode(Mode::HOMING);
        assert_eq!(rig.see(DISABLED).controlword.halt(), !quirk);
    }
    let mut rig = Rig::new(AxisPolicy::default());
    rig.axis.enable(Mode::PROFILE_VELOCITY);
    assert!(rig.stay(DISABLED, 5).iter().all(|o| o.controlword.0 & Controlword::HALT == 0));
}

#[test]
fn b15_a_drive_without_a_mode_is_told_so() {
    let mut rig = Rig::new(AxisPolicy::default());
    rig.axis.enable(Mode::PROFILE_VELOCITY);
    let sent = rig.until_the_end(DISABLED);
    assert_eq!(sent[0].mode, Mode::PROFILE_VELOCITY);
    let Progress::Failed(error) = rig.axis.progress() else { panic!("it fails") };
    let shown = error.to_string();
    assert!(shown.contains("no mode of operation is selected"), "{shown}");
}

#[test]
fn b16_a_statusword_that_never_came_is_no_state() {
    let mut axis = Axis::new(AxisPolicy::default());
    axis.enable(Mode::PROFILE_VELOCITY);
    assert_eq!(axis.feedback(), Feedback::Nothing);
    while axis.progress() == Progress::Pending {
        assert_eq!(axis.step(CYCLE, None).controlword.0, 0);
    }
    let Progress::Failed(error) = axis.progress() else { panic!("it fails") };
    assert_eq!(error.kind, AxisErrorKind::NoStatusword);
}

#[test]
fn b16_a_statusword_that_comes_no_more_is_not_believed() {
    let mut rig = Rig::enabled(AxisPolicy::default(), Mode::CYCLIC_VELOCITY);
    for _ in 0..20 {
        rig.axis.step(CYCLE, None);
    }
    assert!(matches!(rig.axis.feedback(), Feedback::Stale(_)));
    assert!(!rig.axis.is_enabled() && rig.axis.trip().is_some());
}

#[test]
fn b31_the_target_is_where_the_axis_is_until_it_is_in_operation() {
    let mut rig = Rig::new(AxisPolicy::default());
    rig.axis.enable(Mode::CYCLIC_POSITION);
    rig.shown.mode = Some(Mode::CYCLIC_POSITION);
    for (word, position) in [(DISABLED, 5_000), (READY, 5_010), (SWITCHED_ON, 5_020)] {
        rig.shown.position = Some(position);
        assert_eq!(rig.see(word).position, position);
    }
    // From here on it is held.
    rig.see(ENABLED);
    let held = rig.axis.outputs().position;
    rig.shown.position = Some(held + 40);
    assert_eq!(rig.see(ENABLED).position, held);
}

#[test]
fn b31_a_first_target_far_away_is_refused_with_both_values() {
    let mut rig = Rig::new(AxisPolicy::default());
    rig.shown.mode = Some(Mode::CYCLIC_POSITION);
    rig.axis.enable_with_target(0);
    rig.until_the_end(DISABLED);
    assert_eq!(rig.failed(), Some(AxisErrorKind::SeedTooFar { target: 0, actual: 5_000, limit: 1_000 }));
}

#[test]
fn b32_a_speed_of_before_is_gone_at_the_next_enable() {
    let mut rig = Rig::enabled(AxisPolicy::default(), Mode::CYCLIC_VELOCITY);
    rig.axis.target_velocity(700).expect("it is in operation");
    assert_eq!(rig.see(ENABLED).velocity, 700);
    // The drive leaves operation by itself, and is enabled again.
    rig.see(SWITCHED_ON);
    rig.axis.enable(Mode::CYCLIC_VELOCITY);
    for word in [SWITCHED_ON, SWITCHED_ON, ENABLED, ENABLED] {
        assert_eq!(rig.see(word).velocity, 0);
    }
}
