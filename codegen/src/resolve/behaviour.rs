//! Modes, states, commands, abort codes, terminals, rules and examples: tables that nothing else refers to. Each is sorted by its key; of two rows with one key the second is reported.

use super::objects::check_reasons;
use super::origin::Says;
use crate::diag::{Diagnostic, Sink, code};
use crate::merge::Profile;
use crate::model::{
    Abort, Address, Cite, Command, EmcyPart, Entries, Example, Fact, Mode, Model, Rule, State, Terminal,
};
use crate::rows::address::Sub;
use crate::rows::tables::{
    AbortRow, CommandRow, EmcyRow, ErratumRow, ExampleRow, ModeRow, RuleRow, StateRow, TerminalRow,
};
use crate::rows::value::{Reason, Text};
use crate::rows::{Meta, Row, Rows};
use crate::source::Sp;

/// Fills the tables of `model`.
pub(super) fn fill(model: &mut Model, profile: &Profile, sink: &mut Sink) {
    let (rows, errata) = (&profile.rows, profile.rows.errata.as_slice());
    model.modes = sorted(&rows.modes, |r| r.mode.value, sink).map(|r| mode(r, errata)).collect();
    // States and commands stay in the order of the manual.
    model.states = printed(&rows.states, |r| r.src.as_ref(), sink).map(|r| state(r, errata)).collect();
    model.commands = printed(&rows.commands, |r| r.src.as_ref(), sink).map(|r| command(r, errata)).collect();
    model.aborts = sorted(&rows.aborts, |r| r.code.value, sink).map(|r| abort(r, errata)).collect();
    model.terminals = printed(&rows.io, |r| r.src.as_ref(), sink).map(|r| terminal(r, errata)).collect();
    super::ethercat::fill(model, profile, sink);
    model.emcy = sorted(&rows.emcy, |r| r.byte.value, sink).map(|r| emcy(r, errata)).collect();
    model.rules = sorted(&rows.rules, |r| r.id.value.clone(), sink).map(|r| rule(r, errata)).collect();
    let key = |r: &ExampleRow| (r.id.value.clone(), r.step.map(|s| s.value));
    model.examples = sorted(&rows.examples, key, sink).map(|r| example(r, errata)).collect();
    reasons(profile, sink);
    writes_are_of_entries(&rows.examples, sink);
    objects_exist(model, &profile.rows, sink);
}

/// Rows by `key`, each once.
pub(super) fn sorted<'a, R: Row, K: Ord>(
    rows: &'a [R],
    key: impl Fn(&R) -> K,
    sink: &mut Sink,
) -> impl Iterator<Item = &'a R> {
    let mut sorted: Vec<&R> = rows.iter().collect();
    sorted.sort_by_key(|r| (key(r), r.meta().span()));
    once(sorted, sink)
}

/// Rows in the order of the lines that they cite, each name once: the order of rows in a file means nothing.
fn printed<'a, R: Row>(
    rows: &'a [R],
    src: impl Fn(&R) -> Option<&Sp<Cite>>,
    sink: &mut Sink,
) -> impl Iterator<Item = &'a R> {
    let mut rows: Vec<&R> = rows.iter().collect();
    rows.sort_by_cached_key(|r| (line(src(r)), r.key()));
    once(rows, sink)
}

/// The manual and the line that a citation names first.
pub(super) fn line(src: Option<&Sp<Cite>>) -> Option<(Option<String>, Option<u32>)> {
    let place = src?.value.places.first()?;
    Some((place.manual.clone(), place.lines.first().copied()))
}

fn once<'a, R: Row>(rows: Vec<&'a R>, sink: &mut Sink) -> impl Iterator<Item = &'a R> {
    let mut seen = std::collections::BTreeMap::new();
    let mut out = Vec::with_capacity(rows.len());
    for row in rows {
        if let Some(first) = seen.get(&row.key()) {
            crate::merge::duplicate(row, *first, sink);
        } else {
            seen.insert(row.key(), row);
            out.push(row);
        }
    }
    out.into_iter()
}

pub(super) fn plain<'a>(meta: &'a Meta, src: Option<&'a Sp<Cite>>, errata: &'a [ErratumRow]) -> Says<'a> {
    Says::plain(meta, src, errata)
}

/// A row with inferred fields.
pub(super) fn reasoned<'a>(
    meta: &'a Meta,
    src: Option<&'a Sp<Cite>>,
    inferred: Option<&'a Sp<Vec<Reason>>>,
    errata: &'a [ErratumRow],
) -> Says<'a> {
    Says { inferred: inferred.map_or(&[], |i| &i.value), ..Says::plain(meta, src, errata) }
}

pub(super) fn text(text: Option<&Sp<Text>>) -> Option<String> {
    text.map(|t| t.value.0.clone())
}

/// The fact of a key that may be left out, as `convert` has it.
pub(super) fn maybe<T: Clone, U>(
    says: &Says<'_>,
    key: &str,
    value: Option<&Sp<T>>,
    convert: impl Fn(T) -> U,
) -> Option<Fact<U>> {
    value.map(|v| says.fact(key, v.clone().map(&convert)))
}

fn mode(row: &ModeRow, errata: &[ErratumRow]) -> Mode {
    let says = plain(&row.meta, row.src.as_ref(), errata);
    let listed = plain(&row.meta, row.objects_src.as_ref().or(row.src.as_ref()), errata);
    Mode {
        number: row.mode.value,
        name: says.joint(&["name", "mode"], row.name.clone()),
        objects: maybe(&listed, "objects", row.objects.as_ref(), |o| o),
        text: text(row.text.as_ref()),
    }
}

fn state(row: &StateRow, errata: &[ErratumRow]) -> State {
    let says = plain(&row.meta, row.src.as_ref(), errata);
    State {
        name: says.fact("name", row.name.clone()),
        mask: says.joint(&["mask", "name"], row.mask),
        value: says.fact("value", row.value),
    }
}

fn command(row: &CommandRow, errata: &[ErratumRow]) -> Command {
    let says = plain(&row.meta, row.src.as_ref(), errata);
    Command {
        name: says.fact("name", row.name.clone()),
        mask: says.joint(&["mask", "name"], row.mask),
        value: says.fact("value", row.value),
        edge: maybe(&says, "edge", row.edge.as_ref(), |e| e),
        transitions: maybe(&says, "transitions", row.transitions.as_ref(), |t| t),
    }
}

fn abort(row: &AbortRow, errata: &[ErratumRow]) -> Abort {
    let says = plain(&row.meta, row.src.as_ref(), errata);
    let name = row.name.clone().map(|n| n.0);
    Abort { code: says.fact("code", row.code), name: says.joint(&["name", "code"], name) }
}

fn terminal(row: &TerminalRow, errata: &[ErratumRow]) -> Terminal {
    let says = reasoned(&row.meta, row.src.as_ref(), row.inferred.as_ref(), errata);
    Terminal {
        name: row.terminal.value.0.clone(),
        kind: says.joint(&["kind", "terminal"], row.kind),
        pin: maybe(&says, "pin", row.pin.as_ref(), |p| p),
        object: maybe(&says, "object", row.object.as_ref(), |o| o),
        bit: maybe(&says, "bit", row.bit.as_ref(), |b| b.0),
        parameter: maybe(&says, "parameter", row.parameter.as_ref(), |p| p.0),
        text: text(row.text.as_ref()),
        note: text(row.note.as_ref()),
    }
}

fn emcy(row: &EmcyRow, errata: &[ErratumRow]) -> EmcyPart {
    let says = reasoned(&row.meta, row.src.as_ref(), row.inferred.as_ref(), errata);
    EmcyPart {
        byte: row.byte.value,
        bytes: says.fact("bytes", row.bytes),
        holds: says.joint(&["holds", "byte"], row.holds),
        text: text(row.text.as_ref()),
    }
}

fn rule(row: &RuleRow, errata: &[ErratumRow]) -> Rule {
    let says = plain(&row.meta, row.src.as_ref(), errata);
    Rule {
        id: row.id.value.0.clone(),
        text: says.fact("text", row.text.clone().map(|t| t.0)),
        require: maybe(&says, "require", row.require.as_ref(), |e| e),
        when: maybe(&says, "when", row.when.as_ref(), |e| e),
        on: maybe(&says, "on", row.on.as_ref(), |o| o),
    }
}

fn example(row: &ExampleRow, errata: &[ErratumRow]) -> Example {
    let says = plain(&row.meta, row.src.as_ref(), errata);
    let count = |key, value: Option<&_>| maybe(&says, key, value, |c: crate::rows::value::Count| c.0);
    Example {
        id: row.id.value.0.clone(),
        step: row.step.map(|s| s.value),
        write: maybe(&says, "write", row.write.as_ref(), |at| {
            let (first, last) = match at.sub {
                Sub::Whole => (0, 0),
                Sub::One(sub) => (sub, sub),
                Sub::Range(first, last) => (first, last),
            };
            Entries { first: Address::new(at.index, first), last }
        }),
        entry: maybe(&says, "entry", row.entry.as_ref(), |e| e),
        bits: maybe(&says, "bits", row.bits.as_ref(), |b| b),
        parameter: maybe(&says, "parameter", row.parameter.as_ref(), |p| p.0),
        value: count("value", row.value.as_ref()),
        min: count("min", row.min.as_ref()),
        max: count("max", row.max.as_ref()),
        text: text(row.text.as_ref()),
    }
}

/// An example writes an entry; an index as a whole is none.
fn writes_are_of_entries(rows: &[ExampleRow], sink: &mut Sink) {
    for at in rows.iter().filter_map(|r| r.write.as_ref()).filter(|at| at.value.sub == Sub::Whole) {
        let text = format!("`write` names {} without a sub-index", at.value);
        sink.push(
            Diagnostic::new(code::BAD_ADDRESS, at.span, text)
                .why("an SDO transfer writes one sub-index, and sub-index 0 may not be the one that is meant")
                .help(format!("write it as `{0}:00`, or `{0}:01..04` for several", at.value)),
        );
    }
}

/// Reasons of rows that may have them.
fn reasons(profile: &Profile, sink: &mut Sink) {
    profile.rows.io.iter().for_each(|r| check_reasons(r, [r.inferred.as_ref()], sink));
    profile.rows.emcy.iter().for_each(|r| check_reasons(r, [r.inferred.as_ref()], sink));
    profile.rows.homing.iter().for_each(|r| check_reasons(r, [r.inferred.as_ref()], sink));
    super::ethercat::reasons(&profile.rows, sink);
}

/// Every object that modes, terminals, rules, start-up and examples name must be there.
fn objects_exist(model: &Model, rows: &Rows, sink: &mut Sink) {
    let mut named: Vec<(Address, crate::source::Span)> = Vec::new();
    for mode in &model.modes {
        named.extend(mode.objects.iter().flat_map(|f| f.value.iter().map(|a| (*a, f.span()))));
    }
    named.extend(model.terminals.iter().filter_map(|t| t.object.as_ref()).map(|f| (f.value, f.span())));
    for rule in &model.rules {
        let parts = rule.require.iter().chain(&rule.when);
        named.extend(parts.flat_map(|f| f.value.objects().map(|a| (a, f.span()))));
    }
    named.extend(model.startup.iter().map(|s| (s.write.value, s.write.span())));
    for example in &model.examples {
        named.extend(example.entry.iter().map(|f| (f.value, f.span())));
        // Of several that are not there the first says enough.
        named.extend(example.write.iter().filter_map(|f| {
            let Entries { first, last } = f.value;
            let mut written = (first.sub..=last).map(|sub| Address::new(first.index, sub));
            written.find(|address| model.entry(*address).is_none()).map(|address| (address, f.span()))
        }));
    }
    for (address, span) in named {
        if model.entry(address).is_none() && !rows.left_out.contains(&address.to_string()) {
            sink.push(
                Diagnostic::new(code::UNKNOWN_OBJECT, span, format!("there is no object {address}"))
                    .why("what is said of an object that the dictionary does not have cannot be checked")
                    .help("add a row to `objects`, or correct the address"),
            );
        }
    }
}
