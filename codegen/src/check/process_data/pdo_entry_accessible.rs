//! E0605: a PDO writes what is read only, or sends what cannot be read.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E0605", "a PDO writes what is read only, or sends what cannot be read");
const WHY: &str = "process data obeys the same access as SDO: a status word cannot be commanded";
const HELP: &str =
    "correct the access or the mapping; a status in an RxPDO usually means that two rows were swapped";

/// Compares the direction of a PDO with `access` of each entry that it carries.
pub(in crate::check) const LINT: Lint =
    Lint { code: CODE, page: include_str!("pdo_entry_accessible.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (pdo, mapped, entry) in super::mapped(model) {
        let access = entry.access.value;
        if !access.carries(pdo.direction) {
            let text = format!(
                "`{}` carries {}, whose access is {}",
                super::mapped_row(pdo, mapped),
                entry.address,
                access.word()
            );
            sink.push(
                super::finding(CODE, mapped.origin.span, &super::mapped_row(pdo, mapped), text, WHY, HELP)
                    .related(entry.access.span(), "its access"),
            );
        }
    }
}
