//! W0802: an allowed value has no name.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::warning("W0802", "an allowed value has no name");
const WHY: &str = "the documentation would print a bare number, and generated code could not name it";
const HELP: &str = "add the value to the table; the manual says what it does, or the standard";

/// Looks for each value of `allow` in the table that `values` names.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("allowed_named.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, entry) in model.entries.iter() {
        let (Some(allow), Some(values)) = (&entry.allow, &entry.values) else { continue };
        let table = &model.enums[values.value];
        for value in allow.value.iter().filter(|v| table.values.iter().all(|named| named.value != **v)) {
            let text = format!("`{}` allows {value}, which `{}` does not name", entry.address, table.name);
            sink.push(super::finding(CODE, allow.span(), &entry.address, text, WHY, HELP));
        }
    }
}
