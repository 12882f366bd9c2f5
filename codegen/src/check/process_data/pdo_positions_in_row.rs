//! E0607: the positions of a PDO have a gap.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E0607", "the positions of a PDO have a gap");
const WHY: &str = "a row is missing, and every offset behind it is wrong";
const HELP: &str = "add the missing row, or correct `pos`";

/// Looks at `pos` of each entry of a PDO: 1, 2, 3 and on.
pub(in crate::check) const LINT: Lint =
    Lint { code: CODE, page: include_str!("pdo_positions_in_row.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for pdo in &model.pdos {
        for (expected, mapped) in (1u32..).zip(&pdo.entries) {
            if u32::from(mapped.position) != expected {
                let text = format!(
                    "`{}` stands where position {expected} is expected",
                    super::mapped_row(pdo, mapped)
                );
                sink.push(super::finding(
                    CODE,
                    mapped.origin.span,
                    &super::mapped_row(pdo, mapped),
                    text,
                    WHY,
                    HELP,
                ));
                break;
            }
        }
    }
}
