//! Values of single objects: the table `values`, and what every written value must be.

use std::collections::BTreeMap;

use super::code;
use crate::diag::{Diagnostic, Sink};
use crate::limits;
use crate::model::{Address, Entry, Model, Value};
use crate::rows::tables::SettingRow;
use crate::source::{Sp, Span};

/// A value that the drive takes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Setting {
    pub(super) address: Address,
    pub(super) value: i128,
    /// How many bytes it has over SDO.
    pub(super) bytes: u8,
    pub(super) span: Span,
}

/// Values of single objects, in the order of rows, each address once.
#[derive(Default, Debug)]
pub(super) struct Settings {
    pub(super) list: Vec<Setting>,
    places: BTreeMap<Address, Span>,
}

/// Objects whose writing does something once, instead of setting something.
const COMMANDS: &[(u16, &str)] = &[
    (0x1003, "it clears the list of errors"),
    (0x1010, "it stores parameters"),
    (0x1011, "it restores parameters"),
    (0x6040, "it commands the drive, and a PDO or the user's program does that"),
];

/// Adds the rows of `values` that are right; the others are reported.
pub(super) fn add_values(rows: &[SettingRow], model: &Model, settings: &mut Settings, sink: &mut Sink) {
    for row in rows {
        let at = row.at;
        if let Some(first) = settings.places.insert(at.value, at.span) {
            settings.places.insert(at.value, first);
            twice(at, first, sink);
            continue;
        }
        let Some(entry) = object(at, model, sink).filter(|entry| is_setting(entry, at.span, sink)) else {
            continue;
        };
        let value = counts(entry, &row.value, sink);
        settings.list.extend(value.and_then(|value| taken(entry, Sp::new(value, row.value.span), sink)));
    }
}

fn twice(at: Sp<Address>, first: Span, sink: &mut Sink) {
    sink.push(
        Diagnostic::new(super::profile_code::DUPLICATE_ROW, at.span, format!("{} is set twice", at.value))
            .label("again here")
            .related(first, "first here")
            .why("the later value would win, and nobody could see that it does")
            .help("keep one of them"),
    );
}

/// The entry at an address of the configuration.
pub(super) fn object<'m>(at: Sp<Address>, model: &'m Model, sink: &mut Sink) -> Option<&'m Entry> {
    let found = model.entry(at.value).map(|(_, entry)| entry);
    if found.is_none() {
        let Address { index, .. } = at.value;
        let help = model.object(index).map_or_else(
            || format!("correct the address; `{index:04X}` is no index of the drive"),
            |object| {
                let subs = object.entries.iter().map(|id| format!("{:02X}", model.entries[*id].address.sub));
                let subs: Vec<String> = subs.take(limits::SUGGESTIONS).collect();
                format!("correct the address; `{index:04X}` has the sub-indexes {}", subs.join(", "))
            },
        );
        sink.push(
            Diagnostic::new(code::NO_OBJECT, at.span, format!("the drive has no object {}", at.value))
                .why("the drive would answer with abort 0602 0000 or 0609 0011")
                .help(help),
        );
    }
    found
}

/// Whether an entry is set by a value of its own.
fn is_setting(entry: &Entry, span: Span, sink: &mut Sink) -> bool {
    let index = entry.address.index;
    let command = COMMANDS.iter().find(|(object, _)| *object == index).map(|(_, why)| *why);
    let (why, help) = if let Some(why) = command {
        (why, "remove it; whoever operates the drive writes it when it is wanted")
    } else if matches!(index, 0x1400..=0x15FF | 0x1800..=0x19FF) {
        ("a PDO is changed in steps, of which this is one", "write a row of `communication`")
    } else if matches!(index, 0x1600..=0x17FF | 0x1A00..=0x1BFF) {
        ("a mapping is changed in steps, of which this is one", "write rows of `pdo`")
    } else if entry.address.sub == 0xFF {
        ("sub-index FFh describes the object itself", "correct the address")
    } else if entry.ty.value.range().is_none() {
        ("readers of a DCF disagree on how texts, reals and times are written", "write it with another tool")
    } else {
        return true;
    };
    let text = format!("{} ({}) is no setting", entry.address, entry.name.value);
    sink.push(
        Diagnostic::new(code::NO_SETTING, span, text)
            .related(entry.name.span(), "the object")
            .why(why)
            .help(help),
    );
    false
}

/// The raw count that a row states.
fn counts(entry: &Entry, value: &Sp<Value>, sink: &mut Sink) -> Option<i128> {
    let text = match &value.value {
        Value::Int(n) => return Some(*n),
        Value::Text(text) => text,
    };
    let unit = entry.unit.as_ref();
    let says = match unit.map(|unit| unit.value.counts(text)) {
        Some(Ok(counts)) => return Some(counts),
        Some(Err(error)) => format!("is {error}"),
        None => "is a quantity, and nobody states a unit".to_owned(),
    };
    let help = match unit {
        Some(unit) => format!("write a raw count, or a whole number of counts of `{}`", unit.value),
        None => "write the raw count, without quotes".to_owned(),
    };
    let text = format!("{}: `{text}` {says}", entry.address);
    let mut finding = Diagnostic::new(code::NO_COUNT, value.span, text)
        .why("the drive holds whole counts, and nothing is rounded in silence")
        .help(help);
    if let Some(unit) = unit {
        finding = finding.related(unit.span(), "its unit");
    }
    sink.push(finding);
    None
}

/// The setting, if the drive takes the value.
pub(super) fn taken(entry: &Entry, value: Sp<i128>, sink: &mut Sink) -> Option<Setting> {
    let (address, access) = (entry.address, entry.access.value);
    if !access.writes() {
        let text = format!("{address} ({}) is {}", entry.name.value, access.word());
        let finding =
            Diagnostic::new(code::READ_ONLY, value.span, text).related(entry.access.span(), "its access");
        sink.push(finding.why("the drive would answer with abort 0601 0002").help("remove the row"));
        return None;
    }
    let refusal = entry.refusals(value.value).next();
    if let Some((origin, why)) = refusal {
        let text = format!("{} is no value of {address} ({}), {why}", value.value, entry.name.value);
        let finding = Diagnostic::new(code::NOT_TAKEN, value.span, text).related(origin.span, "the object");
        sink.push(finding.why("the drive would refuse it with abort 0609 0030").help("correct the value"));
        return None;
    }
    let bytes = entry.ty.value.bits().map(|bits| bits.div_ceil(8))?;
    Some(Setting { address, value: value.value, bytes, span: value.span })
}
