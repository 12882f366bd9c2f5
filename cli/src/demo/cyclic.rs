//! The modes in which the master gives a target every cycle. The targets are whole numbers made by whole numbers, so that
//! they are the same on every host.

use std::time::Duration;

use drivewright_runtime::cia402::Mode;

use super::actor::{Actor, said};
use super::profile::{TARGET_TORQUE, TARGET_VELOCITY, put};
use crate::stage::{POSITION, SPEED, TORQUE};

/// Selects a mode; without process data there is no cycle.
fn select(actor: &mut Actor<'_, '_, '_, '_>, mode: Mode) -> Result<bool, String> {
    if actor.cyclic {
        actor.drive.select_mode(mode).map_err(said)?;
    }
    Ok(actor.cyclic)
}

const NO_CYCLE: &str = "left out: there are no process data";

/// From 0 to 1 of `whole` in the time from 0 to `steps`, along a parabola up to the middle and one after it.
fn s_curve(step: i64, steps: i64, whole: i64) -> i64 {
    let (t, n) = (i128::from(step), i128::from(steps).max(1));
    let part = if 2 * t <= n { 2 * t * t } else { n * n - 2 * (n - t) * (n - t) };
    i64::try_from(i128::from(whole) * part / (n * n)).unwrap_or(whole)
}

/// Up and down again as a triangle, from 0 to `top` to 0.
fn triangle(step: i64, steps: i64, top: i64) -> i64 {
    let steps = steps.max(2);
    top * (steps / 2 - (step - steps / 2).abs()) / (steps / 2)
}

/// A revolution and back.
pub(super) fn position(actor: &mut Actor<'_, '_, '_, '_>) -> Result<String, String> {
    const STEPS: i64 = 800;
    if !select(actor, Mode::CYCLIC_POSITION)? {
        return Ok(NO_CYCLE.to_owned());
    }
    let (from, whole) = (actor.position(), actor.per_revolution());
    let mut behind = 0;
    let forth = (1..=STEPS).map(|step| s_curve(step, STEPS, whole));
    let back = (1..=STEPS).map(|step| whole - s_curve(step, STEPS, whole));
    for way in forth.chain(back) {
        let target = i32::try_from(from + way).map_err(|_| "the target has no 32 bits".to_owned())?;
        let axis = actor.drive.client_mut().axis_mut();
        axis.target_position(target).map_err(|error| error.to_string())?;
        actor.cycle()?;
        behind = behind.max((i64::from(target) - actor.position()).abs());
    }
    actor.hold(Duration::from_millis(100))?;
    let reached = actor.position();
    actor.number("target", from);
    actor.number("reached", reached);
    actor.number("behind", behind);
    let (whole, behind) = (actor.told(POSITION, whole), actor.told(POSITION, behind));
    Ok(format!("{whole} forth and back in {} cycles; never more than {behind} behind", 2 * STEPS))
}

/// Up to a speed and down, one way and the other.
pub(super) fn velocity(actor: &mut Actor<'_, '_, '_, '_>) -> Result<String, String> {
    const STEPS: i64 = 600;
    if !select(actor, Mode::CYCLIC_VELOCITY)? {
        return Ok(NO_CYCLE.to_owned());
    }
    let top = actor.speed(TARGET_VELOCITY, 240);
    let mut fastest = 0;
    for sign in [1, -1] {
        for step in 1..=STEPS {
            let target = sign * triangle(step, STEPS, top);
            let target = i32::try_from(target).map_err(|_| "the target has no 32 bits".to_owned())?;
            let axis = actor.drive.client_mut().axis_mut();
            axis.target_velocity(target).map_err(|error| error.to_string())?;
            actor.cycle()?;
            fastest = fastest.max(actor.value(SPEED));
        }
    }
    actor.hold(Duration::from_millis(50))?;
    actor.number("target", top);
    actor.number("reached", fastest);
    let (top, fastest) = (actor.told(TARGET_VELOCITY, top), actor.told(SPEED, fastest));
    Ok(format!("ramps to {top} and to the same the other way; the fastest was {fastest}"))
}

/// One way, the other way twice as long, and to rest.
pub(super) fn torque(actor: &mut Actor<'_, '_, '_, '_>) -> Result<String, String> {
    if !select(actor, Mode::CYCLIC_TORQUE)? {
        return Ok(NO_CYCLE.to_owned());
    }
    let top = actor.torque(TARGET_TORQUE, 6);
    let mut most = 0;
    for (sign, steps) in [(1, 100), (-1, 150), (1, 50), (0, 150)] {
        for _ in 0..steps {
            put(actor, sign * top)?;
            actor.cycle()?;
            most = most.max(actor.value(TORQUE));
        }
    }
    actor.number("target", top);
    actor.number("reached", most);
    let told = actor.told(TARGET_TORQUE, top);
    Ok(format!("{told} one way, then the other, then none"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_begin_and_end_where_they_should() {
        assert_eq!([0, 400, 800].map(|step| s_curve(step, 800, 8192)), [0, 4096, 8192]);
        assert!((1..=800).all(|step| s_curve(step, 800, 8192) >= s_curve(step - 1, 800, 8192)));
        assert_eq!([0, 150, 300, 450, 600].map(|step| triangle(step, 600, 240)), [0, 120, 240, 120, 0]);
    }
}
