//! The client with a drive that obeys, drops out, falls silent and talks nonsense.

use std::time::Duration;

use drivewright_runtime::cia402::{
    Cause, Controlword, Mode, Options, State, Statusword, StopOption, Transition,
};
use drivewright_runtime::client::axis::{Axis, AxisPolicy, Outputs, Progress, Request, Sample, SetPoint};

use super::bytes::Bytes;
use crate::targets::Reached;

/// Longer than all time limits together that [`policy`] can set.
const BOUND: Duration = Duration::from_secs(60);
/// The most goals and cycles of an input.
const ACTIONS: usize = 200;

/// A drive as far as the client can tell.
struct Drive {
    state: State,
    before: Controlword,
    place: i32,
    mode: Mode,
    stays: bool,
}

/// One input.
pub(super) fn step(input: &[u8]) -> Reached {
    let (mut bytes, mut reached) = (Bytes(input), Reached::default());
    let stays = bytes.once_in(2);
    let mut axis = Axis::new(policy(&mut bytes, stays));
    let state = bytes.pick(State::ALL);
    let mut drive = Drive { state, before: Controlword(0), place: bytes.signed32(), mode: Mode::NONE, stays };
    let (mut request, mut tried, mut given) = (Request::Disable, Duration::ZERO, false);
    for _ in 0..ACTIONS {
        if bytes.is_empty() {
            break;
        }
        if bytes.once_in(20) {
            (request, tried, given) = (asked(&mut bytes), Duration::ZERO, false);
            axis.start(request);
        } else if bytes.once_in(8) {
            given |= command(&mut axis, &mut bytes);
        }
        let elapsed = Duration::from_millis(bytes.pick(&[1, 1, 1, 10, 10, 10, 10, 100, 100, 5_000]));
        let sample = seen(&drive, &mut bytes);
        let outputs = axis.step(elapsed, sample);
        tried += elapsed;
        judge(&axis, request, tried, outputs);
        if !bytes.once_in(10) {
            let made = obey(&mut drive, &mut bytes, outputs);
            begins(&axis, made.filter(|_| !given), drive.place, outputs, request);
            follow(&mut drive, outputs);
        }
        reached.sound |= axis.is_enabled();
        reached.codes.extend(ended(&axis));
    }
    reached
}

fn policy(bytes: &mut Bytes<'_>, stays: bool) -> AxisPolicy {
    let mut policy = AxisPolicy::default();
    let times = [
        &mut policy.state_within,
        &mut policy.mode_within,
        &mut policy.reset_within,
        &mut policy.edge_hold,
        &mut policy.stale_after,
        &mut policy.acknowledge_within,
        &mut policy.homing_start_within,
        &mut policy.homing_idle,
    ];
    for time in times {
        *time = Duration::from_millis(bytes.pick(&[0, 10, 100, 1_000, 5_000]));
    }
    (policy.latency, policy.mode_before_enable) = (bytes.byte() % 4, bytes.once_in(2));
    (policy.acknowledge_may_be_high, policy.homing_clears_attained) = (bytes.once_in(2), bytes.once_in(2));
    policy.quick_stop = bytes.pick(&[None, StopOption::quick_stop(if stays { 6 } else { 2 })]);
    policy
}

fn asked(bytes: &mut Bytes<'_>) -> Request {
    let within = Duration::from_millis(bytes.pick(&[0, 100, 10_000]));
    let mode = Mode(bytes.pick(&[8, 8, 9, 10, 1, 3, 4, 6, 0, -1, 127]));
    match bytes.byte() % 16 {
        0..=4 => Request::Enable(mode),
        5 => Request::EnableWithTarget(bytes.signed32()),
        6 => Request::Reach(bytes.pick(State::ALL)),
        7 => Request::Disable,
        8 => Request::QuickStop,
        9 => Request::Resume,
        10 => Request::ResetFault,
        11 => Request::SelectMode(mode),
        12 => Request::MoveTo(SetPoint::to(bytes.signed32()), within),
        13 => Request::Velocity(bytes.signed32(), within),
        14 => Request::Shutdown,
        _ => Request::Home(within),
    }
}

/// Whether it gave a target, in an operation that the client believes in.
fn command(axis: &mut Axis, bytes: &mut Bytes<'_>) -> bool {
    let given = match bytes.byte() % 4 {
        0 => return set(axis.halt(bytes.once_in(2))),
        1 => axis.target_velocity(bytes.signed32()),
        2 => axis.target_position(bytes.signed32()),
        _ => return set(axis.set_maker_bits(bytes.word())),
    };
    given.map_err(|error| assert!(!error.to_string().is_empty())).is_ok()
}

fn set((): ()) -> bool {
    false
}

/// What arrives of what the drive sends. Nonsense never looks like operation, and never like another place: a drive that
/// lies about those can be enabled anywhere.
fn seen(drive: &Drive, bytes: &mut Bytes<'_>) -> Option<Sample> {
    let bits = if bytes.once_in(4) { bytes.word() & 0x3400 } else { 0 };
    let word = Statusword(drive.state.pattern().1 | Statusword::REMOTE | bits);
    let honest = Sample { mode: Some(drive.mode), position: Some(drive.place), ..Sample::new(word) };
    match bytes.byte() % 16 {
        0 => None,
        1 => Some(Sample { position: None, mode: None, ..honest }),
        2 => {
            let nonsense = Statusword(bytes.word());
            let operates = nonsense.state() == Some(State::OperationEnabled);
            Some(Sample {
                statusword: if operates { word } else { nonsense },
                error_code: Some(bytes.word()),
                ..honest
            })
        }
        _ => Some(honest),
    }
}

/// What holds in every cycle.
fn judge(axis: &Axis, request: Request, tried: Duration, outputs: Outputs) {
    assert!(axis.progress() != Progress::Pending || tried <= BOUND, "{request:?} has no end");
    let word = outputs.controlword;
    assert!(!word.fault_reset() || request == Request::ResetFault, "{word} for {request:?}");
    let edges = matches!(request, Request::MoveTo(..) | Request::Home(_));
    assert!(!word.mode_4() || edges, "{word} for {request:?}");
}

fn obey(drive: &mut Drive, bytes: &mut Bytes<'_>, outputs: Outputs) -> Option<Transition> {
    let word = outputs.controlword;
    let cause = match bytes.byte() {
        0 | 1 => Some(Cause::Fault),
        2..=100 if matches!(drive.state, State::NotReadyToSwitchOn | State::FaultReactionActive) => {
            Some(Cause::Done)
        }
        2..=100 if drive.state == State::QuickStopActive && !drive.stays => Some(Cause::Done),
        _ => Transition::command(drive.state, word, drive.before).map(Cause::Command),
    };
    let options = Options { quick_stop_stays: drive.stays, fault_persists: false };
    let made = cause.and_then(|cause| Transition::of(drive.state, cause, options));
    (drive.mode, drive.before) = (outputs.mode, word);
    drive.state = made.map_or(drive.state, Transition::to);
    made
}

/// How operation begins. A target that the program has given since it asked is its own: messages may be lost so that client
/// and drive do not agree on whether there is operation.
fn begins(axis: &Axis, made: Option<Transition>, place: i32, outputs: Outputs, request: Request) {
    let Some(made) = made.filter(|made| made.to() == State::OperationEnabled) else { return };
    let limit = axis.policy().seed_limit;
    let here = outputs.position.abs_diff(place) <= limit || outputs.mode != Mode::CYCLIC_POSITION;
    assert!(here, "operation begins with the target {} at {place}", outputs.position);
    assert!(outputs.velocity == 0 && outputs.torque == 0, "operation begins with {outputs:?}");
    assert!(made.number() != 16 || request == Request::Resume, "transition 16 for {request:?}");
}

fn follow(drive: &mut Drive, outputs: Outputs) {
    if drive.state == State::OperationEnabled && outputs.mode == Mode::CYCLIC_POSITION {
        drive.place = outputs.position;
    }
}

/// The words of an error, and that it can be shown.
fn ended(axis: &Axis) -> Option<&'static str> {
    let Progress::Failed(error) = axis.progress() else { return None };
    assert!(!error.to_string().is_empty());
    Some(error.doing.word())
}
