//! W0412: a position, speed or torque of CiA 402 has no unit.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Address, Class, Entry, Model};
use crate::source::Span;

const CODE: Code = Code::warning("W0412", "a position, speed or torque of CiA 402 has no unit");
const WHY: &str = "the standard leaves the unit to the drive, and a speed in the wrong one is ten or a thousand times too high";
const HELP: &str = "add `unit` from the manual; if it prints none that holds, add an erratum that drops the unit, or accept the finding with `allow`";

/// Looks for the unit of positions, speeds, torques and currents, in drives that name the base `cia402`.
pub(in crate::check) const LINT: Lint =
    Lint { code: CODE, page: include_str!("quantities_have_units.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    if !super::based_on(model, "cia402") {
        return;
    }
    let entries = model.entries.iter().map(|(_, entry)| entry);
    for entry in entries.filter(|entry| entry.unit.is_none() && measures(entry.address)) {
        if !dropped(model, entry.address) {
            let text = format!("`{}` ({}) has no unit", entry.address, entry.name.value);
            sink.push(super::finding(CODE, place(entry), &entry.address, text, WHY, HELP));
        }
    }
}

/// A value that the drive's own row states; that of the base where it states none.
fn place(entry: &Entry) -> Span {
    let stated = [&entry.name.origin, &entry.ty.origin, &entry.access.origin];
    let more = [entry.min.as_ref(), entry.max.as_ref()].into_iter().flatten().map(|limit| &limit.origin);
    let default = entry.default.iter().map(|default| &default.origin);
    let mut own = stated.into_iter().chain(more).chain(default);
    own.find(|origin| !matches!(origin.class, Class::Standard(_))).map_or(entry.name.span(), |o| o.span)
}

/// Whether the value at an address is a position, speed, torque or current.
fn measures(address: Address) -> bool {
    match address.sub {
        0 => matches!(address.index,
            0x6062..=0x6065 | 0x6067 | 0x606B..=0x606D | 0x606F | 0x6071..=0x6074 | 0x6077 | 0x6078 | 0x607A
            | 0x607C | 0x607F..=0x6082 | 0x60B0..=0x60B2 | 0x60BA..=0x60BD | 0x60E0 | 0x60E1 | 0x60F4 | 0x60F8
            | 0x60FC | 0x60FF),
        1 | 2 => matches!(address.index, 0x607B | 0x607D | 0x6099),
        _ => false,
    }
}

/// Whether an erratum speaks of the unit that is not there.
fn dropped(model: &Model, address: Address) -> bool {
    model.errata.iter().any(|(_, erratum)| erratum.address == Some(address) && erratum.field == "unit")
}
