//! W0703: a mode lacks the object that commands it.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Address, Model};

const CODE: Code = Code::warning("W0703", "a mode lacks the object that commands it");
const WHY: &str = "a client can ask for the mode and then has nothing to command";
const HELP: &str =
    "add the row from the manual; if the drive does not have the mode, correct the values of 6060h";

/// The objects that CiA 402 commands each mode with.
const COMMANDS: &[(i128, &[Address])] = &[
    (1, &[Address::new(0x607A, 0), Address::new(0x6081, 0)]),
    (2, &[Address::new(0x6042, 0)]),
    (3, &[Address::new(0x60FF, 0)]),
    (4, &[Address::new(0x6071, 0)]),
    (6, &[Address::new(0x6098, 0), Address::new(0x6099, 1)]),
    (7, &[Address::new(0x60C1, 1)]),
    (8, &[Address::new(0x607A, 0)]),
    (9, &[Address::new(0x60FF, 0)]),
    (10, &[Address::new(0x6071, 0)]),
];

/// Looks for the objects of each mode that 6060h allows, in drives that name the base `cia402`.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("modes_have_objects.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let allow = model.entry(Address::new(0x6060, 0)).and_then(|(_, entry)| entry.allow.as_ref());
    let Some(allow) = super::unsettled(allow).filter(|_| super::based_on(model, "cia402")) else {
        return;
    };
    for (mode, objects) in COMMANDS.iter().filter(|(mode, _)| allow.value.contains(mode)) {
        for object in objects.iter().filter(|object| model.entry(**object).is_none()) {
            let text = format!("`6060:00` allows mode {mode}, and the drive has no {object}");
            sink.push(super::finding(CODE, allow.span(), &"6060:00", text, WHY, HELP));
        }
    }
}
