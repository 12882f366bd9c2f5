//! E0609: a PDO is assigned that the drive does not have.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Entry, Model};

const CODE: Code = Code::error("E0609", "a PDO is assigned that the drive does not have");
const WHY: &str = "a master that takes the assignment over finds no mapping, or that of the other direction";
const HELP: &str =
    "correct the default: 1C12h takes 1600h and on, 1C13h takes 1A00h and on; or add the mapping object";

/// Looks for the PDOs that 1C12h and 1C13h assign by default among the mapping objects of their direction.
pub(in crate::check) const LINT: Lint =
    Lint { code: CODE, page: include_str!("assigned_pdos_exist.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for entry in model.entries.iter().map(|(_, entry)| entry).filter(|entry| entry.address.sub > 0) {
        let settled = entry.default.as_ref().is_some_and(super::settled);
        let assigned = entry.default_int().filter(|default| default.value != 0 && !settled);
        let Some(default) = assigned.filter(|default| !is_there(model, entry, default.value)) else {
            continue;
        };
        let pdo = default.value;
        let pdo = u16::try_from(pdo).map_or_else(|_| pdo.to_string(), |index| format!("{index:04X}h"));
        let text = format!("`{}` assigns {pdo}, which is no PDO of its direction", entry.address);
        sink.push(super::finding(CODE, default.span, &entry.address, text, WHY, HELP));
    }
}

/// Whether an entry assigns a PDO that is there, or assigns none at all.
fn is_there(model: &Model, entry: &Entry, pdo: i128) -> bool {
    let range = match entry.address.index {
        0x1C12 => 0x1600..=0x17FF,
        0x1C13 => 0x1A00..=0x1BFF,
        _ => return true,
    };
    let known = |index: u16| model.object(index).is_some() || model.pdos.iter().any(|p| p.index == index);
    range.contains(&pdo) && u16::try_from(pdo).is_ok_and(known)
}
