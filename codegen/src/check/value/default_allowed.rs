//! E0405: a default is not among the allowed values.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E0405", "a default is not among the allowed values");
const WHY: &str = "the list says which values the drive takes, and the default is one it must take";
const HELP: &str = "correct the list or the default; if the manual prints both so, add an erratum";

/// Looks for `default` in `allow`.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("default_allowed.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, entry) in model.entries.iter() {
        let (Some(default), Some(allow)) = (entry.default_int(), &entry.allow) else { continue };
        if !allow.value.contains(&default.value) {
            let text =
                format!("default {} of `{}` is not among its allowed values", default.value, entry.address);
            sink.push(
                super::finding(CODE, default.span, &entry.address, text, WHY, HELP)
                    .related(allow.span(), "the allowed values"),
            );
        }
    }
}
