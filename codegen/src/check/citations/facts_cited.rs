//! E0901: a stated fact cites nothing.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Class, Model};

const CODE: Code = Code::error("E0901", "a stated fact cites nothing");
const WHY: &str =
    "a value that nobody can find in the manual again cannot be checked, and cannot be told from a slip";
const HELP: &str = "add `src = \"section Ttable Lline\"`; if the manual does not say it, remove the value, or name the rule in `inferred`";

/// Looks for a citation of every stated value.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("facts_cited.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for row in model.row_origins() {
        let uncited = row.origins.iter().find(|o| o.class == Class::Stated && o.cite.is_none());
        if let Some(origin) = uncited {
            sink.push(super::finding(
                CODE,
                origin.span,
                &row.row,
                format!("`{}` cites nothing", row.row),
                WHY,
                HELP,
            ));
        }
    }
}
