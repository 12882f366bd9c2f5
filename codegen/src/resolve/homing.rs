//! Homing methods: rows of one method joined, references to other methods followed.

use std::collections::BTreeMap;

use super::behaviour::line;
use super::origin::Says;
use crate::diag::{Diagnostic, Sink, code};
use crate::merge::Profile;
use crate::model::{Fact, HomingCase, HomingMethod, HomingStatus};
use crate::rows::tables::{ErratumRow, HomingRow};
use crate::source::Sp;

/// Keys that say something of a method as a whole.
const OF_METHOD: &[&str] =
    &["status", "same", "start", "approach", "reference", "side", "edge", "text", "note", "deviation"];

/// The methods, ascending.
pub(super) fn methods(profile: &Profile, sink: &mut Sink) -> Vec<HomingMethod> {
    let mut groups: BTreeMap<i8, Vec<&HomingRow>> = BTreeMap::new();
    let by_case = |r: &HomingRow| (r.method.value, r.case.map(|c| c.value));
    let errata = profile.rows.errata.as_slice();
    // Rows without a number of their own are cases in the order of the lines that they cite.
    let when = |r: &HomingRow| r.when.as_ref().map(|w| w.value.to_string());
    let mut rows: Vec<&HomingRow> = profile.rows.homing.iter().collect();
    rows.sort_by_cached_key(|r| (by_case(r), line(r.src.as_ref()), when(r)));
    for row in rows {
        groups.entry(row.method.value).or_default().push(row);
    }
    let methods: Vec<HomingMethod> = groups.values().map(|rows| method(rows, errata, sink)).collect();
    for method in &methods {
        reference(method, &methods, sink);
    }
    methods
}

/// What decides whether a row of a method is complete.
struct Whole {
    /// Whether a row says that the drive does not have the method.
    absent: bool,
    /// Whether a row refers to another method.
    same: bool,
}

/// The rows that are no repetition. Reports those that are stated twice, in part, or in the wrong place.
fn once<'a>(rows: &[&'a HomingRow], sink: &mut Sink) -> Vec<&'a HomingRow> {
    let whole = Whole {
        absent: rows.iter().any(|r| r.status.is_some_and(|s| s.value != HomingStatus::Supported)),
        same: rows.iter().any(|r| r.same.is_some()),
    };
    // Numbered cases may share a start: the event that comes first tells them apart.
    let key = |r: &HomingRow| match r.case {
        Some(case) => (Some(case.value), None),
        None => (None, r.when.clone().map(|w| w.value)),
    };
    let mut seen: BTreeMap<_, &HomingRow> = BTreeMap::new();
    let mut kept = Vec::new();
    for (n, row) in rows.iter().enumerate() {
        complete(row, &whole, sink);
        can_end(row, sink);
        match (seen.get(&key(row)), n) {
            (Some(twin), _) => crate::merge::duplicate(*row, *twin, sink),
            (None, 0) => {}
            (None, _) => later(row, rows[0], sink),
        }
        seen.entry(key(row)).or_insert_with(|| {
            kept.push(*row);
            row
        });
    }
    kept
}

fn method(rows: &[&HomingRow], errata: &[ErratumRow], sink: &mut Sink) -> HomingMethod {
    let rows = once(rows, sink);
    let first = rows[0];
    let says = says(first, errata);
    let status = first.status.unwrap_or(Sp::new(HomingStatus::Supported, first.meta.span()));
    let text = |t: Option<&Sp<crate::rows::value::Text>>| t.map(|t| t.value.0.clone());
    HomingMethod {
        number: first.method.value,
        status: says.joint(&["status", "method"], status),
        same: first.same.map(|v| says.fact("same", v)),
        start: first.start.map(|v| says.fact("start", v)),
        approach: first.approach.map(|v| says.fact("approach", v)),
        reference: first.reference.map(|v| says.fact("reference", v)),
        side: first.side.map(|v| says.fact("side", v)),
        edge: first.edge.map(|v| says.fact("edge", v)),
        cases: rows.iter().filter_map(|row| case(row, errata)).collect(),
        text: text(first.text.as_ref()),
        note: text(first.note.as_ref()),
        deviation: text(first.deviation.as_ref()),
    }
}

fn says<'a>(row: &'a HomingRow, errata: &'a [ErratumRow]) -> Says<'a> {
    let inferred = row.inferred.as_ref().map_or(&[][..], |i| &i.value);
    Says { inferred, ..Says::plain(&row.meta, row.src.as_ref(), errata) }
}

fn case(row: &HomingRow, errata: &[ErratumRow]) -> Option<HomingCase> {
    let says = says(row, errata);
    let (when, moves) = (row.when.clone()?, row.moves.clone()?);
    Some(HomingCase {
        number: row.case.map(|c| c.value),
        when: says.fact("when", when),
        moves: says.fact("moves", moves),
        abort: row.abort.clone().map(|v| says.fact("abort", v)),
        mask: row.mask.clone().map(|v| says.fact("mask", v)),
    })
}

fn wrong(span: crate::source::Span, message: String, help: &str) -> Diagnostic {
    Diagnostic::new(code::HOMING_ROWS, span, message)
        .why("a method that is half said would be executed some other way")
        .help(help)
}

/// A row has a start and a program, or refers to another method, or says that there is none.
fn complete(row: &HomingRow, whole: &Whole, sink: &mut Sink) {
    let (method, &Whole { absent, same }) = (row.method.value, whole);
    match (row.when.is_some(), row.moves.is_some()) {
        (true, false) => sink.push(wrong(
            row.meta.span(),
            format!("`homing {method}` has a start and no moves"),
            "add `moves = ...`; where the manual does not say, end them with `not stated`",
        )),
        (false, true) => sink.push(wrong(
            row.meta.span(),
            format!("`homing {method}` has moves and no start"),
            "add `when = ...`; `any` holds for every start",
        )),
        (true, true) if same || absent => sink.push(wrong(
            row.meta.span(),
            format!("`homing {method}` has a program, and says that there is none of its own"),
            "remove `when` and `moves`, or `same` and `status`",
        )),
        (false, false) if !same && !absent => sink.push(wrong(
            row.meta.span(),
            format!("`homing {method}` says nothing"),
            "add `when` and `moves`, or `same`, or `status = \"reserved\"`",
        )),
        _ => {}
    }
}

/// `any` holds at once: with it as `abort` every homing would end with an error.
fn can_end(row: &HomingRow, sink: &mut Sink) {
    if let Some(abort) = row.abort.as_ref().filter(|abort| abort.value.0.is_empty()) {
        let text = format!("`homing {}` always ends with an error", row.method.value);
        sink.push(wrong(abort.span, text, "name the switch that ends it, or remove `abort`"));
    }
}

/// Cases have numbers or none has, and what is said of the method as a whole stands in its first row.
fn later(row: &HomingRow, first: &HomingRow, sink: &mut Sink) {
    let method = row.method.value;
    if row.case.is_some() != first.case.is_some() {
        sink.push(wrong(
            row.meta.span(),
            format!("`homing {method}` has cases with a number and without"),
            "give each case its `case = ...`, or none",
        ));
    }
    for (key, value) in OF_METHOD.iter().filter_map(|key| Some((key, row.meta.raw.get(key)?))) {
        let help = "write it in the row of the first case";
        let text = format!("`{key}` of `homing {method}` stands in a row that is not its first");
        sink.push(wrong(value.span, text, help).why("it belongs to the method as a whole and would be lost"));
    }
}

/// A method that is the same as another needs that one, with a program of its own.
fn reference(method: &HomingMethod, methods: &[HomingMethod], sink: &mut Sink) {
    let Some(Fact { value: same, origin }) = &method.same else { return };
    let found = methods.iter().find(|m| m.number == *same && !m.cases.is_empty());
    if found.is_none() {
        sink.push(wrong(
            origin.span,
            format!("`homing {}` is the same as {same}, which has no program", method.number),
            "name a method that has rows with `moves`",
        ));
    }
}
