//! E1106: two cases of a homing method cannot be told apart.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{HomingCase, Level, Model, Moves, Step, When};

const CODE: Code = Code::error("E1106", "two cases of a homing method cannot be told apart");
const WHY: &str = "at such a start nobody could say which of the two programs holds";
const HELP: &str = "add the switch that tells the starts apart to `when`, or correct the move at which the programs part: same direction and speed, another event";

/// Compares the starts of the cases of a method, and where two can hold together, their programs.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("cases_apart.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (method, cases) in model.homing.iter().map(|m| (m, m.cases.as_slice())) {
        for (n, case) in cases.iter().enumerate() {
            let Some(other) = cases[..n].iter().find(|other| !apart(other, case)) else { continue };
            let text = format!(
                "`{}` holds at `{}`, and so can another case of the method, at `{}`",
                super::case_row(method, case),
                case.when.value,
                other.when.value
            );
            sink.push(
                super::finding(CODE, case.when.span(), &super::case_row(method, case), text, WHY, HELP)
                    .related(other.when.span(), "the other start"),
            );
        }
    }
}

fn apart(a: &HomingCase, b: &HomingCase) -> bool {
    starts_differ(&a.when.value, &b.when.value) || events_differ(&a.moves.value, &b.moves.value)
}

/// Whether two starts exclude each other. One at home is the exception from those that name switches.
fn starts_differ(a: &When, b: &When) -> bool {
    let opposite = |level: &Level| match level {
        Level::Switch(signal, on) => b.0.contains(&Level::Switch(*signal, !on)),
        Level::Standstill | Level::AtHome => false,
    };
    let home = |when: &When| when.0.contains(&Level::AtHome);
    let exception = home(a) != home(b) && !a.0.is_empty() && !b.0.is_empty();
    exception || a.0.iter().any(opposite)
}

/// Whether the first step in which two programs differ is one move that two events can end.
fn events_differ(a: &Moves, b: &Moves) -> bool {
    let steps = a.0.iter().zip(&b.0).find(|(a, b)| a != b);
    let Some((Step::Move { direction, pace, .. }, Step::Move { direction: other, pace: other_pace, .. })) =
        steps
    else {
        return false;
    };
    direction == other && pace == other_pace
}
