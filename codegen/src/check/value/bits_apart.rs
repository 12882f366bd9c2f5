//! E0409: two named bits overlap.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{BitField, Model};

const CODE: Code = Code::error("E0409", "two named bits overlap");
const WHY: &str = "one bit would have two names at the same time";
const HELP: &str = "correct `bit` or `width`, or say in which `mode` each has its meaning";

/// Compares the bits of a table with each other; bits of different modes of operation may share a place, but not with bits of every mode.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("bits_apart.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, table) in model.bits.iter() {
        for (at, field) in table.fields.iter().enumerate() {
            for earlier in table.fields[..at].iter().filter(|e| overlap(e, field)) {
                let text = format!(
                    "`bits {}.{}` overlaps bit {} ({})",
                    table.name, field.bit, earlier.bit, earlier.name.value
                );
                sink.push(
                    super::finding(
                        CODE,
                        field.name.span(),
                        &format!("bits {}.{}", table.name, field.bit),
                        text,
                        WHY,
                        HELP,
                    )
                    .related(earlier.name.span(), "the other one"),
                );
            }
        }
    }
}

fn overlap(a: &BitField, b: &BitField) -> bool {
    let together = a.mode.is_none() || b.mode.is_none() || a.mode == b.mode;
    together && u16::from(a.bit) < b.end() && u16::from(b.bit) < a.end()
}
