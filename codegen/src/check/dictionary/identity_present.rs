//! W0504: a standard drive lacks 1000h or 1018h.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Address, Model};

const CODE: Code = Code::warning("W0504", "a standard drive lacks 1000h or 1018h");
const WHY: &str = "CiA 301 makes both mandatory";
const HELP: &str =
    "add the rows from the manual; if it does not print them, accept the finding with `allow` and the reason";

/// Looks for 1000h and 1018h:01 in drives that name the base `cia301`.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("identity_present.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    if !super::based_on(model, "cia301") {
        return;
    }
    for address in [Address::new(0x1000, 0), Address::new(0x1018, 1)] {
        let span = model.objects.as_slice().first().map(|o| o.name.span());
        if let (None, Some(span)) = (model.entry(address), span) {
            let text = format!("the drive has no `{address}`");
            sink.push(super::finding(CODE, span, &address, text, WHY, HELP));
        }
    }
}
