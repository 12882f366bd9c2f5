//! E0403: a limit does not fit its type.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E0403", "a limit does not fit its type");
const WHY: &str = "an unsigned object with a negative minimum is a contradiction of the manual with itself";
const HELP: &str =
    "state what is printed and add an erratum that sets the limit (or the type) that holds, with both lines";

/// Compares `min` and `max` with what the type can hold.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("limits_fit_type.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, entry) in model.entries.iter() {
        for (word, limit) in [("min", &entry.min), ("max", &entry.max)] {
            let Some(limit) = limit else { continue };
            if super::fits(entry.ty.value, limit.value) == Some(false) {
                let text =
                    format!("{word} {} of `{}` does not fit {}", limit.value, entry.address, entry.ty.value);
                sink.push(
                    super::finding(CODE, limit.span(), &entry.address, text, WHY, HELP)
                        .related(entry.ty.span(), "the type"),
                );
            }
        }
    }
}
