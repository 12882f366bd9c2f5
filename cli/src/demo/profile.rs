//! The modes in which the drive makes the profile.

use std::time::Duration;

use drivewright_runtime::Address;
use drivewright_runtime::cia402::Mode;
use drivewright_runtime::client::moves::MoveTo;

use super::actor::{Actor, said};
use crate::stage::{POSITION, SPEED, TORQUE};

const PROFILE_VELOCITY: Address = Address::new(0x6081, 0);
pub(super) const TARGET_VELOCITY: Address = Address::new(0x60FF, 0);
pub(super) const TARGET_TORQUE: Address = Address::new(0x6071, 0);
const WITHIN: Duration = Duration::from_secs(20);

/// Eight revolutions towards the middle of the axis.
pub(super) fn position(actor: &mut Actor<'_, '_, '_, '_>) -> Result<String, String> {
    let from = actor.position();
    let inwards = if actor.machine().axis().position() > 0 { -1 } else { 1 };
    let target = from + inwards * 8 * actor.per_revolution();
    let mut there = MoveTo::to(target).within(WITHIN);
    if actor.model().object(PROFILE_VELOCITY).is_some() {
        there = there.velocity(actor.speed(PROFILE_VELOCITY, 600));
    }
    actor.drive.move_to(there).map_err(said)?;
    actor.hold(Duration::from_millis(100))?;
    let reached = actor.position();
    actor.number("target", target);
    actor.number("reached", reached);
    let (from, target) = (actor.told(POSITION, from), actor.told(POSITION, target));
    Ok(format!("from {from} to {target}; stands at {}", actor.told(POSITION, reached)))
}

/// To a speed and back.
pub(super) fn velocity(actor: &mut Actor<'_, '_, '_, '_>) -> Result<String, String> {
    let target = actor.speed(TARGET_VELOCITY, 300);
    actor.drive.velocity(target, WITHIN).map_err(said)?;
    actor.hold(Duration::from_millis(300))?;
    let reached = actor.value(SPEED);
    actor.number("target", target);
    actor.number("reached", reached);
    actor.drive.velocity(0, WITHIN).map_err(said)?;
    let (target, reached) = (actor.told(TARGET_VELOCITY, target), actor.told(SPEED, reached));
    Ok(format!("to {target}; turned at {reached}, and back to standstill"))
}

/// Just more torque than friction takes, for a moment. Nobody waits for bit 10, which some drives do not have in this mode.
pub(super) fn torque(actor: &mut Actor<'_, '_, '_, '_>) -> Result<String, String> {
    actor.drive.select_mode(Mode::PROFILE_TORQUE).map_err(said)?;
    let target = actor.torque(TARGET_TORQUE, 5);
    put(actor, target)?;
    actor.hold(Duration::from_millis(250))?;
    let (torque, speed) = (actor.value(TORQUE), actor.speed_told());
    actor.number("target", target);
    actor.number("reached", torque);
    put(actor, 0)?;
    actor.hold(Duration::from_millis(350))?;
    let target = actor.told(TARGET_TORQUE, target);
    Ok(format!("{target} for a quarter of a second: the axis ran up to {speed}"))
}

/// The torque from the next cycle on.
pub(super) fn put(actor: &mut Actor<'_, '_, '_, '_>, torque: i64) -> Result<(), String> {
    let torque = i16::try_from(torque).map_err(|_| "the target has no 16 bits".to_owned())?;
    actor.drive.client_mut().axis_mut().target_torque(torque).map_err(|error| error.to_string())
}
