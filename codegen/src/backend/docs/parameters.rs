//! Parameters by the number that the panel shows.

use serde::Serialize;

use super::book::Book;
use super::objects::values;
use super::table::Table;
use crate::model::{Effect, Entry};

/// The page.
#[derive(Serialize)]
pub(super) struct Parameters {
    table: String,
    restart: bool,
}

pub(super) fn page(book: &Book<'_>) -> Option<Parameters> {
    let mut entries: Vec<(&str, &Entry)> = book
        .model
        .entries
        .as_slice()
        .iter()
        .filter_map(|e| Some((e.parameter.as_ref()?.value.as_str(), e)))
        .collect();
    entries.sort_by_key(|(number, entry)| (natural(number), entry.address));
    let rows = entries.iter().map(|(number, entry)| {
        let [_, _, access, _, unit, range, default, manual] = values(book, entry);
        let effect = book.fact(entry.effect.as_ref(), |e| effect(*e).to_owned());
        let name = book.text(&entry.name.value);
        [book.text(number), book.address(entry.address), name, access, unit, range, default, effect, manual]
    });
    let head = [
        "Number",
        "Object",
        "Name",
        "Access",
        "Unit of a count",
        "Range",
        "Default",
        "Takes effect",
        "Manual",
    ];
    (!entries.is_empty()).then(|| Parameters {
        table: Table::of(&head, rows).text(book.plain),
        restart: entries
            .iter()
            .any(|(_, e)| e.effect.as_ref().is_some_and(|f| f.value == Effect::PowerCycle)),
    })
}

fn effect(effect: Effect) -> &'static str {
    match effect {
        Effect::AtOnce => "at once",
        Effect::AtStop => "at standstill",
        Effect::PowerCycle => "after power cycle",
    }
}

/// A number as people sort it: `P1.2` before `P1.10`.
fn natural(text: &str) -> Vec<(String, u64)> {
    let mut parts = Vec::new();
    let mut rest = text;
    while !rest.is_empty() {
        let word = rest.find(|c: char| c.is_ascii_digit()).unwrap_or(rest.len());
        let digits = rest[word..].find(|c: char| !c.is_ascii_digit()).map_or(rest.len(), |n| word + n);
        parts.push((rest[..word].to_owned(), rest[word..digits].parse().unwrap_or(u64::MAX)));
        rest = &rest[digits..];
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::natural;

    #[test]
    fn numbers_sort_as_people_do() {
        let mut numbers = ["P2.01", "P1.10", "P1.2", "P1.09", "Q"];
        numbers.sort_by_key(|n| natural(n));
        assert_eq!(numbers, ["P1.2", "P1.09", "P1.10", "P2.01", "Q"]);
    }
}
