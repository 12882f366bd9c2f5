//! E1101: a homing program does not end at home.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Model, Step};

const CODE: Code = Code::error("E1101", "a homing program does not end at home");
const WHY: &str = "without one place that is taken as home, every position afterwards is unknown";
const HELP: &str = "end it with `latch`, or `latch; return`; write `done` alone where the axis is at home already, and `not stated` where the manual stops";

/// Looks at the end of each program: one `latch` and perhaps `return` behind it, `done` alone, or `not stated`.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("ends_at_home.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (method, case) in super::cases(model).filter(|(_, case)| !ends_at_home(&case.moves.value.0)) {
        let text = format!("`{}` does not end at home: {}", super::case_row(method, case), case.moves.value);
        sink.push(super::finding(CODE, case.moves.span(), &super::case_row(method, case), text, WHY, HELP));
    }
}

fn ends_at_home(steps: &[Step]) -> bool {
    match steps {
        [Step::Done] => true,
        [before @ .., Step::Latch, Step::Return | Step::NotStated]
        | [before @ .., Step::Latch | Step::NotStated] => searches(before),
        _ => false,
    }
}

/// Whether home is still to be taken after these steps.
fn searches(steps: &[Step]) -> bool {
    steps.iter().all(|step| matches!(step, Step::Move { .. } | Step::Stop))
}
