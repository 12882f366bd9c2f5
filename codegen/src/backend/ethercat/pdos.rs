//! Process data: which PDOs are active by default, which can be changed, which exclude each other.

use super::Assumptions;
use crate::model::{Access, Address, Direction, Model, Pdo};

const FIRST: &str = "1C12h or 1C13h has no default, and the first PDO is the one that drives start with";
const FIXED: &str = "no mapping object says that it can be written, and a fixed mapping claims nothing";

/// A PDO as a device file lists it.
#[derive(Clone, PartialEq, Debug)]
pub struct AssignedPdo<'m> {
    /// The PDO.
    pub pdo: &'m Pdo,
    /// Whether its mapping cannot be written.
    pub fixed: bool,
    /// Whether it is active by default.
    pub assigned: bool,
    /// PDOs that cannot be active together with it.
    pub excludes: Vec<u16>,
}

/// The PDOs of `model`, by index.
pub(super) fn pdos<'m>(model: &'m Model, assumed: &mut Assumptions) -> Vec<AssignedPdo<'m>> {
    let active = [
        assignment(model, 0x1C12, Direction::Rx, assumed),
        assignment(model, 0x1C13, Direction::Tx, assumed),
    ]
    .concat();
    let mut pdos: Vec<AssignedPdo<'m>> = Vec::with_capacity(model.pdos.len());
    for pdo in &model.pdos {
        pdos.push(AssignedPdo {
            pdo,
            fixed: fixed(model, pdo, assumed),
            assigned: active.contains(&pdo.index),
            excludes: excludes(model, pdo),
        });
    }
    pdos
}

/// Indexes of the PDOs that `object` assigns by default.
fn assignment(model: &Model, object: u16, direction: Direction, assumed: &mut Assumptions) -> Vec<u16> {
    let number = |sub| model.default_int(Address::new(object, sub)).and_then(|n| u16::try_from(n).ok());
    if let Some(count) = number(0).and_then(|n| u8::try_from(n).ok()) {
        return (1..=count).filter_map(number).collect();
    }
    let first = model.pdos.iter().find(|pdo| pdo.direction == direction).map(|pdo| pdo.index);
    let named = |index: u16| {
        assumed.take(format!("Active {direction}PDO", direction = name(direction)), index, hex(index), FIRST)
    };
    first.map(named).into_iter().collect()
}

fn name(direction: Direction) -> &'static str {
    match direction {
        Direction::Rx => "Rx",
        Direction::Tx => "Tx",
    }
}

fn hex(index: u16) -> String {
    format!("{index:04X}h")
}

/// A mapping that can be written says so by the access of its object.
fn fixed(model: &Model, pdo: &Pdo, assumed: &mut Assumptions) -> bool {
    match writable(model, pdo.index) {
        Some(writable) => !writable,
        None => assumed.take(format!("PDO {}, fixed", hex(pdo.index)), true, true, FIXED),
    }
}

/// Whether any entry of the object can be written; `None` for an object that is not there.
pub(super) fn writable(model: &Model, index: u16) -> Option<bool> {
    let object = model.object(index)?;
    let access = object.entries.iter().map(|id| model.entries[*id].access.value);
    Some(access.into_iter().any(|access| matches!(access, Access::Rw | Access::Wo)))
}

/// Where one PDO of a direction can be active at a time, each excludes all others.
fn excludes(model: &Model, pdo: &Pdo) -> Vec<u16> {
    if model.drive.limits.pdos_per_direction.as_ref().is_none_or(|limit| limit.value != 1) {
        return Vec::new();
    }
    let others = model.pdos.iter().filter(|other| other.direction == pdo.direction);
    others.map(|other| other.index).filter(|index| *index != pdo.index).collect()
}
