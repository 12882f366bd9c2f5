//! E1504: a start-up command would be refused.

use crate::check::Lint;
use crate::check::examples::writes_accepted::{read_only, refused};
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E1504", "a start-up command would be refused");
const WHY: &str = "the master writes it in every start-up, and the drive would not leave the state before it";
const HELP: &str = "correct the entry or the value; a value of 16 bits is written to an entry of 16 bits";

/// Looks at what start-up commands write: the entry can be written, and the value is one of its type and range.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("startup_accepted.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for startup in &model.startup {
        let Some((_, entry)) = model.entry(startup.write.value) else { continue };
        let refusal = read_only(entry).or_else(|| refused(entry, startup.value.value));
        let Some((fact, why)) = refusal else { continue };
        let row = format!("startup {}", startup.number);
        let text = format!("`{row}` writes to {}, {why}", entry.address);
        let finding = super::finding(CODE, startup.value.span(), &row, text, WHY, HELP);
        sink.push(finding.related(fact, "the object"));
    }
}
