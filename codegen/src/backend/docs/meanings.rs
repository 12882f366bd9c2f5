//! Named values and named bits.

use serde::Serialize;

use super::book::Book;
use super::table::Table;
use crate::backend::prose::{capital, shown};
use crate::model::{Address, BitField, BitsId, Entry, EnumId};
use crate::name::Name;

/// A table of named values or bits.
#[derive(Serialize)]
pub(super) struct Meaning {
    anchor: String,
    title: String,
    table: String,
    items: Vec<String>,
}

impl Meaning {
    fn elsewhere(title: &str, place: &str) -> Self {
        let title = format!("{title}: {place}");
        Self { anchor: String::new(), title, table: String::new(), items: Vec::new() }
    }
}

/// Tables that entries of an object use. One that another object used before is named, and not told again.
pub(super) fn of(book: &Book<'_>, runs: &[Vec<&Entry>]) -> Vec<Meaning> {
    let mut found: Vec<(String, Meaning)> = Vec::new();
    for entry in runs.iter().map(|run| run[0]) {
        let values = entry.values.as_ref().map(|v| values(book, entry, v.value));
        let bits = entry.bits.as_ref().map(|b| bits(book, entry, b.value));
        for (key, meaning) in values.into_iter().chain(bits) {
            if found.iter().all(|(known, _)| *known != key) {
                found.push((key, meaning));
            }
        }
    }
    found.into_iter().map(|(_, meaning)| meaning).collect()
}

fn values(book: &Book<'_>, entry: &Entry, id: EnumId) -> (String, Meaning) {
    let table = &book.model.enums[id];
    let key = format!("values-{}", table.name.words().join("-"));
    let title = title(book, &table.name, "values");
    if let Some(elsewhere) = elsewhere(book, entry, book.first_of_enum(id)) {
        return (key, Meaning::elsewhere(&title, &elsewhere));
    }
    let rows = table.values.iter().map(|v| {
        let text = v.text.as_ref().map(|t| book.prose(t)).unwrap_or_default();
        let name = book.marked(&book.text(&v.printed), &[&v.name.origin]);
        [shown(entry, v.value), name, text, book.source(&v.name.origin)]
    });
    let table = Table::of(&["Value", "Name", "Meaning", "Manual"], rows).text(book.plain);
    (key.clone(), Meaning { anchor: book.anchored(&key), title, table, items: Vec::new() })
}

fn bits(book: &Book<'_>, entry: &Entry, id: BitsId) -> (String, Meaning) {
    let table = &book.model.bits[id];
    let key = format!("bits-{}", table.name.words().join("-"));
    let title = title(book, &table.name, "bits");
    if let Some(elsewhere) = elsewhere(book, entry, book.first_of_bits(id)) {
        return (key, Meaning::elsewhere(&title, &elsewhere));
    }
    let fields: Vec<&BitField> = table.fields.iter().collect();
    let (table, items) = fields_table(book, &fields);
    (key.clone(), Meaning { anchor: book.anchored(&key), title, table, items })
}

/// `Mode of operation: values`, as a heading.
fn title(book: &Book<'_>, name: &Name, what: &str) -> String {
    book.text(&format!("{}: {what}", capital(name.original())))
}

/// Where the table is told, if not here. A terminal shows one object, and all of it.
fn elsewhere(book: &Book<'_>, entry: &Entry, first: Option<Address>) -> Option<String> {
    let first = first.filter(|f| f.index != entry.address.index && !book.plain)?;
    Some(format!("see {}", book.address(first)))
}

/// Bits as a table, and where they deviate from the standard below it.
pub(super) fn fields_table(book: &Book<'_>, fields: &[&BitField]) -> (String, Vec<String>) {
    let rows = fields.iter().map(|field| {
        let mode = field.mode.map_or_else(String::new, |m| mode(book, m));
        let text = field.text.as_ref().map(|t| book.prose(t)).unwrap_or_default();
        let name = book.marked(&book.text(&field.printed), &[&field.name.origin]);
        [range(field), mode, name, text, book.source(&field.name.origin)]
    });
    let table = Table::of(&["Bit", "In mode", "Name", "Meaning", "Manual"], rows).text(book.plain);
    let deviates = fields.iter().filter_map(|field| {
        let deviation = book.prose(field.deviation.as_ref()?);
        let mode = field.mode.map_or_else(String::new, |m| format!(" in mode {m}"));
        Some(format!("Bit {}{mode} deviates from the standard: {deviation}", range(field)))
    });
    (table, deviates.collect())
}

/// `4`, or `4 to 6`.
fn range(field: &BitField) -> String {
    match field.end() {
        end if field.width > 1 => format!("{} to {}", field.bit, end - 1),
        _ => field.bit.to_string(),
    }
}

/// A mode by its number, as a link where the drive has it.
fn mode(book: &Book<'_>, number: i8) -> String {
    match book.model.modes.iter().find(|m| m.number == number) {
        Some(mode) => {
            book.link(&number.to_string(), &format!("modes.md#{}", super::modes::anchor(mode.number)))
        }
        None => number.to_string(),
    }
}
