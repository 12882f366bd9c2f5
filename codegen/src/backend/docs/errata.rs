//! Where the manual is wrong or contradicts itself, the least sure first.

use serde::Serialize;

use super::book::Book;
use super::table::Table;
use crate::backend::prose;
use crate::model::{Erratum, Sure};

/// The page.
#[derive(Serialize)]
pub(super) struct Errata {
    count: usize,
    groups: Vec<Group>,
}

#[derive(Serialize)]
struct Group {
    anchor: &'static str,
    title: &'static str,
    about: &'static str,
    overview: String,
    errata: Vec<ErratumView>,
}

/// An erratum for a reader.
#[derive(Serialize)]
pub(super) struct ErratumView {
    anchor: String,
    id: String,
    at: String,
    field: String,
    printed: String,
    used: String,
    other: String,
    why: String,
    sure: &'static str,
}

const DOUBT: [(Sure, &str, &str, &str); 3] = [
    (
        Sure::Low,
        "errata-doubtful",
        "Doubtful",
        "Only the device can settle these: look before you rely on one.",
    ),
    (Sure::Medium, "errata-likely", "Likely", "The likelier reading is used. Confirm it on the device."),
    (Sure::High, "errata-clear", "Clear", "Nothing else fits."),
];

/// How many errata there are of each degree of doubt: `(anchor, title, count)`.
pub(super) fn counts(book: &Book<'_>) -> Vec<(&'static str, &'static str, usize)> {
    let errata = book.model.errata.as_slice();
    let of = |sure: Sure| errata.iter().filter(|e| e.sure == sure).count();
    DOUBT
        .iter()
        .map(|(sure, anchor, title, _)| (*anchor, *title, of(*sure)))
        .filter(|(.., n)| *n > 0)
        .collect()
}

pub(super) fn page(book: &Book<'_>) -> Option<Errata> {
    let errata = book.model.errata.as_slice();
    let groups = DOUBT.iter().filter_map(|(sure, anchor, title, about)| {
        let all: Vec<&Erratum> = errata.iter().filter(|e| e.sure == *sure).collect();
        let rows = all.iter().map(|e| {
            let used = outcome(book, e);
            [book.erratum(e), place(book, e), book.code(&e.field), value(book, e, &e.was), used]
        });
        let overview = Table::of(&["Erratum", "Row", "Field", "Printed", "Then"], rows).text(book.plain);
        (!all.is_empty()).then(|| Group {
            anchor,
            title,
            about,
            overview,
            errata: all.iter().map(|e| view(book, e)).collect(),
        })
    });
    (!errata.is_empty()).then(|| Errata { count: errata.len(), groups: groups.collect() })
}

/// The row of an erratum: a link where it is an object or an alarm.
fn place(book: &Book<'_>, e: &Erratum) -> String {
    if let Some(at) = e.address {
        return book.address(at);
    }
    let index = u16::from_str_radix(&e.at, 16).ok().filter(|_| e.at.len() == 4);
    if let Some(object) = index.and_then(|i| book.model.object(i)) {
        return book.index(object);
    }
    let display = e.at.strip_prefix("alarm ");
    let alarm = display.and_then(|d| {
        book.model
            .alarms
            .iter()
            .find(|a| d == a.display || d == format!("{} 0x{:02X}", a.display, a.number.value))
    });
    alarm.map_or_else(|| book.prose(&e.at), |a| format!("alarm {}", book.alarm(a)))
}

/// A value of an erratum as the reader knows it from the row: codes of alarms and words of objects in hexadecimal.
pub(super) fn value(book: &Book<'_>, e: &Erratum, text: &str) -> String {
    let number = text.parse::<i128>().ok().filter(|n| *n >= 0);
    match (number, e.field.as_str(), e.address.and_then(|at| book.model.entry(at))) {
        (Some(n), "code" | "aux" | "al_status", None) => format!("{n:04X}h"),
        (Some(n), "number", None) => format!("{n:02X}h"),
        (Some(n), "min" | "max" | "default", Some((_, entry))) => prose::shown(entry, n),
        _ => book.text(text),
    }
}

/// What becomes of what is printed: `used 5`, `dropped` or `kept`.
pub(super) fn outcome(book: &Book<'_>, e: &Erratum) -> String {
    match &e.set {
        Some(set) => format!("used {}", value(book, e, set)),
        None => e.outcome(book.escape()),
    }
}

/// What to tell of an erratum.
pub(super) fn view(book: &Book<'_>, e: &Erratum) -> ErratumView {
    let used = match (&e.set, e.unset) {
        (Some(set), _) => value(book, e, set),
        (None, true) => "nothing: the printed value is dropped".to_owned(),
        (None, false) => "the printed value".to_owned(),
    };
    ErratumView {
        anchor: book.anchored(&book.erratum_anchor(e)),
        id: book.text(&e.id),
        at: place(book, e),
        field: book.code(&e.field),
        printed: format!("{} (in {})", value(book, e, &e.was), book.text(&e.seen.to_string())),
        used,
        other: e.by.as_ref().map(|by| book.text(&by.to_string())).unwrap_or_default(),
        why: book.prose(&e.why),
        sure: e.sure.word(),
    }
}
