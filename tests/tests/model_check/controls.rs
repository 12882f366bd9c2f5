//! Clients with mistakes: the search must see each.

use core::time::Duration;

use drivewright_runtime::cia402::{Command, Controlword, State, Statusword};
use drivewright_runtime::client::axis::{Axis, Outputs, Sample};

use super::goal::{CYCLE, Goal};
use super::search::{LOSSY, Search};
use super::world::{Client, real};

/// Targets of 0 until the axis is in operation.
fn unseeded(axis: &mut Axis, sample: Option<Sample>) -> Outputs {
    let outputs = axis.step(CYCLE, sample);
    if axis.is_enabled() { outputs } else { Outputs { position: 0, ..outputs } }
}

/// Resets every fault that it sees.
fn eager(axis: &mut Axis, sample: Option<Sample>) -> Outputs {
    let outputs = axis.step(CYCLE, sample);
    let fault = sample.is_some_and(|s| s.statusword.state() == Some(State::Fault));
    if fault { with(outputs, Command::FaultReset) } else { outputs }
}

/// Enables out of a quick stop.
fn resuming(axis: &mut Axis, sample: Option<Sample>) -> Outputs {
    let outputs = axis.step(CYCLE, sample);
    let stopped = sample.is_some_and(|s| s.statusword.state() == Some(State::QuickStopActive));
    if stopped { with(outputs, Command::EnableOperation) } else { outputs }
}

/// Has no clock, so that no time is ever over.
fn timeless(axis: &mut Axis, sample: Option<Sample>) -> Outputs {
    axis.step(Duration::ZERO, sample)
}

/// Takes the drive for switched on, whatever it shows.
fn deaf(axis: &mut Axis, _: Option<Sample>) -> Outputs {
    axis.step(CYCLE, Some(Sample::new(Statusword(0x0233))))
}

fn with(outputs: Outputs, command: Command) -> Outputs {
    Outputs { controlword: Controlword(outputs.controlword.0).with_command(command), ..outputs }
}

fn search(plan: &[Goal], client: Client) -> Search {
    Search {
        plan: plan.to_vec(),
        stays: true,
        outputs: LOSSY,
        samples: LOSSY,
        faults: 1,
        anytime: false,
        client,
    }
}

fn breaks(plan: &[Goal], client: Client) -> Option<&'static str> {
    assert_eq!(search(plan, real).run().broken, None, "it is the mistake that is seen");
    search(plan, client).run().broken.map(|(why, _)| why)
}

#[test]
fn b31_a_target_without_a_seed_is_seen() {
    assert_eq!(breaks(&[Goal::Enable(8)], unseeded), Some("operation begins without a seeded target"));
}

#[test]
fn a_reset_that_nobody_asked_for_is_seen() {
    assert_eq!(breaks(&[Goal::Disable], eager), Some("a fault reset is not asked for"));
}

#[test]
fn b04_operation_out_of_a_quick_stop_is_seen() {
    let why = breaks(&[Goal::QuickStop], resuming);
    assert!(why.is_some_and(|why| why.ends_with("is not asked for")), "{why:?}");
}

#[test]
fn a_client_that_does_not_look_is_seen() {
    assert_eq!(breaks(&[Goal::Reach(State::SwitchedOn)], deaf), Some("it is not done"));
}

#[test]
fn a_goal_without_an_end_is_seen() {
    assert_eq!(search(&[Goal::Reset], timeless).run().longest, usize::MAX);
    assert!(search(&[Goal::Reset], real).run().longest < 20);
}
