//! E0902: a citation names a line that the manual does not have.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Model, Place};

const CODE: Code = Code::error("E0902", "a citation names a line that the manual does not have");
const WHY: &str = "a citation that leads nowhere proves nothing";
const HELP: &str = "correct the line, or name the manual: `m2 6.2 L12`";
const NO_MANUAL: &str = "state the manual first: the profile has no row in `manuals`";

/// Compares each cited line with the number of lines of the text extract.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("lines_in_manual.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let help = if model.manuals.is_empty() { NO_MANUAL } else { HELP };
    for row in model.row_origins() {
        for origin in row.origins {
            let Some(place) = origin.cite.iter().flat_map(|c| &c.places).find(|p| !holds(model, p)) else {
                continue;
            };
            let text = format!("`{}` cites {place}, which is no line of a manual", row.row);
            sink.push(super::finding(CODE, origin.span, &row.row, text, WHY, help));
            break;
        }
    }
}

fn holds(model: &Model, place: &Place) -> bool {
    let manual = match (&place.manual, model.manuals.as_slice()) {
        (None, [only]) => only,
        (None, _) => return false,
        (Some(id), manuals) => match manuals.iter().find(|m| m.id == *id) {
            Some(manual) => manual,
            // Resolving has reported that there is no such manual.
            None => return true,
        },
    };
    place.lines.iter().all(|line| *line <= manual.lines)
}
