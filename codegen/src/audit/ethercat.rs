//! Evidence for the EtherCAT side: slave controller, CoE, synchronization, start-up. Manuals print these in sentences and in
//! lists of properties, so that the profile says with `printed` which words mean what.

use super::behaviour::{example_shown, time_shown};
use super::words::{Row, Words, holds_number, holds_word, same_letters};

/// Whether the line belongs to the row: it names the unit by its number, or a word of what the row is about.
pub(super) fn anchors(words: &Words<'_>, row: &Row<'_>, text: &str) -> bool {
    match unit(row) {
        ("sync manager" | "fmmu", _) => numbered(row).is_some_and(|unit| holds_unit(text, &unit)),
        ("coe", feature) => named(words, "coe", feature, text),
        ("dc mode", _) => ["name", "sync"].into_iter().any(|f| shown(words, row, f, text)),
        ("startup", _) => row.value("write").is_some_and(|at| example_shown("write", at, text)),
        _ => row.facts.iter().any(|f| shows(words, row, &f.field, &f.value, text)),
    }
}

/// Whether the line shows the value.
pub(super) fn shows(words: &Words<'_>, row: &Row<'_>, field: &str, value: &str, text: &str) -> bool {
    match (unit(row).0, field) {
        ("sync manager", "use") => device_shown(words, row, "sync-manager", value, text),
        ("fmmu", "use") => device_shown(words, row, "fmmu", value, text),
        ("coe", "supported") => value == "true" && named(words, "coe", unit(row).1, text),
        ("dc mode", "sync") => named(words, "dc-sync", value, text),
        ("startup", "write") => example_shown("write", value, text),
        (_, "name" | "type" | "group") => holds_word(text, value),
        (_, "physics" | "mailbox" | "revision_check" | "transition" | "enable") => {
            named(words, field, value, text)
        }
        _ => number(value).is_some_and(|n| holds_number(text, n) || n > 1 && time_shown(text, n)),
    }
}

/// Lists of words of the SII, which are printed over several lines.
pub(super) fn proves_whole(field: &str, value: &str, text: &str) -> Option<bool> {
    let all = || value.split(' ').all(|word| number(word).is_some_and(|n| holds_number(text, n)));
    matches!(field, "config" | "bootstrap").then(all)
}

/// Kind and name of the row: `sync manager` and `2`.
fn unit<'f>(row: &Row<'f>) -> (&'f str, &'f str) {
    let kinds = ["sync manager", "fmmu", "coe", "dc mode", "startup"];
    let split = kinds.iter().find_map(|kind| Some((*kind, row.key.strip_prefix(kind)?.trim_start())));
    split.unwrap_or((row.key, ""))
}

/// `SM2`, `FMMU0`.
fn numbered(row: &Row<'_>) -> Option<String> {
    match unit(row) {
        ("sync manager", number) => Some(format!("SM{number}")),
        ("fmmu", number) => Some(format!("FMMU{number}")),
        _ => None,
    }
}

/// Whether the unit is named as such, and not as a part of another word or number.
fn holds_unit(text: &str, unit: &str) -> bool {
    let edge = |c: Option<char>| c.is_none_or(|c| !c.is_alphanumeric());
    text.match_indices(unit)
        .any(|(at, _)| edge(text[..at].chars().next_back()) && edge(text[at + unit.len()..].chars().next()))
}

/// `SM0:Mailbox output`, `FMMU1:Process data input area`.
fn device_shown(words: &Words<'_>, row: &Row<'_>, field: &str, value: &str, text: &str) -> bool {
    let unit = numbered(row).unwrap_or_default();
    words.printed_for(field, value).any(|printed| text.contains(&format!("{unit}:{printed}")))
}

fn shown(words: &Words<'_>, row: &Row<'_>, field: &str, text: &str) -> bool {
    row.value(field).is_some_and(|value| shows(words, row, field, value, text))
}

/// Whether the text has the value, or a word that the profile says to mean it.
fn named(words: &Words<'_>, field: &str, value: &str, text: &str) -> bool {
    holds_word(text, value)
        || words.printed_for(field, value).any(|printed| holds_word(text, printed))
        || words.printed_for(field, value).any(|printed| same_letters(text, printed))
}

fn number(value: &str) -> Option<i128> {
    match value.strip_prefix("0x") {
        Some(hex) => i128::from_str_radix(hex, 16).ok(),
        None => value.parse().ok(),
    }
}
