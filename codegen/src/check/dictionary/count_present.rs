//! E0503: an array or record lacks sub-index 0.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E0503", "an array or record lacks sub-index 0");
const WHY: &str = "every reader starts there, and an EDS without it is refused";
const HELP: &str = "add the row; if the manual does not print it, state it with `inferred` and name the rule";

/// Looks for sub-index 0 of every array and record.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("count_present.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, object) in model.objects.iter() {
        let first = &model.entries[object.entries[0]];
        if first.address.sub != 0 {
            let text = format!("`{:04X}` starts with sub-index {:02X}", object.index, first.address.sub);
            sink.push(super::finding(
                CODE,
                first.name.span(),
                &format!("{:04X}", object.index),
                text,
                WHY,
                HELP,
            ));
        }
    }
}
