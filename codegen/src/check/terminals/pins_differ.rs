//! E1601: two terminals are on one pin.

use std::collections::BTreeMap;

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Model, Terminal};

const CODE: Code = Code::error("E1601", "two terminals are on one pin");
const WHY: &str = "whoever wires by the table would join two signals, or an input and a supply";
const HELP: &str = "compare the numbers with the figure of the connector; accept the finding with `allow` where the pins are those of two connectors";

/// Compares the pins of the terminals with each other.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("pins_differ.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let mut seen: BTreeMap<u8, &Terminal> = BTreeMap::new();
    for terminal in &model.terminals {
        let Some(pin) = super::unsettled(terminal.pin.as_ref()) else { continue };
        let Some(first) = seen.insert(pin.value, terminal) else { continue };
        let text = format!("`terminal {}` is on pin {}, as {} is", terminal.name, pin.value, first.name);
        let other = first.kind.span();
        sink.push(
            super::finding(CODE, pin.span(), &format!("terminal {}", terminal.name), text, WHY, HELP)
                .related(other, "the other one"),
        );
    }
}
