//! W0903: a name starts with a digit.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::warning("W0903", "a name starts with a digit");
const WHY: &str = "no language takes such a name, so a backend has to put something in front of it, and users cannot guess what";
const HELP: &str = "give the row a `rename` that starts with a letter";

/// Looks at the first character of the names that generated code uses.
pub(in crate::check) const LINT: Lint =
    Lint { code: CODE, page: include_str!("name_starts_with_letter.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, entry) in model.entries.iter() {
        if entry.handle.words().first().is_some_and(|w| w.starts_with(|c: char| c.is_ascii_digit())) {
            let text = format!("the name of `{}` is `{}`", entry.address, entry.handle);
            sink.push(super::finding(CODE, entry.name.span(), &entry.address, text, WHY, HELP));
        }
    }
}
