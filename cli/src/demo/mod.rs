//! `demo`: the client of the runtime with a virtual drive of any profile. It is enabled, homed, run in each of its modes,
//! made to fault, reset and disabled; what happened is told with units.

mod actor;
mod cyclic;
mod fault;
mod home;
mod profile;
mod told;

use clap::Args;
use drivewright_codegen::live::Live;
use drivewright_runtime::cia402::Mode;
use drivewright_runtime::mapping::Direction;
use drivewright_runtime::sim::{Config, VirtualDrive};

use crate::End;
use crate::drives::{Found, find};
use crate::output::{Shape, tell, working};
use crate::stage::{self, Pace, Recorder, TraceFiles, Watched, image};
use crate::trace::Trace;
use actor::{Actor, PAUSE, Scene};

/// Examples.
pub(crate) const HELP: &str = "\
Examples:
  drivewright demo
  drivewright demo sdv3-e --plot demo.svg
  drivewright demo profiles/acme/x1 --json
  drivewright demo --speed real

No hardware is needed, and none is touched. `drivewright simulate DRIVE` lists what is assumed where manuals are silent.";

/// What `demo` is asked for.
#[derive(Args)]
pub(crate) struct DemoArguments {
    /// Id of a drive below `profiles/`, or the profile's folder.
    #[arg(default_value = "sdv3-e")]
    pub(crate) drive: String,
    /// How fast time goes: max, real, or a number of virtual seconds a second.
    #[arg(long, value_name = "SPEED", default_value = "max", value_parser = Pace::read)]
    pub(crate) speed: Pace,
    #[command(flatten)]
    pub(crate) files: TraceFiles,
}

/// Runs the command.
pub(crate) fn run(asked: &DemoArguments, shape: Shape) -> End {
    let found = match find(&asked.drive) {
        Ok(found) => found,
        Err(end) => return end,
    };
    let config = Config::default();
    let ran = stage::with(&found, config, |live, drive| {
        if let Some(missing) = missing(drive) {
            tell!(
                "error: {} cannot be shown: its profile {missing}; `drivewright todo {0}` lists what it lacks",
                found.id
            );
            return End::Findings;
        }
        let working = working(&format!("running {}", found.id), shape.quiet || shape.json);
        let played = play(&found, live, drive, asked.speed);
        drop(working);
        match played {
            Ok(played) => told::tell(&played, shape).max(asked.files.write(&played.trace)),
            Err(why) => {
                tell!("error: {} cannot be shown: {why}", found.id);
                End::Findings
            }
        }
    });
    ran.unwrap_or_else(|end| end)
}

/// What was done, and what came of it.
struct Played {
    title: String,
    trace: Trace,
    scenes: Vec<Scene>,
    /// What the client says of the fault.
    fault: String,
    /// Why it ended early.
    failed: Option<String>,
}

/// Why there is nothing to show.
fn missing(drive: &VirtualDrive<'_, '_>) -> Option<&'static str> {
    use drivewright_runtime::Address;
    let has = |index| drive.model().object(Address::new(index, 0)).is_some();
    if !has(0x6040) || !has(0x6041) {
        return Some("has no controlword and statusword");
    }
    if drive.model().modes().is_empty() || !has(0x6060) || !has(0x6061) {
        return Some("states no modes of operation");
    }
    None
}

fn play(
    found: &Found,
    live: &Live<'_>,
    drive: &mut VirtualDrive<'_, '_>,
    speed: Pace,
) -> Result<Played, String> {
    let config = *drive.config();
    let model = drive.model();
    let (rx, tx) = (image::mapped(drive, Direction::Rx), image::mapped(drive, Direction::Tx));
    let title = stage::title(found);
    let recorder = Recorder::new(model, format!("{title}: from power-on to a fault and back"), speed);
    let bus = Watched::new(drive, config.cycle, recorder);
    let mut actor = Actor::new(model, bus, (&rx, &tx))?;
    let failed = act(&mut actor, live).err();
    let fault = std::mem::take(&mut actor.fault);
    let scenes = std::mem::take(&mut actor.scenes);
    let trace = actor.into_trace();
    Ok(Played { title, trace, scenes, fault, failed })
}

/// The whole play.
fn act(actor: &mut Actor<'_, '_, '_, '_>, live: &Live<'_>) -> Result<(), String> {
    let modes: Vec<Mode> = actor.model().modes().iter().map(|mode| Mode(mode.number())).collect();
    let first = if modes.contains(&Mode::HOMING) {
        Mode::HOMING
    } else {
        modes.first().copied().unwrap_or(Mode::NONE)
    };
    actor.scene("switched on", Actor::start)?;
    actor.scene("enable", |actor| actor.enable(first))?;
    if first == Mode::HOMING {
        home::scene(actor)?;
    }
    for mode in modes.iter().copied().filter(|mode| *mode != Mode::HOMING) {
        match mode {
            Mode::PROFILE_POSITION => actor.scene("profile position", profile::position)?,
            Mode::PROFILE_VELOCITY => actor.scene("profile velocity", profile::velocity)?,
            Mode::PROFILE_TORQUE => actor.scene("profile torque", profile::torque)?,
            Mode::CYCLIC_POSITION => actor.scene("cyclic synchronous position", cyclic::position)?,
            Mode::CYCLIC_VELOCITY => actor.scene("cyclic synchronous velocity", cyclic::velocity)?,
            Mode::CYCLIC_TORQUE => actor.scene("cyclic synchronous torque", cyclic::torque)?,
            other => actor.skip(&crate::trace::mode_name(other), "this demonstration has no part for it"),
        }
    }
    if actor.model().alarms().is_empty() {
        actor.skip("fault", "the profile has no alarms");
    } else {
        actor.scene("fault", |actor| fault::provoke(actor, &modes, live))?;
        actor.scene("reset", fault::reset)?;
        actor.scene("enable again", |actor| actor.enable(first))?;
    }
    actor.scene("disable", Actor::disable)?;
    actor.hold(PAUSE)
}
