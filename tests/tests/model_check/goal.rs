//! What a program asks of a client, one goal after the other.

use core::time::Duration;

use drivewright_runtime::cia402::{Mode, State, StopOption};
use drivewright_runtime::client::axis::{Axis, AxisPolicy, SetPoint};

/// A cycle. Times are few cycles, so that all that can happen is not too much.
pub(crate) const CYCLE: Duration = Duration::from_millis(10);
/// How long a move and homing may take.
const WITHIN: Duration = Duration::from_millis(120);

/// Where a move goes.
pub(crate) const TARGET: i32 = super::drive::PLACE + 500;

#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(crate) enum Goal {
    Enable(i8),
    Reach(State),
    Select(i8),
    Disable,
    QuickStop,
    Resume,
    Reset,
    Move,
    Velocity,
    Home,
}

impl Goal {
    pub(crate) fn begin(self, axis: &mut Axis) {
        match self {
            Self::Enable(mode) => axis.enable(Mode(mode)),
            Self::Reach(state) => axis.reach(state),
            Self::Select(mode) => axis.select_mode(Mode(mode)),
            Self::Disable => axis.disable(),
            Self::QuickStop => axis.quick_stop(),
            Self::Resume => axis.resume(),
            Self::Reset => axis.reset_fault(),
            Self::Move => axis.move_to(SetPoint::to(TARGET), WITHIN),
            Self::Velocity => axis.velocity(100, WITHIN),
            Self::Home => axis.home(WITHIN),
        }
    }
}

/// Everything that a program may ask for, as sequences: a goal begins when the one before has ended.
pub(crate) fn plans() -> Vec<Vec<Goal>> {
    use Goal::{Disable, Enable, Home, Move, QuickStop, Reach, Reset, Resume, Select, Velocity};
    let mut plans: Vec<Vec<Goal>> = [1, 3, 4, 6, 8, 9, 10].map(|mode| vec![Enable(mode)]).to_vec();
    plans.extend(State::ALL.iter().map(|state| vec![Reach(*state)]));
    plans.extend([
        vec![Select(6)],
        vec![Disable],
        vec![QuickStop],
        vec![Resume],
        vec![Reset],
        vec![Move],
        vec![Home],
        vec![Velocity],
        vec![Enable(8), Disable],
        vec![Enable(8), QuickStop, Resume],
        vec![Enable(8), QuickStop, Enable(9)],
        vec![Enable(1), Move],
        vec![Enable(6), Home],
        vec![Enable(9), Velocity],
        vec![Enable(8), Select(10)],
        vec![Reset, Enable(8)],
    ]);
    plans
}

/// Short times; everything else as most drives need it.
pub(crate) fn policy(stays: bool) -> AxisPolicy {
    let mut policy = AxisPolicy::default();
    let times = [
        &mut policy.state_within,
        &mut policy.mode_within,
        &mut policy.reset_within,
        &mut policy.acknowledge_within,
        &mut policy.homing_start_within,
        &mut policy.homing_idle,
    ];
    for (time, cycles) in times.into_iter().zip([8, 4, 4, 5, 5, 3]) {
        *time = CYCLE * cycles;
    }
    (policy.edge_hold, policy.stale_after, policy.latency) = (CYCLE, CYCLE * 2, 1);
    policy.quick_stop = StopOption::quick_stop(if stays { 6 } else { 2 });
    policy
}
