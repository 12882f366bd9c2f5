//! E1103: the cases of a homing method end at different homes.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Event, Model, Moves, Step};

const CODE: Code = Code::error("E1103", "the cases of a homing method end at different homes");
const WHY: &str = "the zero of the machine would depend on where the axis stood at the start";
const HELP: &str = "compare the cases with the figure of the method; an edge has another place when it is passed in the other direction";

/// Compares what the cases of a method latch: the event, the direction, and for an index pulse the edge before it.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("one_home.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (method, cases) in model.homing.iter().map(|m| (m, m.cases.as_slice())) {
        for (n, case) in cases.iter().enumerate() {
            let other = cases[..n].iter().find(|other| !same_home(&other.moves.value, &case.moves.value));
            let Some(other) = other else { continue };
            let text = format!(
                "`{}` takes home at another place than another start of the method: {}",
                super::case_row(method, case),
                case.moves.value
            );
            sink.push(
                super::finding(CODE, case.moves.span(), &super::case_row(method, case), text, WHY, HELP)
                    .related(other.moves.span(), "the other program"),
            );
        }
    }
}

/// Whether two programs latch the same, as far as both say it.
fn same_home(a: &Moves, b: &Moves) -> bool {
    agree(a.latched(), b.latched()) && agree(edge_before_index(a), edge_before_index(b))
}

fn agree<T: Copy + PartialEq>(a: Option<T>, b: Option<T>) -> bool {
    a.is_none() || b.is_none() || a == b
}

/// The event after which the latched index pulse is the first, where the axis passes both in one direction.
fn edge_before_index(moves: &Moves) -> Option<Event> {
    let ends: Vec<&Step> = moves.0.iter().take_while(|step| **step != Step::Latch).collect();
    match ends.as_slice() {
        [
            ..,
            Step::Move { direction: before, until, .. },
            Step::Move { direction, until: Event::Index, .. },
        ] if before == direction => Some(*until),
        _ => None,
    }
}
