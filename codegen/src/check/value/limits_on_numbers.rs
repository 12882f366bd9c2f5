//! E0410: a text or byte string has limits, a unit, values or bits.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Fact, Model, Type};

const CODE: Code = Code::error("E0410", "a text or byte string has limits, a unit, values or bits");
const WHY: &str =
    "only numbers have them; on a string they are a sign that the columns of the table moved by one";
const HELP: &str = "compare the row with its neighbours in the manual";

/// Looks for `min`, `max`, `allow`, `unit`, `values` and `bits` on entries that are no numbers.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("limits_on_numbers.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, entry) in model.entries.iter() {
        let ty = entry.ty.value;
        let facts = [
            ("min", entry.min.as_ref().map(Fact::span)),
            ("max", entry.max.as_ref().map(Fact::span)),
            ("allow", entry.allow.as_ref().map(Fact::span)),
            ("unit", entry.unit.as_ref().map(Fact::span)),
            ("values", entry.values.as_ref().map(Fact::span)),
            ("bits", entry.bits.as_ref().map(Fact::span)),
        ];
        let number = ty.is_integer() || matches!(ty, Type::Bool) || matches!(ty, Type::Real { .. });
        for (key, span) in facts.into_iter().filter(|_| !number) {
            let Some(span) = span else { continue };
            let text = format!("`{}` is of type {ty} and has `{key}`", entry.address);
            sink.push(
                super::finding(CODE, span, &entry.address, text, WHY, HELP)
                    .related(entry.ty.span(), "the type"),
            );
        }
    }
}
