//! E0602: a mapped length is not the width of the entry.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E0602", "a mapped length is not the width of the entry");
const WHY: &str = "everything after it would be read from the wrong byte";
const HELP: &str = "correct the length or the type; the last two digits of a mapping word are the length in bits, hexadecimal";

/// Compares `bits` of a mapping with the type of the entry.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("pdo_bits_fit.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (pdo, mapped, entry) in super::mapped(model) {
        let width = entry.ty.value.bits();
        if width != Some(mapped.bits.value) {
            let width = width.map_or_else(|| "no fixed width".to_owned(), |w| format!("{w} bits"));
            let text = format!(
                "`{}` maps {} bits of {}, which has {width}",
                super::mapped_row(pdo, mapped),
                mapped.bits.value,
                entry.address
            );
            sink.push(
                super::finding(CODE, mapped.bits.span(), &super::mapped_row(pdo, mapped), text, WHY, HELP)
                    .related(entry.ty.span(), "its type"),
            );
        }
    }
}
