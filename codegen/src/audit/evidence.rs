//! What counts as evidence: which lines belong to a row, and which show a value.

use std::borrow::Cow;

use super::page::{Line, Page};
use super::words::{self, Row, Words};
use super::{behaviour, dictionary, number};
use crate::facts::{FactLine, Table};
use crate::model::Erratum;

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
        Table::Rules => matches!(field, "text" | "on" | "when"),
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
