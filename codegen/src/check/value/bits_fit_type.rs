//! E0408: a named bit is outside the type that uses it.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E0408", "a named bit is outside the type that uses it");
const WHY: &str = "there is no such bit";
const HELP: &str = "count the bits again, or correct the type";

/// Compares each bit of the table that `bits` names with the width of the entry.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("bits_fit_type.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, entry) in model.entries.iter() {
        let (Some(bits), Some(width)) = (&entry.bits, entry.ty.value.bits()) else { continue };
        for field in model.bits[bits.value].fields.iter().filter(|f| f.end() > u16::from(width)) {
            let text = format!(
                "bit {} ({}) is not in the {width} bits of `{}`",
                field.end() - 1,
                field.name.value,
                entry.address
            );
            sink.push(
                super::finding(CODE, bits.span(), &entry.address, text, WHY, HELP)
                    .related(field.name.span(), "the bit"),
            );
        }
    }
}
