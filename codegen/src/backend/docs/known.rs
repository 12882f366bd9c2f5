//! What the manual does not say itself: values that follow by a rule, come from a base, or are assumed.

use serde::Serialize;

use super::book::Book;
use super::table::Table;
use crate::backend::{eds, esi};
use crate::facts::{FactLine, Totals};
use crate::model::{Address, Class};

/// The page.
#[derive(Serialize)]
pub(super) struct Known {
    totals: String,
    inferred: String,
    by_errata: usize,
    assumed: String,
    in_eds: Vec<String>,
    /// Empty for a drive that is not on EtherCAT.
    in_esi: Vec<String>,
    standard: String,
}

/// Most places that a row names.
const PLACES: usize = 8;

pub(super) fn page<'m>(book: &Book<'m>, lines: &[FactLine<'m>]) -> Known {
    let of_erratum =
        |line: &FactLine<'_>| line.erratum.is_some() && matches!(line.class, Some(Class::Inferred(_)));
    let inferred = grouped(book, lines.iter().filter(|l| !of_erratum(l)), |class| match class {
        Class::Inferred(rule) => Some(rule),
        _ => None,
    });
    let assumed = grouped(book, lines.iter(), |class| match class {
        Class::Assumed(reason) => Some(reason),
        _ => None,
    });
    let standard = grouped(book, lines.iter(), |class| match class {
        Class::Standard(base) => Some(base),
        _ => None,
    });
    Known {
        totals: totals(book, &Totals::of(lines)),
        inferred: Table::of(&["Values", "Rule", "Where"], inferred).text(book.plain),
        by_errata: lines.iter().filter(|l| of_erratum(l)).count(),
        assumed: Table::of(&["Values", "Reason", "Where"], assumed).text(book.plain),
        in_eds: eds::assumptions(book.model).iter().map(|text| book.text(text)).collect(),
        in_esi: esi::assumptions(book.model).iter().map(|text| book.text(text)).collect(),
        standard: Table::of(&["Values", "Base", "Where"], standard).text(book.plain),
    }
}

fn totals(book: &Book<'_>, totals: &Totals) -> String {
    let rows = [
        ("stated", "", "the manual says it", totals.stated),
        (
            "inferred",
            "ⁱ",
            "it follows from the manual by a named rule, or an erratum sets it",
            totals.inferred,
        ),
        ("standard", "ˢ", "the base of CiA or ETG says it, and the manual is silent", totals.standard),
        (
            "assumed",
            "ᵃ",
            "a format demands it and nobody says it; what only device files need is below",
            totals.assumed,
        ),
    ];
    let rows = rows.map(|(word, mark, means, n)| [word, mark, means, &n.to_string()].map(str::to_owned));
    Table::of(&["Word", "Mark", "Means", "Values"], rows).text(book.plain)
}

/// Lines by what `of` takes from their class, in the order of their first ones.
fn grouped<'l, 'm: 'l>(
    book: &Book<'m>,
    lines: impl Iterator<Item = &'l FactLine<'m>>,
    of: impl Fn(&'m Class) -> Option<&'m String>,
) -> Vec<[String; 3]> {
    let mut groups: Vec<(&str, Vec<&FactLine<'_>>)> = Vec::new();
    let mut places = std::collections::BTreeMap::new();
    for line in lines {
        let Some(text) = line.class.and_then(&of) else { continue };
        let place = *places.entry(text.as_str()).or_insert_with(|| {
            groups.push((text, Vec::new()));
            groups.len() - 1
        });
        groups[place].1.push(line);
    }
    groups.sort_by_key(|(_, lines)| std::cmp::Reverse(lines.len()));
    groups
        .into_iter()
        .map(|(text, lines)| [lines.len().to_string(), book.prose(text), places_of(book, &lines)])
        .collect()
}

/// `1000h kind, 1001h kind and 90 more`
fn places_of(book: &Book<'_>, lines: &[&FactLine<'_>]) -> String {
    let place = |line: &&FactLine<'_>| format!("{} {}", row(book, &line.key), line.field);
    let mut texts: Vec<String> = lines.iter().take(PLACES).map(place).collect();
    if lines.len() > PLACES {
        texts.push(format!("and {} more in `map.txt`", lines.len() - PLACES));
    }
    texts.join(", ")
}

/// The key of a row, as a link where it is an object.
fn row(book: &Book<'_>, key: &str) -> String {
    if let Some(number) = key.strip_prefix("homing ").and_then(|k| k.split('.').next()?.parse().ok()) {
        return book.link(&book.text(key), &format!("homing.md#{}", super::homing::anchor(number)));
    }
    let Some(at) = key.strip_prefix("object ") else { return book.text(key) };
    let hex = |text: &str| u16::from_str_radix(text, 16).ok();
    let (index, sub) = at.split_once(':').map_or((hex(at), None), |(index, sub)| (hex(index), hex(sub)));
    match (index, sub.and_then(|sub| u8::try_from(sub).ok())) {
        (Some(index), Some(sub)) => book.address(Address::new(index, sub)),
        (Some(index), None) => book.model.object(index).map_or_else(|| book.text(at), |o| book.index(o)),
        _ => book.text(at),
    }
}
