//! `homing.rs`: each homing method as a constant with its program, and the table of them. Only where there are some.

use std::fmt::Write;

use super::docs::comment;
use super::items::variants;
use super::lower::Lowered;
use crate::emit::escape::rust_doc;
use crate::model::{Event, HomingCase, HomingMethod, HomingStatus, Level, Origin, Step, When};

pub(super) fn body(lowered: &Lowered<'_>) -> String {
    let methods = &lowered.model.homing;
    let mut out = String::from("use drivewright_runtime::homing::*;\n");
    for method in methods {
        one(&mut out, method);
    }
    let doc = comment("", &["Homing methods, by number.".to_owned()]);
    let _ = writeln!(out, "\n{doc}pub static HOMING: [HomingDesc<'static>; {}] = [", methods.len());
    for method in methods {
        let _ = writeln!(out, "    {},", name(method.number));
    }
    out.push_str("];\n");
    out
}

/// `METHOD_7`, or `METHOD_N2` for -2.
fn name(number: i8) -> String {
    let sign = if number < 0 { "N" } else { "" };
    format!("METHOD_{sign}{}", number.unsigned_abs())
}

fn one(out: &mut String, method: &HomingMethod) {
    let _ = write!(out, "\n{}", comment("", &doc(method)));
    let _ = write!(
        out,
        "pub const {}: HomingDesc<'static> = HomingDesc::new({})",
        name(method.number),
        method.number
    );
    for call in columns(method) {
        let _ = write!(out, "\n    {call}");
    }
    if !method.cases.is_empty() {
        out.push_str("\n    .with_cases(&[\n");
        for case in &method.cases {
            self::case(out, case);
        }
        out.push_str("    ])");
    }
    out.push_str(";\n");
}

/// Builder calls for what a method has besides its cases.
fn columns(method: &HomingMethod) -> Vec<String> {
    let status = Some(method.status.value).filter(|status| *status != HomingStatus::Supported);
    let calls = [
        status.map(|s| format!(".with_status(HomingStatus::{s:?})")),
        method.same.as_ref().map(|n| format!(".with_same({})", n.value)),
        method.start.as_ref().map(|s| format!(".with_start(HomingStart::{:?})", s.value)),
        method.approach.as_ref().map(|s| format!(".with_approach(HomingSignal::{:?})", s.value)),
        method.reference.as_ref().map(|s| format!(".with_reference(HomingSignal::{:?})", s.value)),
        method.side.as_ref().map(|s| format!(".with_side(Side::{:?})", s.value)),
        method.edge.as_ref().map(|e| format!(".with_edge(Edge::{:?})", e.value)),
    ];
    calls.into_iter().flatten().collect()
}

fn case(out: &mut String, case: &HomingCase) {
    let _ = writeln!(out, "        HomingCase::new(");
    let _ = writeln!(out, "            {},", levels(&case.when.value));
    out.push_str("            &[\n");
    for step in &case.moves.value.0 {
        let _ = writeln!(out, "                {},", self::step(*step));
    }
    out.push_str("            ],\n        )");
    if let Some(abort) = &case.abort {
        let _ = write!(out, "\n        .with_abort({})", levels(&abort.value));
    }
    if let Some(mask) = &case.mask {
        let _ = write!(out, "\n        .with_mask(&[{}])", variants("Signal", &mask.value));
    }
    out.push_str(",\n");
}

fn levels(when: &When) -> String {
    let list: Vec<String> = when.0.iter().map(|l| level(*l)).collect();
    format!("&[{}]", list.join(", "))
}

fn level(level: Level) -> String {
    match level {
        Level::Switch(at, on) => format!("Level::{}(Signal::{at:?})", on_off(on)),
        Level::Standstill | Level::AtHome => format!("Level::{level:?}"),
    }
}

fn step(step: Step) -> String {
    match step {
        Step::Move { direction, pace, until } => {
            format!("Step::{pace}(Side::{direction:?}, {})", event(until))
        }
        Step::Stop | Step::Latch | Step::Return | Step::Done | Step::NotStated => format!("Step::{step:?}"),
    }
}

fn event(event: Event) -> String {
    match event {
        Event::Switch(at, on) => format!("Event::{}(Signal::{at:?})", on_off(on)),
        Event::Index | Event::Torque(_) | Event::Stall => format!("Event::{event:?}"),
    }
}

fn on_off(on: bool) -> &'static str {
    if on { "on" } else { "off" }
}

fn doc(method: &HomingMethod) -> Vec<String> {
    let what = match (method.status.value, &method.same) {
        (HomingStatus::Reserved, _) => ": reserved for later".to_owned(),
        (HomingStatus::NotAvailable, _) => ": the drive does not have it".to_owned(),
        (HomingStatus::Supported, Some(same)) => format!(": the same as method {}", same.value),
        (HomingStatus::Supported, None) => String::new(),
    };
    let mut lines = vec![format!("Homing method {}{what}.", method.number)];
    // Each case is an item of a list, and what follows it a paragraph of its own.
    lines.extend((!method.cases.is_empty()).then(String::new));
    lines.extend(method.cases.iter().map(case_doc));
    let said = said(method);
    lines.extend((!said.is_empty()).then(String::new));
    lines.extend(said);
    lines
}

/// The program as text: made of words of the language only, so that it needs no escaping.
fn case_doc(case: &HomingCase) -> String {
    let start = if case.when.value.0.is_empty() { "any start" } else { &format!("`{}`", case.when.value) };
    let abort = case.abort.as_ref().map_or_else(String::new, |a| format!("; an error on `{}`", a.value));
    let mask = case.mask.as_ref().map_or_else(String::new, |m| {
        let list: Vec<String> = m.value.iter().map(|s| format!("`{}`", s.word())).collect();
        format!("; without effect: {}", list.join(", "))
    });
    format!("- From {start}: `{}`{abort}{mask}.", case.moves.value)
}

/// Our words, and who says it.
fn said(method: &HomingMethod) -> Vec<String> {
    let mut lines: Vec<String> = method.text.iter().map(|t| rust_doc(t)).collect();
    lines.extend(method.note.iter().map(|n| format!("Note: {}", rust_doc(n))));
    lines.extend(method.deviation.iter().map(|d| format!("Deviates from the standard: {}", rust_doc(d))));
    for reason in method.cases.iter().flat_map(reasons) {
        // Cases share most of theirs.
        if !lines.contains(&reason) {
            lines.push(reason);
        }
    }
    let mut cites: Vec<String> = Vec::new();
    let cases = method.cases.iter().map(|case| &case.moves.origin);
    for origin in std::iter::once(&method.status.origin).chain(cases) {
        let cite = origin.cite.as_ref().map(ToString::to_string);
        cites.extend(cite.filter(|c| !cites.contains(c)));
    }
    if !cites.is_empty() {
        lines.push(format!("Manual: {}.", rust_doc(&cites.join(", "))));
    }
    lines
}

/// What the manual does not say itself of a case, and why it is so.
fn reasons(case: &HomingCase) -> Vec<String> {
    let facts: [(&str, Option<&Origin>); 4] = [
        ("start", Some(&case.when.origin)),
        ("program", Some(&case.moves.origin)),
        ("end with an error", case.abort.as_ref().map(|f| &f.origin)),
        ("list of signals without effect", case.mask.as_ref().map(|f| &f.origin)),
    ];
    let reason = |(what, origin): (&str, Option<&Origin>)| {
        let class = &origin?.class;
        let detail = rust_doc(class.detail()?.trim_end_matches('.'));
        Some(format!("The {what} is {}: {detail}.", class.word()))
    };
    facts.into_iter().filter_map(reason).collect()
}
