//! W1701: the numbers of the sync managers have a gap.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::warning("W1701", "the numbers of the sync managers have a gap");
const WHY: &str = "1C00h lists them in order from 0, so that a missing one shifts those behind it";
const HELP: &str = "add the missing row, or correct `number`";

/// Looks at the numbers of the sync managers: 0, 1, 2 and on.
pub(in crate::check) const LINT: Lint =
    Lint { code: CODE, page: include_str!("sync_managers_whole.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let mut numbered = (0u8..).zip(&model.sync_managers);
    let Some((expected, first)) = numbered.find(|(n, sync_manager)| *n != sync_manager.number) else {
        return;
    };
    let text = format!("`sync manager {}` stands where {expected} is expected", first.number);
    sink.push(super::finding(
        CODE,
        first.carries.span(),
        &format!("sync manager {}", first.number),
        text,
        WHY,
        HELP,
    ));
}
