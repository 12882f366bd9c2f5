//! Process data as the drive ships: the place of every byte.

use std::fmt::Write;

use serde::Serialize;

use super::book::Book;
use super::table::Table;
use crate::model::{Direction, Pdo};

/// The page.
#[derive(Serialize)]
pub(super) struct ProcessData {
    limits: Vec<String>,
    pdos: Vec<PdoView>,
}

/// A PDO for a reader.
#[derive(Serialize)]
struct PdoView {
    anchor: String,
    index: String,
    direction: &'static str,
    size: String,
    ruler: String,
    table: String,
}

pub(super) fn page(book: &Book<'_>) -> Option<ProcessData> {
    let model = book.model;
    (!model.pdos.is_empty()).then(|| ProcessData {
        limits: limits(book),
        pdos: model.pdos.iter().map(|p| view(book, p)).collect(),
    })
}

fn limits(book: &Book<'_>) -> Vec<String> {
    let limits = &book.model.drive.limits;
    let said = |what: &str, value: String| (!value.is_empty()).then(|| format!("{what}: {value}"));
    [
        said("Most entries of one PDO", book.fact(limits.pdo_entries.as_ref(), u8::to_string)),
        said("Most bytes of one PDO", book.fact(limits.pdo_bytes.as_ref(), u16::to_string)),
        said(
            "Most PDOs of one direction that are active together",
            book.fact(limits.pdos_per_direction.as_ref(), u8::to_string),
        ),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn view(book: &Book<'_>, pdo: &Pdo) -> PdoView {
    let (bytes, rest) = (pdo.bits() / 8, pdo.bits() % 8);
    PdoView {
        anchor: book.anchored(&format!("pdo-{:04x}", pdo.index)),
        index: format!("{:04X}h", pdo.index),
        direction: if pdo.direction == Direction::Rx {
            "RxPDO, master to drive"
        } else {
            "TxPDO, drive to master"
        },
        size: if rest == 0 { format!("{bytes} bytes") } else { format!("{bytes} bytes and {rest} bits") },
        ruler: ruler(book, pdo).unwrap_or_default(),
        table: table(book, pdo),
    }
}

fn table(book: &Book<'_>, pdo: &Pdo) -> String {
    let mut bit = 0_u32;
    let rows = pdo.entries.iter().map(|mapped| {
        let entry = &book.model.entries[mapped.entry];
        let (first, bits) = (bit, u32::from(mapped.bits.value));
        bit += bits;
        [
            place(first, bits),
            book.marked(&bits.to_string(), &[&mapped.bits.origin]),
            book.address(entry.address),
            book.text(&entry.name.value),
            entry.ty.value.word().to_owned(),
            entry.unit.as_ref().map(|u| book.text(&u.value.text)).unwrap_or_default(),
            book.source(&mapped.origin),
        ]
    });
    Table::of(&["Byte", "Bits", "Object", "Name", "Type", "Unit of a count", "Manual"], rows).text(book.plain)
}

/// `2 to 5`, or `6, bits 4 to 5` of what is no whole byte.
fn place(first: u32, bits: u32) -> String {
    let span = |a: u32, b: u32| if a == b { a.to_string() } else { format!("{a} to {b}") };
    let last = first + bits.max(1) - 1;
    if first.is_multiple_of(8) && bits.is_multiple_of(8) {
        return span(first / 8, last / 8);
    }
    if first / 8 == last / 8 {
        return format!("{}, bit {}", first / 8, span(first % 8, last % 8));
    }
    format!("{}, bit {}, to {}, bit {}", first / 8, first % 8, last / 8, last % 8)
}

/// The bytes as a picture of text; none where an entry is no whole number of bytes.
fn ruler(book: &Book<'_>, pdo: &Pdo) -> Option<String> {
    let whole = pdo.entries.iter().all(|m| m.bits.value.is_multiple_of(8) && m.bits.value > 0);
    if !whole || pdo.entries.is_empty() || pdo.bits() > 64 * 8 {
        return None;
    }
    let (mut bytes, mut names) = (String::from("byte  |"), String::from("object|"));
    let mut byte = 0_u32;
    for mapped in &pdo.entries {
        let count = u32::from(mapped.bits.value) / 8;
        let cells = (byte..byte + count).fold(String::new(), |cells, n| cells + &format!(" {n:>2}"));
        let at = book.model.entries[mapped.entry].address;
        let name = if at.sub == 0 { format!("{:04X}h", at.index) } else { at.to_string() };
        let width = cells.len().max(name.len() + 1);
        // Writing to a String cannot fail.
        let _ = write!(bytes, "{cells:<width$} |");
        let _ = write!(names, " {name:<0$} |", width - 1);
        byte += count;
    }
    Some(format!("{bytes}\n{names}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_of_bytes_and_bits() {
        assert_eq!(place(16, 32), "2 to 5");
        assert_eq!(place(8, 8), "1");
        assert_eq!(place(9, 1), "1, bit 1");
        assert_eq!(place(12, 3), "1, bit 4 to 6");
        assert_eq!(place(12, 8), "1, bit 4, to 2, bit 3");
    }
}
