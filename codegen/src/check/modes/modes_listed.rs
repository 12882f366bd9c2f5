//! W0702: 6060h and the table of modes name different modes.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Address, Model};

const CODE: Code = Code::warning("W0702", "6060h and the table of modes name different modes");
const WHY: &str = "a mode without a row has no name and no objects in the documentation, and one that 6060h does not take cannot be chosen";
const HELP: &str = "add the missing row or value from the chapter on modes; if the manual contradicts itself, add an erratum with both lines";

/// Compares the values that 6060h allows with the table `modes`.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("modes_listed.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let allow = model.entry(Address::new(0x6060, 0)).and_then(|(_, entry)| entry.allow.as_ref());
    let Some(allow) = super::unsettled(allow).filter(|_| !model.modes.is_empty()) else { return };
    let listed = |mode: i128| mode == 0 || model.modes.iter().any(|m| i128::from(m.number) == mode);
    for mode in allow.value.iter().filter(|mode| !listed(**mode)) {
        let text = format!("`6060:00` allows {mode}, and the table `modes` has no such mode");
        sink.push(super::finding(CODE, allow.span(), &"6060:00", text, WHY, HELP));
    }
    let allowed = |number: i8| allow.value.contains(&number.into());
    for mode in model.modes.iter().filter(|m| !allowed(m.number) && !super::settled(&m.name)) {
        let text = format!("`mode {}` is not among the values that 6060:00 allows", mode.number);
        sink.push(
            super::finding(CODE, mode.name.span(), &format!("mode {}", mode.number), text, WHY, HELP)
                .related(allow.span(), "these are"),
        );
    }
}
