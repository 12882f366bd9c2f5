//! Homing: a method that the drive has, to a switch if there is one.

use drivewright_runtime::Address;
use drivewright_runtime::client::home::Homing;
use drivewright_runtime::homing::{HomingDesc, HomingStatus};
use drivewright_runtime::model::DriveModel;

use super::actor::{Actor, said};

const FAST: Address = Address::new(0x6099, 1);
const SLOW: Address = Address::new(0x6099, 2);
const OFFSET: Address = Address::new(0x607C, 0);

/// Methods that say something to a reader go first: to a limit switch, to one with the index pulse, to the home switch,
/// to the index pulse, and where the axis stands.
const PREFERRED: &[i8] = &[17, 18, 1, 2, 19, 20, 21, 22, 33, 34, 35, 37];

pub(super) fn scene(actor: &mut Actor<'_, '_, '_, '_>) -> Result<(), String> {
    if let Some(method) = method(actor.model()) {
        return actor.scene(&format!("home by method {method}"), |actor| home(actor, method));
    }
    actor.skip("home", "the profile describes no homing method");
    Ok(())
}

fn method(model: &DriveModel<'_>) -> Option<i8> {
    let runs = |number: i8| {
        let found = model.homing(number).filter(|m| m.status() == HomingStatus::Supported);
        found.is_some_and(|method| !method.cases().is_empty())
    };
    let others = model.homing_methods().iter().map(HomingDesc::number);
    PREFERRED.iter().copied().chain(others).find(|number| runs(*number))
}

fn home(actor: &mut Actor<'_, '_, '_, '_>, method: i8) -> Result<String, String> {
    let start = actor.machine().axis().position();
    let mut homing = Homing::method(method).keep_mode();
    if actor.model().object(FAST).is_some() && actor.model().object(SLOW).is_some() {
        homing = homing.speeds(actor.speed(FAST, 300), actor.speed(SLOW, 30));
    }
    if actor.model().object(OFFSET).is_some() {
        homing = homing.offset(0);
    }
    actor.drive.home(homing).map_err(said)?;
    let (origin, place) = (actor.machine().origin(), actor.machine().axis().position());
    let revolution = actor.machine().axis().config().switches.revolution;
    let position = actor.position();
    actor.number("method", method.into());
    actor.number("home_count", origin);
    actor.number("count", place);
    actor.number("position", position);
    let rests = actor.told(crate::stage::POSITION, position);
    Ok(format!(
        "home lies {} rev from where the axis was switched on; it stands at {rests}",
        thousandths(origin - start, revolution)
    ))
}

/// A fraction with three decimals and a sign.
fn thousandths(num: i64, den: i64) -> String {
    let n = (i128::from(num) * 1000).checked_div(den.into()).unwrap_or(0);
    format!("{}{}.{:03}", if n < 0 { "-" } else { "+" }, n.abs() / 1000, n.abs() % 1000)
}
