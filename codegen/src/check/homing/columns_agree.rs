//! E1105: a homing program does not do what the columns of its table say.

use std::collections::BTreeSet;

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{
    Edge, Event, Fact, HomingCase, HomingMethod, HomingSignal, HomingStart, Level, Model, Moves, Side,
    Signal, Step, Worded,
};
use crate::source::Span;

const CODE: Code = Code::error("E1105", "a homing program does not do what the columns of its table say");
const WHY: &str =
    "table and program are two readings of one method, and the axis goes where the program says";
const HELP: &str = "draw the method from the columns and compare it with the program; if the manual contradicts itself, add an erratum";

/// Compares `start`, `approach`, `reference`, `side` and `edge` of a method with its programs.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("columns_agree.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for (method, case) in super::cases(model).filter(|(_, case)| !super::settled(&case.moves)) {
        for (column, differs) in differences(method, case) {
            let text = format!("`{}` {differs}", super::case_row(method, case));
            sink.push(
                super::finding(CODE, case.moves.span(), &super::case_row(method, case), text, WHY, HELP)
                    .related(column, "the column"),
            );
        }
    }
}

/// The columns that a case contradicts, each with its place.
fn differences(method: &HomingMethod, case: &HomingCase) -> Vec<(Span, String)> {
    let moves = &case.moves.value;
    let latched = moves.latched();
    let index = latched.is_some_and(|(_, event)| event == Event::Index);
    let home = latched.map(|(_, event)| event);
    // For an index pulse the columns are about the switch before it; without a move before there is only the index.
    let switch = if index { super::before_last(moves).or(home) } else { home };
    let columns = [
        differs("start", method.start.as_ref(), start(method, case)),
        differs("approach", method.approach.as_ref(), switch.filter(|_| index).map(signal)),
        differs("reference", method.reference.as_ref(), reference(moves)),
        differs("side", method.side.as_ref(), latched.map(|(side, _)| side)),
        differs("edge", method.edge.as_ref(), switch.and_then(edge)),
    ];
    columns.into_iter().flatten().collect()
}

/// Compares a column with what the program does, where both are known and no erratum settles the column.
fn differs<T: Worded + PartialEq>(
    name: &str,
    says: Option<&Fact<T>>,
    does: Option<T>,
) -> Option<(Span, String)> {
    let says = super::unsettled(says)?;
    let does = does.filter(|does| *does != says.value)?;
    Some((
        says.span(),
        format!("is of a method with {name} `{}`, and its program has `{}`", says.value.word(), does.word()),
    ))
}

/// How the method starts; said by the first case alone.
fn start(method: &HomingMethod, case: &HomingCase) -> Option<HomingStart> {
    let first = method.cases.first().filter(|first| std::ptr::eq(*first, case))?;
    if method.start.as_ref()?.value == HomingStart::BySwitch && by_switch(method) {
        return Some(HomingStart::BySwitch);
    }
    Some(match first_side(&first.moves.value)? {
        Side::Negative => HomingStart::Negative,
        Side::Positive => HomingStart::Positive,
    })
}

/// Whether a switch decides how the method starts.
fn by_switch(method: &HomingMethod) -> bool {
    let sides: BTreeSet<Side> = method.cases.iter().filter_map(|c| first_side(&c.moves.value)).collect();
    let mut levels = method.cases.iter().flat_map(|case| &case.when.value.0);
    sides.len() > 1 || levels.any(|level| matches!(level, Level::Switch(..)))
}

fn first_side(moves: &Moves) -> Option<Side> {
    moves.moves().next().map(|(side, _, _)| side)
}

/// What the program takes as home.
fn reference(moves: &Moves) -> Option<HomingSignal> {
    if moves.moves().next().is_none() {
        return moves.0.contains(&Step::Latch).then_some(HomingSignal::Here);
    }
    moves.latched().map(|(_, event)| signal(event))
}

fn signal(event: Event) -> HomingSignal {
    match event {
        Event::Switch(Signal::NegativeLimit, _) => HomingSignal::NegativeLimit,
        Event::Switch(Signal::PositiveLimit, _) => HomingSignal::PositiveLimit,
        Event::Switch(Signal::Home, _) => HomingSignal::Home,
        Event::Index => HomingSignal::Index,
        Event::Torque(_) | Event::Stall => HomingSignal::Stall,
    }
}

fn edge(event: Event) -> Option<Edge> {
    match event {
        Event::Switch(_, true) => Some(Edge::Rising),
        Event::Switch(_, false) => Some(Edge::Falling),
        Event::Index | Event::Torque(_) | Event::Stall => None,
    }
}
