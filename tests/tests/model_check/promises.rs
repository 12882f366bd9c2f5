//! What holds in every state.

use drivewright_runtime::cia402::{Command, Mode, State, Transition};
use drivewright_runtime::client::axis::{Axis, Outputs, Progress};

use super::drive::{Drive, Homing};
use super::goal::{Goal, TARGET};
use super::world::World;

/// A promise that does not hold.
pub(crate) type Broken = &'static str;

/// What was asked for, and what the drive has done since.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
#[allow(clippy::struct_excessive_bools, reason = "each is a promise of its own")]
pub(crate) struct Asked {
    goal: Option<Goal>,
    /// Whether operation was asked for and not taken back.
    operation: bool,
    mode: Option<i8>,
    homed: bool,
    /// The goal has ended in this cycle.
    ends: bool,
    pending: bool,
}

impl Asked {
    pub(crate) fn begin(&mut self, goal: Goal, drive: &Drive) {
        (self.goal, self.pending) = (Some(goal), true);
        match goal {
            Goal::Enable(mode) => (self.operation, self.mode) = (true, Some(mode)),
            Goal::Reach(State::OperationEnabled) | Goal::Resume => self.operation = true,
            Goal::Select(mode) => self.mode = Some(mode),
            Goal::Home => self.homed = false,
            Goal::Reach(_) | Goal::Disable | Goal::QuickStop => self.operation = false,
            // Without a fault there is nothing to reset, and an axis in operation stays there.
            Goal::Move | Goal::Velocity | Goal::Reset => {}
        }
        self.see(drive);
    }

    /// After each step of the client. A mode that was not taken is not wanted any more.
    pub(crate) fn end(&mut self, axis: &Axis) {
        let pending = axis.progress() == Progress::Pending;
        self.ends = self.pending && !pending;
        self.pending = pending;
        if matches!(axis.progress(), Progress::Failed(_)) {
            self.mode = None;
        }
    }

    pub(crate) fn see(&mut self, drive: &Drive) {
        self.operation &= self.goal != Some(Goal::Reset) || !drive.state.is_fault();
        self.homed |= drive.homing == Homing::Runs;
    }
}

/// Whether operation begins where the axis is before it does, and at rest.
fn is_seeded(drive: &Drive, place: i32, limit: u32) -> bool {
    let Outputs { position, velocity, torque, .. } = drive.received;
    let here = position.abs_diff(place) <= limit;
    velocity == 0 && torque == 0 && (here || drive.received.mode != Mode::CYCLIC_POSITION)
}

pub(crate) fn promises(
    world: &World,
    shown: &Drive,
    outputs: Outputs,
    made: Option<Transition>,
) -> Result<(), Broken> {
    let (drive, asked) = (&world.drive, &world.asked);
    let enters = made.is_some_and(|made| made.to() == State::OperationEnabled);
    let sent = outputs.controlword;
    let promised = [
        (
            !enters || is_seeded(drive, shown.place, world.axis.policy().seed_limit),
            "operation begins without a seeded target",
        ),
        (
            made.map(Transition::number) != Some(16) || asked.goal == Some(Goal::Resume),
            "transition 16 is not asked for",
        ),
        (sent.level() != Some(Command::EnableOperation) || asked.operation, "operation is not asked for"),
        (!sent.fault_reset() || asked.goal == Some(Goal::Reset), "a fault reset is not asked for"),
        (!sent.mode_4() || matches!(asked.goal, Some(Goal::Move | Goal::Home)), "bit 4 is not asked for"),
        (asked.mode.is_none_or(|mode| outputs.mode == Mode(mode) || !word_enables(outputs)), "another mode"),
    ];
    promised.into_iter().find(|(holds, _)| !holds).map_or(Ok(()), |(_, why)| Err(why))
}

fn word_enables(outputs: Outputs) -> bool {
    outputs.controlword.level() == Some(Command::EnableOperation)
}

/// What is done was done, as the drive was when it was seen last.
pub(crate) fn done(world: &World, shown: &Drive) -> Result<(), Broken> {
    let (asked, drive) = (&world.asked, &world.drive);
    if !world.strict || !asked.ends || world.axis.progress() != Progress::Done {
        return Ok(());
    }
    let holds = match asked.goal {
        None | Some(Goal::Velocity) => true,
        Some(Goal::Enable(mode)) => shown.state == State::OperationEnabled && shown.mode == Mode(mode),
        Some(Goal::Reach(State::QuickStopActive) | Goal::QuickStop) => shown.state != State::OperationEnabled,
        Some(Goal::Reach(state)) => shown.state == state,
        Some(Goal::Resume) => shown.state == State::OperationEnabled,
        Some(Goal::Select(mode)) => shown.mode == Mode(mode),
        Some(Goal::Disable) => matches!(shown.state, State::FaultReactionActive) || !shown.state.is_powered(),
        Some(Goal::Reset) => !shown.state.is_fault(),
        Some(Goal::Move) => drive.place == TARGET,
        Some(Goal::Home) => asked.homed,
    };
    if holds { Ok(()) } else { Err("it is not done") }
}
