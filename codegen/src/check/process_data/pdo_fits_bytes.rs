//! E0604: a PDO has more bytes than the drive can map.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E0604", "a PDO has more bytes than the drive can map");
const WHY: &str = "the drive would not reach SAFEOP, or would refuse the mapping with abort 0604 0042";
const HELP: &str = "correct the limit, or the mapping";

/// Compares the length of each default PDO with `pdo_bytes` of the drive.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("pdo_fits_bytes.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let Some(limit) = &model.drive.limits.pdo_bytes else { return };
    for pdo in &model.pdos {
        let bytes = pdo.bits().div_ceil(8);
        let Some(last) = pdo.entries.last().filter(|_| bytes > u32::from(limit.value)) else { continue };
        let row = super::mapped_row(pdo, last);
        let text =
            format!("with `{row}` PDO {:04X} has {bytes} bytes, more than the drive can map", pdo.index);
        let most = format!("at most {} bytes", limit.value);
        sink.push(super::finding(CODE, last.origin.span, &row, text, WHY, HELP).related(limit.span(), most));
    }
}
