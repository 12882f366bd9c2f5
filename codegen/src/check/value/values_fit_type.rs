//! E0407: a named value does not fit the type that uses it.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E0407", "a named value does not fit the type that uses it");
const WHY: &str = "the name could never be sent or received";
const HELP: &str = "write negative values as negative numbers, or name another table";

/// Compares each value of the table that `values` names with the type of the entry.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("values_fit_type.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, entry) in model.entries.iter() {
        let Some(values) = &entry.values else { continue };
        let table = &model.enums[values.value];
        for named in table.values.iter().filter(|v| super::fits(entry.ty.value, v.value) == Some(false)) {
            let text = format!(
                "{} ({}) does not fit {} of `{}`",
                named.name.value, named.value, entry.ty.value, entry.address
            );
            sink.push(
                super::finding(CODE, values.span(), &entry.address, text, WHY, HELP)
                    .related(named.name.span(), "the value"),
            );
        }
    }
}
