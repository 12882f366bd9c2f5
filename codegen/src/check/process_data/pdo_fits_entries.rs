//! E0603: a PDO has more entries than the drive can map.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E0603", "a PDO has more entries than the drive can map");
const WHY: &str = "the drive would not reach SAFEOP, or would refuse the mapping with abort 0604 0042";
const HELP: &str = "correct the limit, or the mapping";

/// Compares each default PDO with `pdo_entries` of the drive.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("pdo_fits_entries.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let Some(limit) = &model.drive.limits.pdo_entries else { return };
    for pdo in model.pdos.iter().filter(|p| p.entries.len() > usize::from(limit.value)) {
        let Some(last) = pdo.entries.last() else { continue };
        let text = format!(
            "`{}` is entry {} of PDO {:04X}, more than the drive can map",
            super::mapped_row(pdo, last),
            pdo.entries.len(),
            pdo.index
        );
        let most = format!("at most {} entries", limit.value);
        sink.push(
            super::finding(CODE, last.origin.span, &super::mapped_row(pdo, last), text, WHY, HELP)
                .related(limit.span(), most),
        );
    }
}
