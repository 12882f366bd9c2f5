//! What counts as evidence: which lines belong to a row, and which show a value.

use std::borrow::Cow;

use super::page::{Line, Page};
use super::words::{self, Row, Words};
use super::{behaviour, dictionary, number};
use crate::facts::{FactLine, Table};
use crate::model::Erratum;
use crate::rows::address::At;

impl Words<'_> {
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
        let own: Vec<&Line> = lines.iter().copied().filter(|line| self.anchors(row, line)).collect();
        if own.is_empty() {
            return lines.iter().any(|l| corrects(fact, l));
        }
        own.iter().any(|l| self.shows(row, fact, l))
            || spans(fact)
                && own.iter().all(|l| is_open(fact, l))
                && lines.iter().any(|l| self.shows(row, fact, l))
            || dictionary::shows_split(self, row, fact, &lines)
    }
}

/// Whether the row's own line leaves the value to another one: without the cell, or with a part of it.
fn is_open(fact: &FactLine<'_>, line: &Line) -> bool {
    let column = match fact.field.as_ref() {
        "min" | "max" | "allow" => "range",
        field => field,
    };
    line.cell(column).is_none_or(|cell| cell.starts_with('~') || cell.ends_with('~'))
}

/// Whether the line has the name that an erratum has taken from there: as a cell, a label in one, or its title. Such a line
/// is of another row, which is why it counts only where no line of the row itself is cited.
pub(super) fn corrects(fact: &FactLine<'_>, line: &Line) -> bool {
    let whole = |text: &str| words::same(text, &fact.value);
    let listed = |cell: &str| number::labels(cell).iter().any(|(_, label)| whole(label));
    fact.erratum.is_some()
        && matches!(fact.field.as_ref(), "name" | "label")
        && (line.cells.iter().any(|cell| whole(cell) || listed(cell)) || line.title().is_some_and(whole))
}

/// Whether a cell of the key can stand for several rows, so that it is printed in another one.
fn spans(fact: &FactLine<'_>) -> bool {
    !matches!(
        fact.field.as_ref(),
        "name" | "type" | "access" | "number" | "code" | "aux" | "label" | "pin" | "bits" | "entry"
    )
}

/// Whether the words of the fact are the profile's own.
pub(super) fn is_worded(fact: &FactLine<'_>) -> bool {
    let field = fact.field.as_ref();
    match fact.table {
        Table::Alarms => field.starts_with("cause") || field.starts_with("remed"),
        Table::Aborts => field == "name",
        Table::Terminals => field == "kind",
        Table::Rules => matches!(field, "text" | "on" | "when" | "require"),
        Table::Objects => matches!(field, "text" | "values" | "bits"),
        Table::Homing => field == "status",
        Table::Examples => field == "text",
        _ => false,
    }
}

/// A key of a profile row as errata write it, for a key of `map.txt`: `object 607D:01` is `607D:01`.
pub(super) fn profile_key(key: &str) -> String {
    key.strip_prefix("object ").unwrap_or(key).to_owned()
}

/// Whether `at`, as an erratum names a row, is the row with this key of `map.txt`.
pub(super) fn names(at: &str, key: &str) -> bool {
    if let Some(named) = At::parse(at) {
        let row = At::parse(&profile_key(key));
        return row.is_some_and(|r| r == named || r.addresses().any(|a| named.addresses().any(|n| n == a)));
    }
    // Numbers of rows are hexadecimal, in either case; names are not.
    let (table, rest) = at.split_once(' ').unwrap_or((at, ""));
    match table {
        "alarm" => names_alarm(rest, key),
        "homing" => key == at.split('.').next().unwrap_or(at),
        "bits" => rest.rsplit_once('.').is_some_and(|(name, bit)| key == format!("bits {name} {bit}")),
        "pdo" | "abort" => key.eq_ignore_ascii_case(&at.replace(':', " ")),
        _ => key == at.replace('=', " "),
    }
}

/// Whether `LS` or `LS 0x2f` is the alarm of the key `alarm LS 0x2F`.
fn names_alarm(named: &str, key: &str) -> bool {
    let Some(row) = key.strip_prefix("alarm ") else { return false };
    let number = |text: &str| u16::from_str_radix(text.strip_prefix("0x")?, 16).ok();
    let split = |text: &str| {
        let (display, last) = text.rsplit_once(' ')?;
        Some((display.to_owned(), number(last)?))
    };
    named == row
        || split(row).is_some_and(|(display, number)| {
            named == display || split(named).is_some_and(|pair| pair == (display, number))
        })
}

/// The fact that an erratum says is printed.
pub(super) fn printed<'f>(row: &Row<'f>, erratum: &Erratum) -> FactLine<'f> {
    let text = erratum.was.as_str();
    let value = text.strip_prefix('"').and_then(|t| t.strip_suffix('"')).unwrap_or(text);
    let value = as_facts_print(row, &erratum.field, value);
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

/// A value of an erratum as the facts print it: masks in hexadecimal, lists of words without brackets.
fn as_facts_print(row: &Row<'_>, field: &str, value: &str) -> String {
    let now = row.value(field);
    let digits = now.and_then(|v| v.strip_prefix("0x")).map(str::len);
    let digits = digits.or(match (row.table, field) {
        (Table::Alarms, "number") => Some(2),
        (Table::Alarms, "code" | "aux" | "al_status")
        | (Table::States | Table::Commands, "mask" | "value") => Some(4),
        _ => None,
    });
    if let Some((digits, n)) = digits.zip(value.parse::<i128>().ok()) {
        return format!("0x{n:0digits$X}");
    }
    if value.starts_with('[') && row.table != Table::Objects {
        return value.trim_matches(['[', ']']).replace('"', "").replace(", ", " ");
    }
    value.to_owned()
}

#[cfg(test)]
mod tests {
    use super::names;

    #[test]
    fn errata_name_rows_in_every_form() {
        for (at, key) in [
            ("607d:01", "object 607D:01"),
            ("3000:01..63", "object 3000:0A"),
            ("alarm LS", "alarm LS 0x2F"),
            ("alarm LS 0x2f", "alarm LS 0x2F"),
            ("homing 3.1", "homing 3"),
            ("bits controlword.8 mode 1", "bits controlword 8 mode 1"),
            ("enum keypad display=4", "enum keypad display 4"),
            ("pdo 1a00:1", "pdo 1A00 1"),
            ("mode 3", "mode 3"),
        ] {
            assert!(names(at, key), "{at}: {key}");
        }
        for (at, key) in [("alarm L", "alarm LS 0x2F"), ("alarm ls", "alarm LS 0x2F"), ("mode 3", "mode 30")]
        {
            assert!(!names(at, key), "{at}: {key}");
        }
    }
}
