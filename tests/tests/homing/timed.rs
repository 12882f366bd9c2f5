//! Homing in steps of time: planner, inner loops and a physical axis.

use core::time::Duration;

use drivewright_runtime::homing::interpreter::{Command, Crossing, Run, StartError};
use drivewright_runtime::homing::{Event, HomingDesc, Pace, Side};
use drivewright_runtime::sim::planner::{Limits, Planner};
use drivewright_runtime::sim::plant::{Plant, PlantConfig, Setpoint};

use crate::{BRAKE, FAST, Outcome, SLOW, STOP, Scene};

const STEP: Duration = Duration::from_millis(1);

/// How long the torque is at its limit at a hard stop.
const STALL: Duration = Duration::from_millis(50);

/// Homes an axis.
pub(crate) fn home(method: &HomingDesc<'_>, scene: Scene) -> Result<Outcome, StartError> {
    let config = PlantConfig {
        start: scene.start,
        lower_stop: -STOP,
        upper_stop: STOP,
        switches: scene.switches,
        ..PlantConfig::default()
    };
    let mut axis = Plant::new(config).expect("such an axis can be");
    let mut planner = Planner::at(scene.start);
    let mut run = Run::start(method, axis.levels())?;
    for _ in 0..60_000 {
        match run.command() {
            Command::Finished { home } => return Ok(Outcome::Home(home)),
            Command::Failed(failure) => return Ok(Outcome::Failed(failure)),
            command => obey(command, &mut planner),
        }
        let point = planner.step(STEP);
        let (target, velocity, acceleration) = (point.position, point.velocity, point.acceleration);
        axis.step(Setpoint::Position { target, velocity, acceleration }, STEP);
        for crossing in axis.crossings() {
            run.event(*crossing);
        }
        if axis.contact().is_some() && !run.awaits().any(|event| event == Event::Stall) {
            return Ok(Outcome::Struck);
        }
        if axis.stalled() >= STALL {
            let stall = Crossing { event: Event::Stall, position: axis.position(), direction: axis.driven() };
            run.event(stall);
            planner.hold(axis.position());
        }
        if planner.done() && planner.point().velocity == 0 && axis.position() == planner.point().position {
            run.standstill(axis.position());
        }
    }
    Ok(Outcome::Endless)
}

/// Plans what the program commands.
fn obey(command: Command, planner: &mut Planner) {
    let limits = |speed: i64| Limits { velocity: speed * 256, acceleration: BRAKE, deceleration: BRAKE };
    match command {
        Command::Move { direction, pace } => {
            let speed = if pace == Pace::Fast { FAST } else { SLOW };
            let sign = if direction == Side::Positive { 1 } else { -1 };
            planner.run_at(sign * speed * 256, limits(speed));
        }
        Command::Return { to } => planner.move_to(to, limits(FAST)),
        _ => planner.stop(BRAKE),
    }
}
