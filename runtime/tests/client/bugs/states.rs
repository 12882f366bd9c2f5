//! States, quick stop, fault reset, the statusword.

use core::time::Duration;

use drivewright_runtime::cia402::{Command, Mode, State, Statusword, StopOption};
use drivewright_runtime::client::axis::{
    Axis, AxisErrorKind, AxisPolicy, Feedback, Progress, Request, Sample,
};
use drivewright_runtime::client::error::{ClientError, DriveError};

use super::{enabled, failure, off, policy};
use crate::bus::drive;
use crate::fake::{cycles, run, Fake, CYCLE};

#[test]
fn b01_a_quick_stop_is_done_in_either_state() {
    for stays in [true, false] {
        let (mut axis, mut fake) = enabled(Mode::CYCLIC_VELOCITY, AxisPolicy::default(), off());
        fake.options.quick_stop_stays = stays;
        fake.ends_quick_stop_at_once = !stays;
        axis.quick_stop();
        assert_eq!(run(&mut axis, &mut fake), Progress::Done);
        let expected = if stays { State::QuickStopActive } else { State::SwitchOnDisabled };
        assert_eq!(fake.state, expected);
    }
}

#[test]
fn b02_a_quick_stop_where_nothing_moves_is_done() {
    for state in
        [State::NotReadyToSwitchOn, State::SwitchOnDisabled, State::Fault, State::FaultReactionActive]
    {
        let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), Fake::new(state));
        axis.quick_stop();
        assert_eq!(run(&mut axis, &mut fake), Progress::Done, "{state}");
        assert_eq!((fake.state, fake.transitions), (state, vec![]));
    }
}

#[test]
fn b03_a_quick_stop_before_operation_leads_to_switch_on_disabled() {
    for (state, transition) in [(State::ReadyToSwitchOn, 7), (State::SwitchedOn, 10)] {
        let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), Fake::new(state));
        axis.quick_stop();
        assert_eq!(run(&mut axis, &mut fake), Progress::Done);
        assert_eq!((fake.state, fake.transitions), (State::SwitchOnDisabled, vec![transition]));
    }
}

fn quick_stopped(option: Option<i16>) -> (Axis, Fake) {
    let policy = policy(|policy| policy.quick_stop = option.and_then(StopOption::quick_stop));
    let (mut axis, mut fake) = enabled(Mode::CYCLIC_POSITION, policy, off());
    fake.options.quick_stop_stays = true;
    axis.quick_stop();
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    assert_eq!(fake.state, State::QuickStopActive);
    (axis, fake)
}

#[test]
fn b04_nothing_leads_out_of_a_quick_stop_but_a_request() {
    let (mut axis, mut fake) = quick_stopped(Some(6));
    cycles(&mut axis, &mut fake, 1_000);
    assert_eq!(fake.state, State::QuickStopActive, "not by itself");
    fake.position = 5_000;
    axis.resume();
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    assert_eq!(fake.transitions, [2, 3, 4, 11, 16]);
    assert_eq!(fake.position, 5_000, "the target is where the axis is");
    for (option, refusal) in
        [(Some(2), AxisErrorKind::QuickStopDoesNotStay), (None, AxisErrorKind::QuickStopNotKnown)]
    {
        let (mut axis, mut fake) = quick_stopped(option);
        axis.resume();
        assert_eq!(failure(&mut axis, &mut fake), refusal);
        cycles(&mut axis, &mut fake, 10);
        assert!(!fake.transitions.contains(&16));
    }
    // To enable is to go down first, and up again.
    let (mut axis, mut fake) = quick_stopped(Some(6));
    axis.enable(Mode::CYCLIC_POSITION);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    assert_eq!(fake.transitions, [2, 3, 4, 11, 12, 2, 3, 4]);
}

#[test]
fn b04_resume_without_a_quick_stop_changes_nothing() {
    let (mut axis, mut fake) = enabled(Mode::CYCLIC_POSITION, AxisPolicy::default(), off());
    axis.resume();
    assert_eq!(failure(&mut axis, &mut fake), AxisErrorKind::NotQuickStopped);
    cycles(&mut axis, &mut fake, 10);
    assert_eq!(fake.state, State::OperationEnabled);
}

fn faulted(code: u16) -> Fake {
    let mut fake = off();
    fake.fault(code);
    fake
}

/// Bit 7 of everything that was heard, as levels with their lengths.
fn levels(fake: &Fake) -> Vec<(bool, usize)> {
    let mut levels: Vec<(bool, usize)> = Vec::new();
    for outputs in &fake.heard {
        let level = outputs.controlword.fault_reset();
        match levels.last_mut() {
            Some((last, length)) if *last == level => *length += 1,
            _ => levels.push((level, 1)),
        }
    }
    levels
}

#[test]
fn b05_fault_reset_is_an_edge_that_is_cleared_again() {
    let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), faulted(0x8611));
    axis.reset_fault();
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    cycles(&mut axis, &mut fake, 50);
    let levels: Vec<bool> = levels(&fake).into_iter().map(|(level, _)| level).collect();
    assert_eq!(levels, [false, true, false]);
    assert_eq!((fake.state, fake.transitions), (State::SwitchOnDisabled, vec![15]));
}

#[test]
fn b06_every_level_of_a_fault_reset_is_held() {
    let slow = |hold| {
        let policy = policy(|policy| policy.edge_hold = Duration::from_millis(hold));
        let (mut axis, mut fake) = (Axis::new(policy), faulted(1).with(|quirks| quirks.reset_level = 25));
        axis.reset_fault();
        (run(&mut axis, &mut fake), fake)
    };
    let (progress, fake) = slow(30);
    assert_eq!(progress, Progress::Done);
    assert!(levels(&fake)[..2].iter().all(|(_, length)| *length >= 30), "{:?}", levels(&fake));
    assert!(matches!(slow(10).0, Progress::Failed(_)), "the drive of this test wants 25 cycles");
}

#[test]
fn b07_fault_reset_is_verified_and_enables_nothing() {
    let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), faulted(0x7580));
    fake.quirks.fault_persists = true;
    axis.reset_fault();
    assert_eq!(failure(&mut axis, &mut fake), AxisErrorKind::StillFaulted { code: Some(0x7580) });
    assert_eq!(levels(&fake).iter().filter(|(level, _)| *level).count(), 1, "one edge, no loop of resets");
    let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), faulted(0x7580));
    axis.reset_fault();
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    cycles(&mut axis, &mut fake, 100);
    assert_eq!(fake.state, State::SwitchOnDisabled, "enabling is another call");
    // Where there is no fault there is nothing to reset, and no edge.
    axis.reset_fault();
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    assert_eq!(levels(&fake).len(), 3);
}

#[test]
fn b07_a_reset_without_a_fault_leaves_an_axis_in_operation_alone() {
    let (mut axis, mut fake) = enabled(Mode::CYCLIC_VELOCITY, AxisPolicy::default(), off());
    axis.target_velocity(5).unwrap();
    axis.reset_fault();
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    cycles(&mut axis, &mut fake, 5);
    assert_eq!((fake.state, fake.heard.last().unwrap().velocity), (State::OperationEnabled, 5));
}

#[test]
fn b07_a_fault_that_nobody_has_seen_yet_can_be_reset() {
    let mut drive = drive(off());
    drive.enable(Mode::CYCLIC_VELOCITY).unwrap();
    drive.bus().fake.fault(0x8611);
    drive.reset_fault().unwrap();
    assert_eq!(drive.bus().fake.state, State::SwitchOnDisabled);
    assert!(!drive.client().axis().is_enabled());
}

#[test]
fn b07_an_alarm_that_cannot_be_reset_is_told_at_once() {
    // 2310h is shared with an alarm that can be reset.
    for (code, refused) in [(0x7300, true), (0x8611, false), (0x2310, false), (0x1234, false)] {
        let mut drive = drive(faulted(code));
        let result = drive.reset_fault();
        let expected = Err(DriveError::Client(ClientError::NotResettable { code }));
        assert_eq!(result, if refused { expected } else { Ok(()) });
        assert_eq!(drive.bus().fake.transitions.is_empty(), refused);
        assert!(!refused || drive.bus().fake.heard.iter().all(|outputs| !outputs.controlword.fault_reset()));
    }
}

#[test]
fn a_quick_stop_that_does_not_end_is_ended_by_who_disables() {
    let (mut axis, mut fake) = quick_stopped(Some(2));
    axis.disable();
    assert_eq!(failure(&mut axis, &mut fake), AxisErrorKind::TimedOut, "605Ah says that it ends by itself");
    cycles(&mut axis, &mut fake, 3);
    assert_eq!(fake.state, State::SwitchOnDisabled);
}

#[test]
fn b13_every_walk_takes_transitions_of_the_standard_only() {
    for state in State::ALL.iter().copied().filter(|state| !state.is_fault()) {
        for goal in [State::SwitchOnDisabled, State::ReadyToSwitchOn, State::SwitchedOn] {
            let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), Fake::new(state));
            axis.reach(goal);
            let expected = if state == State::NotReadyToSwitchOn { state } else { goal };
            assert_eq!(run(&mut axis, &mut fake) == Progress::Done, expected == goal, "{state} to {goal}");
            assert_eq!(fake.state, expected);
        }
    }
}

#[test]
fn b14_enable_in_fault_is_an_error_with_the_code() {
    let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), faulted(0x8611));
    axis.enable(Mode::CYCLIC_POSITION);
    assert_eq!(failure(&mut axis, &mut fake), AxisErrorKind::Faulted { code: Some(0x8611) });
    cycles(&mut axis, &mut fake, 50);
    assert_eq!((fake.state, fake.transitions), (State::Fault, vec![]));
}

#[test]
fn b14_a_fault_on_the_way_ends_the_walk() {
    let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), off());
    axis.enable(Mode::CYCLIC_POSITION);
    cycles(&mut axis, &mut fake, 4);
    fake.fault(0x3210);
    assert_eq!(failure(&mut axis, &mut fake), AxisErrorKind::Faulted { code: Some(0x3210) });
}

#[test]
fn b16_no_statusword_is_no_state() {
    let mut axis = Axis::new(AxisPolicy::default());
    assert_eq!(axis.feedback(), Feedback::Nothing);
    let mut silent = off().with(|quirks| quirks.silent = true);
    axis.enable(Mode::CYCLIC_POSITION);
    assert_eq!(failure(&mut axis, &mut silent), AxisErrorKind::NoStatusword);
    assert!(silent.heard.iter().all(|outputs| outputs.controlword.0 == 0), "nothing is done unseen");
}

#[test]
fn b16_an_old_statusword_is_not_believed() {
    let (mut axis, mut fake) = enabled(Mode::CYCLIC_VELOCITY, AxisPolicy::default(), off());
    fake.quirks.silent = true;
    cycles(&mut axis, &mut fake, 100);
    assert!(axis.is_enabled(), "as long as it is not too old");
    cycles(&mut axis, &mut fake, 2);
    assert!(matches!(axis.feedback(), Feedback::Stale(_)));
    let trip = axis.trip().expect("the axis is not heard any more");
    assert_eq!(trip.kind, AxisErrorKind::Stale { age: Duration::from_millis(101) });
    assert_eq!(axis.outputs().controlword.level(), Some(Command::Shutdown));
    // It is not enabled again by itself when it is heard again.
    fake.quirks.silent = false;
    cycles(&mut axis, &mut fake, 1_000);
    assert_eq!(fake.state, State::ReadyToSwitchOn);
}

#[test]
fn b17_one_sample_decides_and_unknown_ones_are_shown_raw() {
    let mut axis = Axis::new(AxisPolicy::default());
    axis.enable(Mode::CYCLIC_VELOCITY);
    let sample = Sample { mode: Some(Mode::CYCLIC_VELOCITY), ..Sample::new(Statusword(0xFFFF)) };
    for _ in 0..4_000 {
        axis.step(CYCLE, Some(sample));
    }
    assert_eq!(axis.feedback(), Feedback::Unknown(Statusword(0xFFFF)));
    let Progress::Failed(error) = axis.progress() else { panic!("an unknown state is no way to operation") };
    assert!(error.to_string().contains("no state of CiA 402 (FFFFh)"), "{error}");
    assert_eq!(axis.outputs().controlword.0, 0);
}

#[test]
fn b41_the_axis_is_the_only_writer_of_the_controlword() {
    // From torque to position mode, into a fault, reset: one owner, so that no other word gets in between.
    let (mut axis, mut fake) = enabled(Mode::CYCLIC_TORQUE, AxisPolicy::default(), off());
    axis.target_torque(50).unwrap();
    axis.enable(Mode::CYCLIC_POSITION);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    assert_eq!(fake.heard.last().unwrap().torque, 0, "what was commanded in one mode is not in the next");
    fake.fault(0x1288);
    cycles(&mut axis, &mut fake, 5);
    assert_eq!(axis.trip().unwrap().kind, AxisErrorKind::Faulted { code: Some(0x1288) });
    axis.reset_fault();
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    assert_eq!(fake.state, State::SwitchOnDisabled);
    // Over SDO it is refused where process data carry it.
    let mut drive = drive(off());
    let error = drive.write(drivewright_runtime::Address::new(0x6040, 0), 6).unwrap_err();
    assert!(error.to_string().contains("RxPDO"), "{error}");
}

#[test]
fn the_way_to_operation_ends_with_another_goal() {
    let goals = [
        Request::ResetFault,
        Request::SelectMode(Mode::CYCLIC_VELOCITY),
        Request::Home(Duration::from_secs(1)),
        Request::Velocity(5, Duration::from_secs(1)),
    ];
    for request in goals {
        let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), Fake::new(State::SwitchedOn));
        fake.mode = Mode::CYCLIC_VELOCITY;
        axis.enable(Mode::CYCLIC_VELOCITY);
        axis.step(CYCLE, Some(fake.sample()));
        assert!(axis.outputs().controlword.enable_operation());
        axis.start(request);
        for _ in 0..100 {
            let sample = fake.cycle(axis.outputs());
            axis.step(CYCLE, sample);
        }
        assert!(!fake.state.is_powered(), "{request:?}");
    }
}

#[test]
fn dropping_out_ends_every_goal_and_enables_nothing() {
    let goals = [
        (
            Mode::PROFILE_POSITION,
            Request::MoveTo(drivewright_runtime::client::axis::SetPoint::to(5), Duration::MAX),
        ),
        (Mode::HOMING, Request::Home(Duration::MAX)),
        (Mode::PROFILE_VELOCITY, Request::SelectMode(Mode::HOMING)),
        (Mode::CYCLIC_VELOCITY, Request::Velocity(5, Duration::MAX)),
    ];
    for (mode, request) in goals {
        let (mut axis, mut fake) = enabled(mode, AxisPolicy::default(), off());
        fake.quirks.refuses_modes = true;
        axis.start(request);
        cycles(&mut axis, &mut fake, 2);
        assert_eq!(axis.progress(), Progress::Pending, "{request:?}");
        fake.state = State::SwitchOnDisabled;
        assert_eq!(failure(&mut axis, &mut fake), AxisErrorKind::LeftOperation, "{request:?}");
        cycles(&mut axis, &mut fake, 1_000);
        assert!(!fake.state.is_powered(), "{request:?}");
        assert_eq!(fake.heard.last().unwrap().controlword.0, 0x06);
    }
}

#[test]
fn an_error_tells_state_statusword_controlword_and_time() {
    let (mut axis, mut fake) = (Axis::new(AxisPolicy::default()), Fake::new(State::SwitchedOn));
    fake.quirks.stuck = true;
    axis.enable(Mode::CYCLIC_VELOCITY);
    let Progress::Failed(error) = run(&mut axis, &mut fake) else { panic!() };
    assert_eq!(
        error.to_string(),
        "error[ENABLE]: enabling: it took too long
  state  : Switched on (0233h) for 2999 ms
  bits   : remote = 1, voltage = 1, warning = 0, internal limit = 0
  tried  : Enable operation (000Fh) for 3000 ms
  do     : check safe torque off, enable inputs and the brake",
        "nothing was known in the first cycle"
    );
    fake.bits = 0;
    let unheard = Sample { mode: Some(Mode::CYCLIC_VELOCITY), ..Sample::new(Statusword(0x0033)) };
    axis.enable(Mode::CYCLIC_VELOCITY);
    for _ in 0..4_000 {
        axis.step(CYCLE, Some(unheard));
    }
    let Progress::Failed(error) = axis.progress() else { panic!() };
    assert!(error.to_string().contains("does not obey the controlword"), "{error}");
}
