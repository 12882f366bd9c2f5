//! What the outputs for people say alike: what differs, both values, both citations, the verdict in a sentence.

use std::collections::BTreeSet;

use super::{Change, Effect, Level, Report, Row, Said, Version, What};

/// What stands where a side says nothing.
pub(super) const SILENT: &str = "not stated";

/// The row, and its field where one is meant: `object 605A:00 default`.
pub(super) fn title(change: &Change) -> String {
    match &change.what {
        What::Changed(field, ..) => format!("{} {field}", change.key),
        What::Added(_) | What::Removed(_) => change.key.clone(),
    }
}

/// The values of a row in one line: `name Speed, type u16`. The name in code is not among them: it is the printed one.
pub(super) fn summary(row: &Row) -> String {
    let told = |(field, said): &&(String, Said)| {
        !(field == "handle" && row.fact("name").is_some() || said.text.is_empty())
    };
    let one = |(field, said): &(String, Said)| format!("{field} {}", said.text);
    row.facts.iter().filter(told).map(one).collect::<Vec<_>>().join(", ")
}

/// The old and the new value; `None` for a row that is not there.
pub(super) fn values(change: &Change) -> (Option<String>, Option<String>) {
    let text = |said: &Option<Said>| Some(said.as_ref().map_or(SILENT.to_owned(), |said| said.text.clone()));
    match &change.what {
        What::Added(row) => (None, Some(summary(row))),
        What::Removed(row) => (Some(summary(row)), None),
        What::Changed(_, old, new) => (text(old), text(new)),
    }
}

/// Where the old and the new manual say it.
pub(super) fn cites(change: &Change) -> (Option<String>, Option<String>) {
    match &change.what {
        What::Added(row) => (None, of_row(row)),
        What::Removed(row) => (of_row(row), None),
        What::Changed(_, old, new) => (of_value(old.as_ref()), of_value(new.as_ref())),
    }
}

fn of_row(row: &Row) -> Option<String> {
    let cites: BTreeSet<&str> = row.facts.iter().filter_map(|(_, said)| said.cite.as_deref()).collect();
    (!cites.is_empty()).then(|| cites.into_iter().collect::<Vec<_>>().join(", "))
}

/// The citation, with how else it is known and the erratum.
fn of_value(said: Option<&Said>) -> Option<String> {
    let said = said?;
    let class = match (said.class.as_str(), &said.detail) {
        ("stated" | "own", _) => None,
        (class, Some(detail)) => Some(format!("{class} ({detail})")),
        (class, None) => Some(class.to_owned()),
    };
    let erratum = said.erratum.as_ref().map(|id| format!("[{id}]"));
    let parts: Vec<String> = said.cite.iter().cloned().chain(erratum).chain(class).collect();
    (!parts.is_empty()).then(|| parts.join(" "))
}

/// `1 breaking, 2 axis`, or `no difference`.
pub(super) fn counts(report: &Report) -> String {
    let count = |effect: Effect| (report.count(effect), effect.word());
    let told: Vec<String> = Effect::ALL
        .map(count)
        .iter()
        .filter(|(n, _)| *n > 0)
        .map(|(n, word)| format!("{n} {word}"))
        .collect();
    if told.is_empty() { "no difference".to_owned() } else { told.join(", ") }
}

/// Which version the crate needs, whether it has it, and why.
pub(super) fn verdict(report: &Report) -> String {
    let verdict = &report.verdict;
    let needs = verdict.needs.map_or_else(String::new, |v: Version| v.to_string());
    let why = match verdict.level {
        Level::Breaking => {
            "code may not compile or an axis may do something else, and nobody may get that by `cargo update`"
        }
        Level::Addition => "there is more than before, and all of before",
        Level::Texts => "texts only",
        Level::Nothing => "nothing to release",
    };
    let (has, rule) = (&report.new, verdict.rule);
    match (verdict.needs, verdict.enough, verdict.level) {
        (None, true, _) => format!("version {has}: {rule}"),
        (None, false, _) => format!("version {has}: the version before is no version that can be compared"),
        (Some(_), true, Level::Nothing) => format!("version {has} can stay: {rule}"),
        (Some(_), true, _) => {
            format!("version {has} is high enough (at least {needs}, {}): {why}; {rule}", verdict.bump.word())
        }
        (Some(_), false, _) => format!(
            "version {has} is too low: raise `crate_version` in drive.toml from {} to at least {needs} ({}): {why}; {rule}",
            report.old,
            verdict.bump.word()
        ),
    }
}

/// The number of citations that moved under values that did not.
pub(super) fn moved(count: usize) -> String {
    let (facts, cite) = if count == 1 { ("fact has", "its source") } else { ("facts have", "their sources") };
    format!("{count} {facts} the same value, and {cite} changed (class, place, rule or erratum)")
}
