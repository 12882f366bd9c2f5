//! E0505: an object is not of the kind that it states.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Model, ObjectKind, Type};

const CODE: Code = Code::error("E0505", "an object is not of the kind that it states");
const WHY: &str = "readers size a buffer by it";
const HELP: &str = "correct `kind`, or the types";

/// Compares `kind` with the entries: a variable has sub-index 0 alone, an array one type from sub-index 1 on.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("kind_fits_entries.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, object) in model.objects.iter() {
        let members: Vec<Type> = object
            .entries
            .iter()
            .map(|id| &model.entries[*id])
            .filter(|e| e.address.sub > 0)
            .map(|e| e.ty.value)
            .collect();
        let fits = match object.kind.value {
            ObjectKind::Var => members.is_empty(),
            ObjectKind::Array => members.windows(2).all(|w| w[0] == w[1]),
            ObjectKind::Record => true,
        };
        if !fits {
            let text = format!(
                "the entries of `{:04X}` are not those of `kind = \"{}\"`",
                object.index,
                object.kind.value.word()
            );
            sink.push(super::finding(
                CODE,
                object.kind.span(),
                &format!("{:04X}", object.index),
                text,
                WHY,
                HELP,
            ));
        }
    }
}
