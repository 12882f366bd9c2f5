//! E1104: a homing program waits for what ends it with an error.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Event, Level, Model, Moves, When};

const CODE: Code = Code::error("E1104", "a homing program waits for what ends it with an error");
const WHY: &str = "such a method can never come to its end";
const HELP: &str =
    "compare the direction of the move with the switch: one of the two limits is likely the other one";

/// Compares `abort` with the events that the moves of the same case wait for.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("abort_not_awaited.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (method, case) in super::cases(model) {
        let Some(abort) = case.abort.as_ref().filter(|a| awaited(&a.value, &case.moves.value)) else {
            continue;
        };
        let row = super::case_row(method, case);
        let text = format!("`{row}` waits for `{}`, which ends it with an error", abort.value);
        sink.push(
            super::finding(CODE, case.moves.span(), &row, text, WHY, HELP).related(abort.span(), "the abort"),
        );
    }
}

/// Whether the program waits for every level of `abort`.
fn awaited(abort: &When, moves: &Moves) -> bool {
    let waits = |level: &Level| match level {
        Level::Switch(signal, on) => moves.moves().any(|(_, _, until)| until == Event::Switch(*signal, *on)),
        Level::Standstill | Level::AtHome => false,
    };
    !abort.0.is_empty() && abort.0.iter().all(waits)
}
