//! W1107: 6098h and the table of homing methods name different methods.

use crate::check::Lint;
use crate::diag::{Code, Diagnostic, Sink};
use crate::model::{Entry, Fact, HomingMethod, HomingStatus, Model};
use crate::source::Span;

const CODE: Code = Code::warning("W1107", "6098h and the table of homing methods name different methods");
const WHY: &str =
    "a client that checks the value refuses a method that the drive has, or offers one that nobody describes";
const HELP: &str = "decide from the chapter on homing which is right, and add an erratum with both lines";

/// Compares the range and the allowed values of 6098h with the methods that the drive has.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("methods_in_range.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let Some(entry) = super::selector(model) else { return };
    for method in model.homing.iter().filter(|m| m.status.value == HomingStatus::Supported) {
        if let Some(span) = excluded(entry, method.number.into()) {
            sink.push(outside(method).related(span, "its values"));
        }
    }
    let Some(allow) = super::unsettled(entry.allow.as_ref()) else { return };
    for value in allow.value.iter().filter(|value| **value != 0 && !super::has_method(model, **value)) {
        let text = format!("`{}` allows {value}, and the table `homing` has no such method", entry.address);
        sink.push(super::finding(CODE, allow.span(), &entry.address, text, WHY, HELP));
    }
}

fn outside(method: &HomingMethod) -> Diagnostic {
    let text = format!("`homing {}` is a method that 6098:00 does not take", method.number);
    super::finding(CODE, method.status.span(), &format!("homing {}", method.number), text, WHY, HELP)
}

/// The fact that excludes a value, where no erratum settles it.
fn excluded(entry: &Entry, value: i128) -> Option<Span> {
    let min = super::unsettled(entry.min.as_ref()).filter(|min| value < min.value);
    let max = super::unsettled(entry.max.as_ref()).filter(|max| value > max.value);
    let allow = super::unsettled(entry.allow.as_ref()).filter(|allow| !allow.value.contains(&value));
    min.or(max).map(Fact::span).or(allow.map(Fact::span))
}
