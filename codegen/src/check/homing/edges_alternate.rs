//! E1102: a homing program waits for an edge that cannot come.

use std::collections::BTreeMap;

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Event, Model, Moves, Signal, Step};

const CODE: Code = Code::error("E1102", "a homing program waits for an edge that cannot come");
const WHY: &str =
    "between two edges of one kind there is one of the other kind, so that the axis would run into its stop";
const HELP: &str = "look for a step that is printed twice or left out; if the manual prints it so, add an erratum that sets the program";

/// Looks for two moves in one direction, without a turn or another step between, that wait for the same state of a switch.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("edges_alternate.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (method, case) in super::cases(model) {
        let Some(step) = endless(&case.moves.value) else { continue };
        let row = super::case_row(method, case);
        let text = format!("`{row}` has `{step}` a second time before the switch could change back");
        sink.push(super::finding(CODE, case.moves.span(), &row, text, WHY, HELP));
    }
}

/// The first move that cannot end.
fn endless(moves: &Moves) -> Option<Step> {
    let mut heading = None;
    let mut seen: BTreeMap<Signal, bool> = BTreeMap::new();
    for step in &moves.0 {
        let Step::Move { direction, until, .. } = step else {
            heading = None;
            continue;
        };
        if heading.replace(direction) != Some(direction) {
            seen.clear();
        }
        if let Event::Switch(signal, on) = until
            && seen.insert(*signal, *on) == Some(*on)
        {
            return Some(*step);
        }
    }
    None
}
