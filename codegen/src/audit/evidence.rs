//! What counts as evidence: which lines belong to a row, and which show a value.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::page::{Line, Page};
use super::{behaviour, dictionary};
use crate::facts::{FactLine, Table};
use crate::model::Erratum;
use crate::rows::Rows;

/// The facts of one row.
#[derive(Clone, Debug)]
pub(super) struct Row<'f> {
    pub(super) table: Table,
    /// As `map.txt` names it: `object 607D:01`.
    pub(super) key: &'f str,
    pub(super) facts: Vec<&'f FactLine<'f>>,
}

impl<'f> Row<'f> {
    /// The value of a key.
    pub(super) fn value(&self, field: &str) -> Option<&'f str> {
        self.facts.iter().find(|f| f.field == field).map(|f| f.value.as_str())
    }

    /// The key without the name of its table: `607D:01`.
    pub(super) fn id(&self) -> &'f str {
        self.key.split_once(' ').map_or("", |(_, id)| id)
    }
}

/// What printed words mean.
pub(super) struct Words<'a> {
    /// Printed words by key.
    printed: BTreeMap<&'a str, Vec<(&'a str, &'a str)>>,
    /// Words that stand in front of their cell, by key.
    beside: BTreeMap<&'a str, Vec<&'a str>>,
}

impl<'a> Words<'a> {
    pub(super) fn new(rows: &'a Rows) -> Self {
        let mut words = Self { printed: BTreeMap::new(), beside: BTreeMap::new() };
        for row in &rows.printed {
            let pair = (row.word.value.0.as_str(), row.means.value.0.as_str());
            words.printed.entry(&row.field.value.0).or_default().push(pair);
        }
        for row in rows.columns.iter().filter(|c| c.beside.is_some_and(|b| b.value)) {
            words.beside.entry(&row.field.value.0).or_default().push(&row.header.value.0);
        }
        words
    }

    /// Whether `cell`, a value of `field`, means `value`: as printed, or by a word of the profile.
    pub(super) fn means(&self, field: &str, cell: &str, value: &str) -> bool {
        same(cell, value) || self.meanings(field, cell).any(|means| means == value)
    }

    /// What `cell` can mean.
    pub(super) fn meanings<'b>(&'b self, field: &str, cell: &'b str) -> impl Iterator<Item = &'a str> + 'b {
        let list = self.printed.get(field).map_or(&[][..], Vec::as_slice);
        list.iter().filter(move |(word, _)| same(word, cell)).map(|(_, means)| *means)
    }

    /// The printed words of `field` that mean `value`.
    pub(super) fn printed_for<'b>(
        &'b self,
        field: &str,
        value: &'b str,
    ) -> impl Iterator<Item = &'a str> + 'b {
        let list = self.printed.get(field).map_or(&[][..], Vec::as_slice);
        list.iter().filter(move |(_, means)| *means == value).map(|(word, _)| *word)
    }

    /// The cell behind a word that stands in front of it.
    pub(super) fn beside<'l>(&self, field: &str, line: &'l Line) -> Option<&'l str> {
        let words = self.beside.get(field)?;
        let at = line.cells.iter().position(|cell| words.iter().any(|word| same(word, cell)))?;
        line.cells.get(at + 1).map(String::as_str)
    }

    /// Whether the line belongs to the row.
    pub(super) fn anchors(&self, row: &Row<'_>, line: &Line) -> bool {
        match row.table {
            Table::Objects => dictionary::object_anchors(row, line),
            Table::Alarms => dictionary::alarm_anchors(self, row, line),
            Table::Pdos => dictionary::pdo_anchors(row, line),
            Table::Enums | Table::Bits => dictionary::named_anchors(row, line),
            _ => behaviour::anchors(self, row, line),
        }
    }

    /// Whether the line shows the fact's value where it should stand.
    pub(super) fn shows(&self, row: &Row<'_>, fact: &FactLine<'_>, line: &Line) -> bool {
        match row.table {
            Table::Objects => dictionary::object_shows(self, row, fact, line),
            Table::Alarms => dictionary::alarm_shows(self, fact, line),
            Table::Pdos => dictionary::pdo_shows(row, fact, line),
            Table::Enums => dictionary::enum_shows(row, fact, line),
            Table::Bits => dictionary::bit_shows(fact, line),
            _ => behaviour::shows(self, row, fact, line),
        }
    }

    /// Whether the cited lines prove the fact: one belongs to the row, and it or another one shows the value.
    pub(super) fn proves(&self, row: &Row<'_>, fact: &FactLine<'_>, page: &Page, cited: &[u32]) -> bool {
        let lines: Vec<&Line> = cited.iter().filter_map(|l| page.line(*l)).collect();
        if lines.len() != cited.len() {
            return false;
        }
        if let Some(proved) = behaviour::proves_whole(self, row, fact, &lines) {
            return proved;
        }
        if fact.erratum.is_some() && lines.iter().any(|l| corrects(fact, l)) {
            return true;
        }
        let anchored = |line: &&&Line| self.anchors(row, line);
        lines.iter().any(|l| anchored(&l))
            && (lines.iter().filter(anchored).any(|l| self.shows(row, fact, l))
                || spans(fact) && lines.iter().any(|l| self.shows(row, fact, l))
                || spans(fact) && dictionary::shows_split(self, row, fact, &lines))
    }
}

/// Whether the line prints, anywhere, the name that an erratum has taken from there.
pub(super) fn corrects(fact: &FactLine<'_>, line: &Line) -> bool {
    fact.erratum.is_some()
        && matches!(fact.field.as_ref(), "name" | "label")
        && letters(&line.text).contains(&letters(&fact.value))
}

/// Whether a cell of the key can stand for several rows, so that it is printed in another one.
fn spans(fact: &FactLine<'_>) -> bool {
    !matches!(fact.field.as_ref(), "name" | "type" | "access" | "number" | "code" | "label")
}

/// Whether the words of the fact are the profile's own.
pub(super) fn is_worded(fact: &FactLine<'_>) -> bool {
    let field = fact.field.as_ref();
    match fact.table {
        Table::Alarms => field.starts_with("cause") || field.starts_with("remed"),
        Table::Aborts => field == "name",
        Table::Terminals => field == "kind",
        Table::Rules => matches!(field, "text" | "on" | "when"),
        Table::Objects => matches!(field, "text" | "values" | "bits"),
        Table::Homing => field == "status",
        Table::Examples => field == "text",
        _ => false,
    }
}

/// Equal but for case and blanks.
pub(super) fn same(a: &str, b: &str) -> bool {
    letters(a) == letters(b)
}

/// Equal but for blanks, which extracts add and lose.
pub(super) fn same_letters(a: &str, b: &str) -> bool {
    a.split_whitespace().flat_map(str::chars).eq(b.split_whitespace().flat_map(str::chars))
}

/// A text without blanks, in lower case.
fn letters(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).flat_map(char::to_lowercase).collect()
}

/// Whether `text` holds `word` as a word of its own, whatever its case.
pub(super) fn holds_word(text: &str, word: &str) -> bool {
    let (text, word) = (text.to_lowercase(), word.to_lowercase());
    let edge = |c: Option<char>| c.is_none_or(|c| !c.is_alphanumeric());
    text.match_indices(&word)
        .any(|(at, _)| edge(text[..at].chars().next_back()) && edge(text[at + word.len()..].chars().next()))
}

/// Whether `text` holds the number, in decimal or hexadecimal.
pub(super) fn holds_number(text: &str, n: i128) -> bool {
    let hex = format!("{n:X}");
    let forms =
        [n.to_string(), format!("0x{hex}"), format!("{hex}h"), format!("0x{n:04X}"), format!("0x{n:02X}h")];
    forms.iter().any(|form| holds_word(text, form))
}

/// Whether `text` names the parameter: by itself, or in a range such as `P3.09~P3.24`.
pub(super) fn names_parameter(text: &str, parameter: &str) -> bool {
    if holds_word(text, parameter) {
        return true;
    }
    let Some((group, number)) = parameter.rsplit_once('.') else { return false };
    let Ok(number) = number.parse::<u32>() else { return false };
    text.split('~').zip(text.split('~').skip(1)).any(|(before, after)| {
        let end = |part: &str, last: bool| -> Option<u32> {
            let word =
                if last { part.split_whitespace().next_back()? } else { part.split_whitespace().next()? };
            let word = word.trim_matches(|c: char| !c.is_alphanumeric());
            word.strip_prefix(group)?.strip_prefix('.')?.parse().ok()
        };
        end(before, true).zip(end(after, false)).is_some_and(|(from, to)| (from..=to).contains(&number))
    })
}

/// A key of a profile row as errata write it, for a key of `map.txt`: `object 607D:01` is `607D:01`.
pub(super) fn profile_key(key: &str) -> String {
    key.strip_prefix("object ").unwrap_or(key).to_owned()
}

/// The key that [`profile_key`] gives for the row that an erratum names.
pub(super) fn row_of_erratum(at: &str, facts: &[FactLine<'_>]) -> String {
    if let Some((table, value)) = at.split_once('=') {
        return format!("{table} {value}");
    }
    if let Some(rest) = at.strip_prefix("bits ")
        && let Some((name, bit)) = rest.rsplit_once('.')
    {
        return format!("bits {name} {bit}");
    }
    if let Some(rest) = at.strip_prefix("pdo ") {
        return format!("pdo {}", rest.replace(':', " "));
    }
    if let Some(display) = at.strip_prefix("alarm ") {
        let start = format!("alarm {display} ");
        let found = facts.iter().find(|f| f.key.starts_with(&start) || f.key == at);
        return found.map_or_else(|| at.to_owned(), |f| f.key.clone());
    }
    at.to_ascii_uppercase().parse::<String>().map_or_else(
        |_| at.to_owned(),
        |upper| if at.contains(':') && at.len() == 7 { upper } else { at.to_owned() },
    )
}

/// The fact that an erratum says is printed.
pub(super) fn printed<'f>(row: &Row<'f>, erratum: &Erratum) -> FactLine<'f> {
    let text = erratum.was.as_str();
    let value = text.strip_prefix('"').and_then(|t| t.strip_suffix('"')).unwrap_or(text);
    let number = value.parse::<i128>().ok();
    let value = match (row.table, erratum.field.as_str(), number) {
        (Table::Alarms, "number", Some(n)) => format!("0x{n:02X}"),
        (Table::Alarms, "code" | "aux" | "al_status", Some(n)) => format!("0x{n:04X}"),
        _ => value.replace("[\"", "").replace("\"]", "").replace("\", \"", " "),
    };
    FactLine {
        table: row.table,
        key: row.key.to_owned(),
        field: Cow::Owned(erratum.field.clone()),
        value,
        class: None,
        cite: None,
        erratum: None,
    }
}
