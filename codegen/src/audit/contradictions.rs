//! Every place where a thing is printed, side by side, and what differs.

use super::evidence::printed;
use super::page::{Line, Page};
use super::words::{Row, Words, same};
use super::{Manual, group};
use crate::facts::{FactLine, Table};
use crate::model::{Address, Model};
use crate::rows::Rows;

/// What stands for the value of a key that the profile does not have; only an erratum of another key can explain it.
const NOT_STATED: &str = "not stated";

/// A place where a row is printed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Place {
    /// The line of the text extract.
    pub line: u32,
    /// What is printed there for the key.
    pub printed: String,
}

/// A key of a row that is printed in more than one place, not everywhere the same.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Contradiction {
    /// The row.
    pub at: String,
    /// The key.
    pub field: String,
    /// What the profile has.
    pub value: String,
    /// Places that print something else.
    pub places: Vec<Place>,
    /// The errata that name these places; empty where an exception settles it.
    pub errata: Vec<String>,
    /// Why the difference is none, by an exception of the profile.
    pub harmless: Option<String>,
    /// The place of that exception in `unproved`.
    pub(super) exception: Option<usize>,
}

impl Contradiction {
    /// Whether an erratum or an exception settles it.
    pub fn settled(&self) -> bool {
        !self.errata.is_empty() || self.harmless.is_some()
    }
}

/// The column that shows a key.
fn column(field: &str) -> Option<&'static str> {
    Some(match field {
        "name" => "name",
        "type" => "type",
        "access" => "access",
        "pdo" => "pdo",
        "unit" => "unit",
        "min" | "max" | "allow" => "range",
        "default" => "default",
        _ => return None,
    })
}

/// Everything that a comparison reads.
struct Comparison<'a> {
    model: &'a Model,
    rows: &'a Rows,
    words: Words<'a>,
    page: Page,
    of: Manual<'a>,
}

/// Compares every object with the rows that print it again, and every alarm with the section that details it.
pub fn contradictions(
    model: &Model,
    facts: &[FactLine<'_>],
    rows: &Rows,
    manual: &str,
    text: &str,
) -> Vec<Contradiction> {
    let of = Manual { id: manual, only: model.manuals.len() == 1 };
    let all = Comparison { model, rows, words: Words::new(rows), page: Page::new(text, rows), of };
    let mut found = Vec::new();
    for row in group(facts) {
        match row.table {
            Table::Objects => all.object(&row, &mut found),
            Table::Alarms => all.alarm(&row, &mut found),
            _ => {}
        }
    }
    found
}

/// Keys that a place may print where the profile has none.
const SILENT: &[(&str, &str)] = &[("unit", "unit"), ("min", "range"), ("default", "default")];

impl Comparison<'_> {
    fn object(&self, row: &Row<'_>, found: &mut Vec<Contradiction>) {
        let Some(also) = entry(row, self.model).and_then(|e| e.also.as_ref()) else { return };
        let lines = self.of.lines(also);
        for fact in &row.facts {
            let Some(column) = column(&fact.field) else { continue };
            let places = self.differing(row, &as_printed(row, fact, self.model), &lines, column);
            self.note(row, &fact.field, &fact.value, places, found);
        }
        for (field, column) in SILENT.iter().filter(|(field, _)| row.value(field).is_none()) {
            let printed = |line: &Line| {
                let cell = line.cell(column).filter(|cell| *cell != "-")?;
                let counts = *field != "min" || row.value("allow").is_none() && cell.contains('~');
                counts.then(|| cell.to_owned())
            };
            let place = |number: &u32| {
                let printed = self.page.line(*number).and_then(printed)?;
                Some(Place { line: *number, printed })
            };
            self.note(row, field, NOT_STATED, lines.iter().filter_map(place).collect(), found);
        }
    }

    /// The title of the section against the name, and what it says of the reset.
    fn alarm(&self, row: &Row<'_>, found: &mut Vec<Contradiction>) {
        let display = row.id().split(' ').next().unwrap_or_default();
        let titles: Vec<&str> = self.words.printed_for("section", display).collect();
        let lines = || self.page.lines().filter(|(_, line)| titles.contains(&line.section.as_str()));
        let Some((title_line, first)) = lines().next() else { return };
        let title = first.section.split_once(") ").map_or(first.section.as_str(), |(_, title)| title);
        let place = |line: u32, printed: &str| Place { line, printed: printed.to_owned() };
        for fact in row.facts.iter().filter(|f| f.field == "name" && !same(title, &f.value)) {
            self.note(row, "name", &fact.value, vec![place(title_line, title)], found);
        }
        for fact in row.facts.iter().filter(|f| f.field == "reset") {
            let cells = lines().filter_map(|(n, line)| Some((n, self.words.beside("reset", line)?)));
            let other = cells.filter(|(_, cell)| !self.words.means("reset", cell, &fact.value));
            self.note(row, "reset", &fact.value, other.map(|(n, cell)| place(n, cell)).collect(), found);
        }
    }

    fn note(
        &self,
        row: &Row<'_>,
        field: &str,
        value: &str,
        places: Vec<Place>,
        found: &mut Vec<Contradiction>,
    ) {
        if !places.is_empty() {
            found.push(self.settle(row, field, value, places));
        }
    }

    /// The lines that print something else than the fact.
    fn differing(&self, row: &Row<'_>, fact: &FactLine<'_>, lines: &[u32], column: &str) -> Vec<Place> {
        let split = |number: u32| {
            // A cell of two rows is read with that of the row below or above.
            [number, number.saturating_sub(1)].iter().any(|first| {
                let pair: Vec<&Line> =
                    [*first, first + 1].iter().filter_map(|n| self.page.line(*n)).collect();
                super::dictionary::shows_split(&self.words, row, fact, &pair)
            })
        };
        let other = |number: &u32| {
            let line = self.page.line(*number)?;
            let cell = line.cell(column).filter(|cell| *cell != "-")?;
            let shown = self.words.shows(row, fact, line) || split(*number);
            (!shown).then(|| Place { line: *number, printed: cell.to_owned() })
        };
        lines.iter().filter_map(other).collect()
    }

    fn settle(&self, row: &Row<'_>, field: &str, value: &str, places: Vec<Place>) -> Contradiction {
        let settles = |e: &&crate::model::Erratum| {
            let cites = std::iter::once(&e.seen).chain(&e.by);
            let lines: Vec<u32> = cites.flat_map(|c| self.of.lines(c)).collect();
            super::evidence::names(&e.at, row.key)
                && (e.field == field || value == NOT_STATED && column(&e.field) == column(field))
                && places.iter().all(|p| lines.contains(&p.line))
        };
        let errata = self.model.errata.as_slice().iter().filter(settles).map(|e| e.id.clone()).collect();
        let excepted = format!("also {field}");
        let exception = self.rows.unproved.iter().position(|r| {
            let named = &r.at.value.0;
            let at = named.strip_suffix('*').map_or(named == row.key, |start| row.key.starts_with(start));
            at && r.field.as_ref().is_some_and(|f| f.value.0 == excepted)
        });
        Contradiction {
            at: row.key.to_owned(),
            field: field.to_owned(),
            value: value.to_owned(),
            places,
            errata,
            harmless: exception.map(|place| self.rows.unproved[place].why.value.0.clone()),
            exception,
        }
    }
}

pub(super) fn entry<'m>(row: &Row<'_>, model: &'m Model) -> Option<&'m crate::model::Entry> {
    let (index, sub) = row.id().split_once(':')?;
    let address = Address::new(u16::from_str_radix(index, 16).ok()?, u8::from_str_radix(sub, 16).ok()?);
    model.entry(address).map(|(_, entry)| entry)
}

/// The fact as the manual prints it: before an erratum changed it.
fn as_printed<'f>(row: &Row<'f>, fact: &FactLine<'f>, model: &Model) -> FactLine<'f> {
    let changed = fact.erratum.and_then(|id| {
        model
            .errata
            .as_slice()
            .iter()
            .find(|e| e.id == id && e.field == fact.field && (e.set.is_some() || e.unset))
    });
    changed.map_or_else(|| fact.clone(), |erratum| printed(row, erratum))
}
