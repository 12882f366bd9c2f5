//! E0406: an allowed value is outside the range or the type.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::Model;

const CODE: Code = Code::error("E0406", "an allowed value is outside the range or the type");
const WHY: &str = "a value cannot be allowed and out of range at once";
const HELP: &str = "correct the list or the limits";

/// Compares each value of `allow` with `min`, `max` and the type.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("allowed_in_range.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (_, entry) in model.entries.iter() {
        let Some(allow) = &entry.allow else { continue };
        for value in &allow.value {
            let low = entry.min.as_ref().is_some_and(|min| *value < min.value);
            let high = entry.max.as_ref().is_some_and(|max| *value > max.value);
            if low || high || super::fits(entry.ty.value, *value) == Some(false) {
                let text =
                    format!("allowed value {value} of `{}` is outside its range or type", entry.address);
                sink.push(super::finding(CODE, allow.span(), &entry.address, text, WHY, HELP));
            }
        }
    }
}
