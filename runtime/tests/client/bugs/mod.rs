//! Bugs that recur in libraries for CiA 402, by number: what the client does instead.

mod homing;
mod modes;
mod motion;
mod states;

use drivewright_runtime::cia402::{Mode, State};
use drivewright_runtime::client::axis::{Axis, AxisErrorKind, AxisPolicy, Progress};

use crate::fake::{run, Fake};

/// An axis in operation.
fn enabled(mode: Mode, policy: AxisPolicy, fake: Fake) -> (Axis, Fake) {
    let (mut axis, mut fake) = (Axis::new(policy), fake);
    axis.enable(mode);
    assert_eq!(run(&mut axis, &mut fake), Progress::Done);
    (axis, fake)
}

fn off() -> Fake {
    Fake::new(State::SwitchOnDisabled)
}

/// Runs the goal to its failure.
fn failure(axis: &mut Axis, fake: &mut Fake) -> AxisErrorKind {
    match run(axis, fake) {
        Progress::Failed(error) => error.kind,
        other => panic!("{other:?}"),
    }
}

/// The default with something else.
fn policy(change: impl FnOnce(&mut AxisPolicy)) -> AxisPolicy {
    let mut policy = AxisPolicy::default();
    change(&mut policy);
    policy
}
