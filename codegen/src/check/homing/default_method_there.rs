//! E1108: the default of 6098h is a homing method that the drive does not have.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code =
    Code::error("E1108", "the default of 6098h is a homing method that the drive does not have");
const WHY: &str = "a drive as delivered would answer the start of homing with an error";
const HELP: &str = "add the method to `homing`, correct the default, or add an erratum with both lines";

/// Looks for the default of 6098h among the methods that the drive has.
pub(in crate::check) const LINT: Lint =
    Lint { code: CODE, page: include_str!("default_method_there.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let Some(entry) = super::selector(model) else { return };
    if entry.default.as_ref().is_some_and(super::settled) {
        return;
    }
    let none = |number: i128| number == 0 || super::has_method(model, number);
    let Some(default) = entry.default_int().filter(|default| !none(default.value)) else { return };
    let text = format!("`{}` defaults to {}, which is no method of the drive", entry.address, default.value);
    sink.push(super::finding(CODE, default.span, &entry.address, text, WHY, HELP));
}
