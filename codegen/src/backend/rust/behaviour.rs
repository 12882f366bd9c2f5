//! `behaviour.rs`: modes, states, commands, abort codes, emergency message, terminals, rules, and when written values take
//! effect. Each table only where it has rows.

use std::fmt::Write;

use super::items;
use super::lower::Lowered;
use super::number::{grouped, hex};
use super::table::address;
use crate::emit::escape::rust_str;
use crate::model::{Command, Entry, Expr, Mode, Model, Rule, State, Term, Terminal};

/// A table of the crate.
struct Table {
    /// The name of the static, which the builder method of the model has, too.
    name: &'static str,
    row: &'static str,
    doc: &'static str,
    rows: Vec<String>,
}

pub(super) fn body(lowered: &Lowered<'_>) -> String {
    let mut out = String::from("use drivewright_runtime::prelude::*;\n");
    if lowered.model.rules.iter().any(|r| r.on.is_some() || r.when.is_some() || r.require.is_some()) {
        out.push_str("use drivewright_runtime::rule::*;\n");
    }
    let tables = tables(lowered.model).into_iter();
    out.extend(tables.map(|t| items::typed_table(t.doc, t.name, t.row, t.rows.into_iter())));
    out
}

/// The names of the statics.
pub(super) fn names(model: &Model) -> impl Iterator<Item = &'static str> {
    tables(model).into_iter().map(|table| table.name)
}

/// What the tables hold, as a list in words; empty without tables.
pub(super) fn held(model: &Model) -> String {
    let words = tables(model).into_iter().map(|table| match table.name {
        "EFFECTS" => "when written values take effect".to_owned(),
        "ABORTS" => "abort codes".to_owned(),
        "EMCY" => "the emergency message".to_owned(),
        "RULES" => "rules between values, which a program can evaluate".to_owned(),
        name => name.to_ascii_lowercase(),
    });
    words.collect::<Vec<_>>().join(", ")
}

/// The tables that have rows.
fn tables(model: &Model) -> Vec<Table> {
    let table = |name, row, doc, rows| Table { name, row, doc, rows };
    let mut tables = vec![
        table(
            "EFFECTS",
            "EffectDesc",
            "Entries of which the manual says when a written value takes effect, by address.",
            model.entries.as_slice().iter().filter_map(effect).collect(),
        ),
        table("MODES", "ModeDesc<'static>", "Modes of operation, by number.", each(&model.modes, mode)),
        table(
            "STATES",
            "StateDesc<'static>",
            "States, as the statusword shows them.",
            each(&model.states, state),
        ),
        table(
            "COMMANDS",
            "CommandDesc<'static>",
            "Commands, as the controlword gives them.",
            each(&model.commands, command),
        ),
        table("ABORTS", "AbortDesc<'static>", "Abort codes of SDO transfers.", each(&model.aborts, abort)),
        table("EMCY", "EmcyDesc", "The emergency message, by byte.", each(&model.emcy, emcy)),
        table(
            "TERMINALS",
            "TerminalDesc<'static>",
            "Terminals.",
            each(&model.terminals, |t| terminal(model, t)),
        ),
        table("RULES", "RuleDesc<'static>", "Rules between values, by id.", each(&model.rules, rule)),
    ];
    tables.retain(|table| !table.rows.is_empty());
    tables
}

fn each<T>(rows: &[T], text: impl Fn(&T) -> String) -> Vec<String> {
    rows.iter().map(text).collect()
}

fn effect(entry: &Entry) -> Option<String> {
    let effect = entry.effect.as_ref()?.value;
    Some(format!("EffectDesc::new({}, Effect::{effect:?})", address(entry.address)))
}

fn mode(mode: &Mode) -> String {
    let name = rust_str(mode.name.value.original());
    let mut row = format!("ModeDesc::new({}, \"{name}\")", mode.number);
    if let Some(objects) = &mode.objects {
        let list: Vec<String> = objects.value.iter().map(|at| address(*at)).collect();
        let _ = write!(row, ".with_objects(&[{}])", list.join(", "));
    }
    row
}

fn state(state: &State) -> String {
    let name = rust_str(state.name.value.original());
    format!("StateDesc::new(\"{name}\", {}, {})", word(state.mask.value), word(state.value.value))
}

fn command(command: &Command) -> String {
    let name = rust_str(command.name.value.original());
    let mut row =
        format!("CommandDesc::new(\"{name}\", {}, {})", word(command.mask.value), word(command.value.value));
    if command.edge.as_ref().is_some_and(|edge| edge.value) {
        row.push_str(".on_edge()");
    }
    if let Some(transitions) = &command.transitions {
        let list: Vec<String> = transitions.value.iter().map(ToString::to_string).collect();
        let _ = write!(row, ".with_transitions(&[{}])", list.join(", "));
    }
    row
}

/// A controlword or statusword.
fn word(word: u16) -> String {
    hex(word.into(), 4)
}

fn abort(abort: &crate::model::Abort) -> String {
    let code = hex(abort.code.value.into(), 8);
    format!("AbortDesc::new(AbortCode({code}), \"{}\")", rust_str(&abort.name.value))
}

fn emcy(part: &crate::model::EmcyPart) -> String {
    format!("EmcyDesc::new({}, {}, EmcyContent::{:?})", part.byte, part.bytes.value, part.holds.value)
}

fn terminal(model: &Model, terminal: &Terminal) -> String {
    let name = rust_str(&terminal.name);
    let mut row = format!("TerminalDesc::new(\"{name}\", TerminalKind::{:?})", terminal.kind.value);
    if let Some(object) = &terminal.object {
        let _ = write!(row, ".with_object({})", address(object.value));
    }
    if let Some(bit) = &terminal.bit {
        let _ = write!(row, ".with_bit({})", bit.value);
    }
    if let Some(function) = model.function_of(terminal) {
        let _ = write!(row, ".with_function({})", address(function));
    }
    row
}

fn rule(rule: &Rule) -> String {
    let mut row = format!("RuleDesc::new(\"{}\", \"{}\")", rust_str(&rule.id), rust_str(&rule.text.value));
    if let Some(on) = &rule.on {
        let _ = write!(row, ".with_on(Occasion::{:?})", on.value);
    }
    if let Some(when) = &rule.when {
        let _ = write!(row, ".with_when(&[{}])", terms(&when.value));
    }
    if let Some(require) = &rule.require {
        let _ = write!(row, ".with_require(&[{}])", terms(&require.value));
    }
    row
}

fn terms(expr: &Expr) -> String {
    let term = |term: &Term| match term {
        Term::Number(n) => format!("Term::Number({})", grouped((*n).into())),
        Term::Object(at) => format!("Term::Object({})", address((*at).into())),
        Term::Apply(op) => format!("Term::Apply(Op::{op:?})"),
    };
    let list: Vec<String> = expr.terms.iter().map(term).collect();
    list.join(", ")
}
