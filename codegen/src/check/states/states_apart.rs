//! E1401: a statusword belongs to two states, or to none.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Model, State};

const CODE: Code = Code::error("E1401", "a statusword belongs to two states, or to none");
const WHY: &str =
    "a client would take the drive to be enabled while it is not, or would wait for a state that never shows";
const HELP: &str = "compare mask and value bit by bit with the manual; if it prints them so, add an erratum";

/// Compares mask and value of each state, and the states with each other.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("states_apart.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let states: Vec<&State> =
        model.states.iter().filter(|s| !super::settled(&s.mask) && !super::settled(&s.value)).collect();
    for (n, state) in states.iter().enumerate() {
        let (mask, value) = (state.mask.value, state.value.value);
        let text = if value & !mask != 0 {
            format!(
                "`state {}` wants {value:04X}h, which is not inside its mask {mask:04X}h",
                state.name.value
            )
        } else if let Some(other) = states[..n].iter().find(|other| meet(other, state)) {
            format!("`state {}` and {} are told by the same bits", state.name.value, other.name.value)
        } else {
            continue;
        };
        sink.push(super::finding(
            CODE,
            state.value.span(),
            &format!("state {}", state.name.value),
            text,
            WHY,
            HELP,
        ));
    }
}

/// Whether some statusword is that of both.
fn meet(a: &State, b: &State) -> bool {
    (a.value.value ^ b.value.value) & a.mask.value & b.mask.value == 0
}
