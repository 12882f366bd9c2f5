//! E0404: a minimum is above the maximum.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E0404", "a minimum is above the maximum");
const WHY: &str = "no value lies between them: the two were swapped, or one lost a digit or its sign";
const HELP: &str = "compare with every printing of the object; add an erratum for the wrong one";

/// Compares `min` with `max`.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("limits_in_order.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, entry) in model.entries.iter() {
        if let (Some(min), Some(max)) = (&entry.min, &entry.max)
            && min.value > max.value
        {
            let text = format!("min {} of `{}` is above max {}", min.value, entry.address, max.value);
            sink.push(
                super::finding(CODE, min.span(), &entry.address, text, WHY, HELP)
                    .related(max.span(), "the maximum"),
            );
        }
    }
}
