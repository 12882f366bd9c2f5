//! E0402: a default does not fit its type.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E0402", "a default does not fit its type");
const WHY: &str = "a value that needs more bits than the type has would be cut on the wire";
const HELP: &str = "write negative values as negative numbers, and check the width";

/// Compares `default` with what the type can hold.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("default_fits_type.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, entry) in model.entries.iter() {
        let Some(default) = entry.default_int() else { continue };
        if super::fits(entry.ty.value, default.value) == Some(false) {
            let text =
                format!("default {} of `{}` does not fit {}", default.value, entry.address, entry.ty.value);
            sink.push(
                super::finding(CODE, default.span, &entry.address, text, WHY, HELP)
                    .related(entry.ty.span(), "the type"),
            );
        }
    }
}
