//! E0502: sub-index 0 does not default to the highest sub-index.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Model, ObjectKind};

const CODE: Code = Code::error("E0502", "sub-index 0 does not default to the highest sub-index");
const WHY: &str = "masters read sub-index 0 to know how far to read";
const HELP: &str = "look for rows that the manual prints and the profile lacks; else add an erratum";

/// Compares the default of sub-index 0 with the highest sub-index that the profile has.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("count_is_highest.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, object) in
        model.objects.iter().filter(|(_, o)| o.kind.value != ObjectKind::Var && !counts_use(o.index))
    {
        let count = &model.entries[object.entries[0]];
        // FFh describes the object and does not count.
        let subs = object.entries.iter().map(|id| model.entries[*id].address.sub);
        let highest = subs.filter(|sub| *sub != 0xFF).max().unwrap_or(0);
        let Some(default) = count.default_int().filter(|_| count.address.sub == 0) else { continue };
        if default.value != i128::from(highest) {
            let text = format!(
                "`{}` defaults to {} and the highest sub-index is {highest}",
                count.address, default.value
            );
            sink.push(super::finding(CODE, default.span, &count.address, text, WHY, HELP));
        }
    }
}

/// Sub-index 0 of these counts the entries in use.
fn counts_use(index: u16) -> bool {
    matches!(index, 0x1003 | 0x1600..=0x17FF | 0x1A00..=0x1BFF | 0x1C10..=0x1C2F)
}
