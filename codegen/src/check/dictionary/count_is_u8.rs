//! E0501: sub-index 0 of an array or record is not UNSIGNED8.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Model, ObjectKind, Type};

const CODE: Code = Code::error("E0501", "sub-index 0 of an array or record is not UNSIGNED8");
const WHY: &str = "CiA 301 fixes it: sub-index 0 counts, and readers read one byte";
const HELP: &str = "correct the type; if the manual prints another one, add an erratum";

/// Looks at the type of sub-index 0 of every array and record.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("count_is_u8.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, object) in model.objects.iter().filter(|(_, o)| o.kind.value != ObjectKind::Var) {
        let entry = &model.entries[object.entries[0]];
        if entry.address.sub == 0 && entry.ty.value != Type::int(false, 8) {
            let text = format!("`{}` counts its sub-indexes with type {}", entry.address, entry.ty.value);
            sink.push(super::finding(CODE, entry.ty.span(), &entry.address, text, WHY, HELP));
        }
    }
}
