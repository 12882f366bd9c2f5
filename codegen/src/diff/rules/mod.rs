//! What a difference means: a table of named rules, each with the reason that reports print.
//!
//! The first rule that holds decides. A new rule is one line in the list of its table, in [`dictionary`] or
//! [`behaviour`], above the more general ones, and a line in the table of their tests.

mod behaviour;
mod dictionary;
#[cfg(test)]
mod tests;

use super::{Effect, Row, Said};

/// A difference to be judged.
#[derive(Clone, Copy)]
pub struct Case<'a> {
    /// The row before and now; one of them is `None` when the row came or went.
    pub row: (Option<&'a Row>, Option<&'a Row>),
    /// The field; `None` for the row as a whole.
    pub field: Option<&'a str>,
    /// The value before and now.
    pub said: (Option<&'a Said>, Option<&'a Said>),
    /// Whether what the row is a part of is there on both sides.
    pub parent_stays: bool,
}

impl<'a> Case<'a> {
    fn any(&self) -> Option<&'a Row> {
        self.row.1.or(self.row.0)
    }

    /// Key of the list in `model.json`.
    pub fn table(&self) -> &'static str {
        self.any().map_or("", |row| row.table)
    }

    /// The row's key.
    pub fn key(&self) -> &'a str {
        self.any().map_or("", |row| row.key.as_str())
    }

    fn index(&self) -> u16 {
        self.any().and_then(|row| row.index).unwrap_or_default()
    }

    fn is_part(&self) -> bool {
        self.any().is_some_and(|row| row.parent.is_some())
    }

    fn field_is(&self, names: &[&str]) -> bool {
        self.field.is_some_and(|field| names.contains(&field))
    }

    fn texts(&self) -> (&'a str, &'a str) {
        let text = |said: Option<&'a Said>| said.map_or("", |said| said.text.as_str());
        (text(self.said.0), text(self.said.1))
    }

    fn numbers(&self) -> (Option<i128>, Option<i128>) {
        (self.said.0.and_then(Said::number), self.said.1.and_then(Said::number))
    }

    /// Whether the old row can be written by SDO.
    fn writable(&self) -> bool {
        let access =
            |row: Option<&'a Row>| row.and_then(|row| row.fact("access")).map_or("", |s| s.text.as_str());
        access(self.row.0).contains('w')
    }
}

/// Whether the row came.
fn added(case: &Case<'_>) -> bool {
    case.row.0.is_none()
}

/// Whether the row went.
fn removed(case: &Case<'_>) -> bool {
    case.row.1.is_none()
}

/// Says what a difference does, and why.
pub struct Rule {
    /// Its name, for programs.
    pub name: &'static str,
    /// What the difference does.
    pub effect: Effect,
    /// Whether it is for this difference.
    pub holds: fn(&Case<'_>) -> bool,
    /// The reason.
    pub why: &'static str,
}

/// A line of a list of rules.
const fn rule(name: &'static str, effect: Effect, why: &'static str, holds: fn(&Case<'_>) -> bool) -> Rule {
    Rule { name, effect, holds, why }
}

/// The value is the same.
pub static SOURCE: Rule = rule(
    "source_differs",
    Effect::Documentation,
    "The value is the same; who says it, where, or by which rule is not.",
    |c| matches!(c.said, (Some(old), Some(new)) if old.value == new.value),
);

/// What the profile counts up itself.
pub static VERSION: Rule =
    rule("versions", Effect::Documentation, "The profile's own versions and date.", |c| {
        c.field_is(&["crate_version", "eds_version", "eds_revision", "date"])
    });

/// Where no other rule holds.
pub static UNKNOWN: Rule =
    rule("no_rule", Effect::Breaking, "No rule knows this field: taken as breaking until one does.", |_| {
        true
    });

/// Every rule of a table, in the order in which they are asked.
fn rules(table: &str) -> &'static [Rule] {
    match table {
        "drive" => behaviour::DRIVE,
        "objects" => dictionary::OBJECTS,
        "enums" => dictionary::ENUMS,
        "bits" => dictionary::BITS,
        "pdos" => dictionary::PDOS,
        "alarms" => behaviour::ALARMS,
        "homing" => behaviour::HOMING,
        "modes" => behaviour::MODES,
        "states" | "commands" => behaviour::STATES,
        "terminals" => behaviour::TERMINALS,
        "ethercat" | "sync_managers" | "fmmus" | "coe" | "dc_modes" | "emcy" => behaviour::BUS,
        "startup" => behaviour::STARTUP,
        "rules" => behaviour::RULES,
        "manuals" | "aborts" | "examples" | "errata" => behaviour::TEXTS,
        _ => &[],
    }
}

/// The rule that is for a difference.
pub fn of(case: &Case<'_>) -> &'static Rule {
    if (SOURCE.holds)(case) {
        return &SOURCE;
    }
    rules(case.table()).iter().find(|rule| (rule.holds)(case)).unwrap_or(&UNKNOWN)
}
