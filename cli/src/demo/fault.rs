//! A fault, what the manual says of it, and the way out.

use std::time::Duration;

use drivewright_codegen::live::Live;
use drivewright_runtime::cia402::Mode;
use drivewright_runtime::client::fault::{Fault, ReadFault};
use drivewright_runtime::model::{AlarmDesc, AlarmText, Reset};

use super::actor::{Actor, PAUSE, said};
use super::profile::TARGET_VELOCITY;
use crate::stage::named;

/// Makes the drive fault while it turns, if it can turn: process data stop. A drive that does not mind gets an alarm.
pub(super) fn provoke(
    actor: &mut Actor<'_, '_, '_, '_>,
    modes: &[Mode],
    live: &Live<'_>,
) -> Result<String, String> {
    if modes.contains(&Mode::PROFILE_VELOCITY) {
        let speed = actor.speed(TARGET_VELOCITY, 300);
        actor.drive.velocity(speed, Duration::from_secs(10)).map_err(said)?;
    }
    let watchdog = actor.machine().config().watchdog;
    let mut how = "the master stopped sending process data";
    actor.rest(watchdog + Duration::from_millis(50));
    if actor.machine().alarms().next().is_none() {
        how = "it was raised by hand";
        let alarm = alarm(actor, live).ok_or("the profile has no alarm")?;
        let raised = actor.machine().raise(alarm.display(), alarm.number());
        raised.map_err(|error| error.to_string())?;
    }
    actor.rest(Duration::from_millis(400));
    let active = actor.machine().alarms().next().ok_or("the drive has no fault")?.alarm;
    actor.number("code", active.code().into());
    explain(actor, live)?;
    Ok(format!("{}: {how}", named(active)))
}

/// The alarm that teaches most: it can be reset, and the manual has causes and remedies.
fn alarm<'m>(actor: &mut Actor<'_, '_, 'm, '_>, live: &Live<'_>) -> Option<&'m AlarmDesc<'m>> {
    let alarms = actor.model().alarms();
    let texts = live.alarm_texts();
    let resettable = |alarm: &&AlarmDesc<'_>| alarm.reset() == Reset::Resettable;
    let told = |alarm: &&AlarmDesc<'_>| {
        AlarmText::find(texts, alarm).is_some_and(|t| !t.causes().is_empty() && !t.remedies().is_empty())
    };
    let best = alarms.iter().find(|alarm| resettable(alarm) && told(alarm));
    best.or_else(|| alarms.iter().find(resettable)).or(alarms.first())
}

/// What the client says of it, with the texts of the manual's table and where they are.
fn explain(actor: &mut Actor<'_, '_, '_, '_>, live: &Live<'_>) -> Result<(), String> {
    let model = live.model();
    let Ok(evidence) = actor.drive.call(&mut ReadFault::new(model));
    let fault = Fault::new(model, live.alarm_texts(), evidence.map_err(|error| error.to_string())?);
    let mut told = fault.to_string();
    let sources = fault.alarms().filter_map(|alarm| Some((alarm.display(), live.alarm_source(alarm)?)));
    told.extend(sources.map(|(display, source)| format!("\n  source : {display}: {source}")));
    actor.fault = told;
    Ok(())
}

/// Resets it, or switches the drive off and on where a reset does not clear it.
pub(super) fn reset(actor: &mut Actor<'_, '_, '_, '_>) -> Result<String, String> {
    let clears = |reset| matches!(reset, Reset::Resettable | Reset::NotStated);
    let resettable = actor.machine().alarms().all(|active| clears(active.alarm.reset()));
    if resettable {
        actor.operate()?;
        actor.drive.reset_fault().map_err(said)?;
        actor.hold(PAUSE)?;
        return Ok(format!("by a rising edge of bit 7; {}", actor.machine().state()));
    }
    actor.machine().power_cycle();
    let start_up = actor.machine().config().start_up;
    actor.rest(start_up);
    actor.operate()?;
    actor.drive.client_mut().forget();
    Ok("by switching the control supply off and on, as the manual asks".to_owned())
}
