//! W0701: 6502h and the values of 6060h name different modes.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Address, Model, Value};

const CODE: Code = Code::warning("W0701", "6502h and the values of 6060h name different modes");
const WHY: &str = "a client that asks 6502h would refuse a mode that the drive has, or try one that it lacks";
const HELP: &str = "decide from the chapters on modes which is right, and add an erratum with both lines";

/// Compares the bits of 6502h with the values that 6060h allows: mode n (1 to 10) is bit n - 1.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("modes_agree.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let supported = model.entry(Address::new(0x6502, 0)).map(|(_, e)| e);
    let requested = model.entry(Address::new(0x6060, 0)).map(|(_, e)| e);
    let (Some(supported), Some(requested)) = (supported, requested) else { return };
    let (Some(default), Some(allow)) = (&supported.default, &requested.allow) else { return };
    let Value::Int(word) = default.value else { return };
    let settled = super::settled(default) || super::settled(allow);
    let named = |mode: i128| allow.value.contains(&mode);
    let differing: Vec<String> = (1..=10)
        .filter(|mode| (word >> (mode - 1) & 1 == 1) != named(*mode))
        .map(|mode| mode.to_string())
        .collect();
    if !differing.is_empty() && !settled {
        let text = format!("`{}` and 6060:00 disagree on mode {}", supported.address, differing.join(", "));
        sink.push(
            super::finding(CODE, default.span(), &supported.address, text, WHY, HELP)
                .related(allow.span(), "the values of 6060h"),
        );
    }
}
