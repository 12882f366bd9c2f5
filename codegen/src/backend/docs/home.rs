//! The first page: what this is, how to read it, and where to look for what.

use serde::Serialize;

use super::Page;
use super::book::Book;
use super::errata::counts;
use super::table::Table;
use crate::facts::{FactLine, Totals};

/// The page.
#[derive(Serialize)]
pub(super) struct Home {
    vendor: String,
    name: String,
    note: String,
    contents: String,
    manuals: String,
    doubts: Vec<String>,
    totals: String,
}

pub(super) fn page(book: &Book<'_>, pages: &[Page], lines: &[FactLine<'_>]) -> Home {
    let drive = &book.model.drive;
    let rows = pages.iter().map(|p| [book.link(&p.title, &p.file), p.about.clone()]);
    let doubts = counts(book).into_iter().map(|(anchor, title, n)| {
        book.link(&format!("{n} {}", title.to_lowercase()), &format!("errata.md#{anchor}"))
    });
    Home {
        vendor: book.text(&drive.vendor),
        name: book.text(&drive.name),
        note: drive.note.as_ref().map(|n| book.prose(n)).unwrap_or_default(),
        contents: Table::of(&["Page", "What is there"], rows).text(book.plain),
        manuals: manuals(book),
        doubts: doubts.collect(),
        totals: totals(lines),
    }
}

fn manuals(book: &Book<'_>) -> String {
    let rows = book.model.manuals.iter().map(|m| {
        let date = m.date.as_ref().map(|d| book.text(d)).unwrap_or_default();
        let lines = m.lines.to_string();
        [book.text(&m.id), book.text(&m.title), book.text(&m.version), date, lines, format!("`{}`", m.sha256)]
    });
    let head = ["Id", "Manual", "Version", "Date", "Lines", "SHA-256 of the text extract"];
    Table::of(&head, rows).text(book.plain)
}

/// `4439 stated, 12 inferred`
fn totals(lines: &[FactLine<'_>]) -> String {
    let totals = Totals::of(lines);
    let all = [
        (totals.stated, "stated"),
        (totals.inferred, "inferred"),
        (totals.standard, "standard"),
        (totals.assumed, "assumed"),
    ];
    all.iter().map(|(n, word)| format!("{n} {word}")).collect::<Vec<_>>().join(", ")
}
