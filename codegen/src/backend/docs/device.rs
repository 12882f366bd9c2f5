//! The device: identity, terminals, the EtherCAT slave controller, and the abort codes of SDO transfers.

use serde::Serialize;

use super::book::Book;
use super::table::Table;
use crate::backend::prose::shown;
use crate::model::{Abort, Address};

/// The page.
#[derive(Serialize)]
pub(super) struct Device {
    identity: String,
    terminals: String,
    terminal_texts: Vec<String>,
    managers: String,
    fmmus: String,
    aborts: String,
}

pub(super) fn page(book: &Book<'_>) -> Option<Device> {
    let model = book.model;
    let device = Device {
        identity: identity(book),
        terminals: terminals(book),
        terminal_texts: terminal_texts(book),
        managers: managers(book),
        fmmus: fmmus(book),
        aborts: aborts(book, &model.aborts),
    };
    let empty = [&device.identity, &device.terminals, &device.managers, &device.fmmus, &device.aborts]
        .iter()
        .all(|text| text.is_empty());
    (!empty).then_some(device)
}

/// What the drive answers when it is asked who it is.
pub(super) fn identity(book: &Book<'_>) -> String {
    let wanted = [
        (0x1000, 0),
        (0x1008, 0),
        (0x1009, 0),
        (0x100A, 0),
        (0x1018, 1),
        (0x1018, 2),
        (0x1018, 3),
        (0x1018, 4),
    ];
    let rows = wanted.into_iter().filter_map(|(index, sub)| {
        let (_, entry) = book.model.entry(Address::new(index, sub))?;
        let default = entry.default.as_ref()?;
        let value = match &default.value {
            crate::model::Value::Int(n) => shown(entry, *n),
            crate::model::Value::Text(text) => format!("\"{}\"", book.text(text)),
        };
        let value = book.marked(&value, &[&default.origin]);
        Some([book.address(entry.address), book.text(&entry.name.value), value, book.source(&default.origin)])
    });
    Table::of(&["Object", "Name", "Default", "Manual"], rows).text(book.plain)
}

fn terminals(book: &Book<'_>) -> String {
    let rows = book.model.terminals.iter().map(|t| {
        let bit = book.fact(t.bit.as_ref(), |b| format!("bit {b}"));
        let object = book.fact(t.object.as_ref(), |at| book.address(*at));
        let read = [object, bit].into_iter().filter(|p| !p.is_empty()).collect::<Vec<_>>().join(", ");
        [
            book.text(&t.name),
            book.marked(t.kind.value.word(), &[&t.kind.origin]),
            book.fact(t.pin.as_ref(), u8::to_string),
            read,
            book.fact(t.parameter.as_ref(), |p| book.prose(p)),
            t.text.as_ref().map(|text| book.prose(text)).unwrap_or_default(),
            book.source(&t.kind.origin),
        ]
    });
    let head = ["Terminal", "Kind", "Pin", "State in", "Function set by", "What it is for", "Manual"];
    Table::of(&head, rows).text(book.plain)
}

/// Notes, each once with its terminals.
fn terminal_texts(book: &Book<'_>) -> Vec<String> {
    let mut notes: Vec<(&String, Vec<String>)> = Vec::new();
    for terminal in &book.model.terminals {
        let (Some(note), name) = (&terminal.note, book.text(&terminal.name)) else { continue };
        match notes.iter_mut().find(|(known, _)| *known == note) {
            Some((_, names)) => names.push(name),
            None => notes.push((note, vec![name])),
        }
    }
    notes.into_iter().map(|(note, names)| format!("{}: {}", names.join(", "), book.prose(note))).collect()
}

fn managers(book: &Book<'_>) -> String {
    let rows = book.model.sync_managers.iter().map(|s| {
        let carries = book.marked(s.carries.value.word(), &[&s.carries.origin]);
        [s.number.to_string(), carries, book.source(&s.carries.origin)]
    });
    Table::of(&["SyncManager", "Carries", "Manual"], rows).text(book.plain)
}

fn fmmus(book: &Book<'_>) -> String {
    let rows = book.model.fmmus.iter().map(|f| {
        let maps = book.marked(f.maps.value.word(), &[&f.maps.origin]);
        [f.number.to_string(), maps, book.source(&f.maps.origin)]
    });
    Table::of(&["FMMU", "Maps", "Manual"], rows).text(book.plain)
}

fn aborts(book: &Book<'_>, aborts: &[Abort]) -> String {
    let rows = aborts.iter().map(|a| {
        let name = book.marked(&book.text(&a.name.value), &[&a.name.origin]);
        [format!("{:08X}h", a.code.value), name, book.source(&a.name.origin)]
    });
    Table::of(&["Abort code", "Means", "Manual"], rows).text(book.plain)
}
