//! E0401: a default is outside its own range.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E0401", "a default is outside its own range");
const WHY: &str = "a drive cannot be shipped with a value that it refuses";
const HELP: &str = "look at every place where the manual prints the object; write raw counts everywhere, and add an erratum for the value that is wrong";

/// Compares `default` with `min` and `max` of the same entry.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("default_in_range.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, entry) in model.entries.iter() {
        let Some(default) = entry.default_int() else { continue };
        let below = entry.min.as_ref().filter(|min| default.value < min.value);
        let above = entry.max.as_ref().filter(|max| default.value > max.value);
        if let Some(limit) = below.or(above) {
            let text = format!("default {} of `{}` is outside its range", default.value, entry.address);
            sink.push(
                super::finding(CODE, default.span, &entry.address, text, WHY, HELP)
                    .related(limit.span(), format!("the limit is {}", limit.value)),
            );
        }
    }
}
