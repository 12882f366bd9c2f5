//! Homing methods.

pub(super) mod abort_not_awaited;
pub(super) mod cases_apart;
pub(super) mod columns_agree;
pub(super) mod default_method_there;
pub(super) mod edges_alternate;
pub(super) mod ends_at_home;
pub(super) mod methods_in_range;
pub(super) mod one_home;

use super::{finding, settled, unsettled};
use crate::model::{Address, Entry, Event, HomingCase, HomingMethod, HomingStatus, Model, Moves};

/// Every case with its method.
fn cases(model: &Model) -> impl Iterator<Item = (&HomingMethod, &HomingCase)> {
    model.homing.iter().flat_map(|method| method.cases.iter().map(move |case| (method, case)))
}

/// How messages and allowances name a case.
fn case_row(method: &HomingMethod, case: &HomingCase) -> String {
    let number = case.number.map_or_else(String::new, |n| format!(".{n}"));
    format!("homing {}{number}", method.number)
}

/// The object that selects a method, where the drive has methods to select.
fn selector(model: &Model) -> Option<&Entry> {
    let (_, entry) = model.entry(Address::new(0x6098, 0))?;
    (!model.homing.is_empty()).then_some(entry)
}

/// Whether the drive has the method with this number.
fn has_method(model: &Model, number: i128) -> bool {
    let supported = |m: &&HomingMethod| m.status.value == HomingStatus::Supported;
    model.homing.iter().filter(supported).any(|m| i128::from(m.number) == number)
}

/// The event of the move before the last one.
fn before_last(moves: &Moves) -> Option<Event> {
    let moves: Vec<_> = moves.moves().collect();
    moves.get(moves.len().checked_sub(2)?).map(|(_, _, until)| *until)
}
