//! Modes of operation: the objects that each lists, and what the bits of controlword and statusword mean in it.

use serde::Serialize;

use super::book::Book;
use super::meanings::fields_table;
use super::objects::values;
use super::table::Table;
use crate::model::{Address, BitField, Mode};

/// The page.
#[derive(Serialize)]
pub(super) struct Modes {
    overview: String,
    modes: Vec<ModeView>,
}

/// A mode for a reader.
#[derive(Serialize)]
pub(super) struct ModeView {
    anchor: String,
    number: i8,
    name: String,
    text: String,
    manual: String,
    controlword: String,
    statusword: String,
    items: Vec<String>,
    objects: String,
    objects_manual: String,
}

/// The anchor of a mode.
pub(super) fn anchor(number: i8) -> String {
    let sign = if number < 0 { "n" } else { "" };
    format!("mode-{sign}{}", number.unsigned_abs())
}

pub(super) fn page(book: &Book<'_>) -> Option<Modes> {
    let modes = &book.model.modes;
    let rows = modes.iter().map(|m| {
        let objects = m.objects.as_ref().map(|o| o.value.len().to_string()).unwrap_or_default();
        let name = book.link(&book.name(&m.name.value), &format!("#{}", anchor(m.number)));
        [m.number.to_string(), book.marked(&name, &[&m.name.origin]), objects, book.source(&m.name.origin)]
    });
    (!modes.is_empty()).then(|| Modes {
        overview: Table::of(&["6060h", "Mode", "Objects listed", "Manual"], rows).text(book.plain),
        modes: modes.iter().map(|m| view(book, m)).collect(),
    })
}

/// What to tell of a mode.
pub(super) fn view(book: &Book<'_>, mode: &Mode) -> ModeView {
    let (controlword, mut items) = bits(book, 0x6040, mode.number);
    let (statusword, deviations) = bits(book, 0x6041, mode.number);
    items.extend(deviations);
    let objects = mode.objects.as_ref();
    let rows = objects.iter().flat_map(|o| &o.value).map(|at| object(book, *at));
    ModeView {
        anchor: book.anchored(&anchor(mode.number)),
        number: mode.number,
        name: book.name(&mode.name.value),
        text: mode.text.as_ref().map(|t| book.prose(t)).unwrap_or_default(),
        manual: book.source(&mode.name.origin),
        controlword,
        statusword,
        items,
        objects: Table::of(&["Object", "Name", "Access", "PDO", "Unit of a count", "Range"], rows)
            .text(book.plain),
        objects_manual: objects.map(|o| book.source(&o.origin)).unwrap_or_default(),
    }
}

/// Bits of the word at `index` that hold in every mode, and those of the mode; and where they deviate from the standard.
fn bits(book: &Book<'_>, index: u16, mode: i8) -> (String, Vec<String>) {
    let table = book.word(index).and_then(|e| e.bits.as_ref()).map(|b| &book.model.bits[b.value]);
    let here = |f: &&BitField| f.mode.is_none_or(|m| m == mode);
    let mut fields: Vec<&BitField> = table.iter().flat_map(|t| &t.fields).filter(here).collect();
    fields.sort_by_key(|f| f.bit);
    fields_table(book, &fields)
}

fn object(book: &Book<'_>, at: Address) -> [String; 6] {
    let Some((_, entry)) = book.model.entry(at) else {
        return [book.address(at), String::new(), String::new(), String::new(), String::new(), String::new()];
    };
    let [name, _, access, pdo, unit, range, ..] = values(book, entry);
    [book.address(at), name, access, pdo, unit, range]
}
