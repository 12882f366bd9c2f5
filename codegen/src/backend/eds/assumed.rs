//! What the sheet holds because CiA 306 demands it, although the manual does not state it: one sentence for each, with the
//! reason. The comments of the file and the README of the crate say the same.

use super::lower::{FIRST, highest, is_variable};
use super::value;
use crate::backend::assumed;
use crate::backend::losses::list;
use crate::model::{Access, Address, Entry, Model, Object, Type};

const TIMES: &str = "Creation and modification carry the date of the last change of the facts, and 12:00AM for a time of \
    day that nobody knows.";
const ZERO: &str = "BaudRate, SimpleBootUp, DynamicChannelsSupported, GroupMessaging, LSS_Supported and Dummy keys are 0, \
    since nobody states them and 0 claims nothing.";
const PDOS: &str =
    "NrOfRXPDO and NrOfTXPDO count the mapping objects, since nobody states how many PDOs there are.";
const COUNTED: &str = "DefaultValue is the highest sub-index, since nobody states a default:";
const UNMAPPED: &str = "PDOMapping is 0, since nobody states whether a PDO can carry them:";

/// The sentences.
pub(super) fn sentences(model: &Model) -> Vec<String> {
    let mut text = vec![TIMES.to_owned(), ZERO.to_owned(), PDOS.to_owned()];
    text.push(match granularity(model) {
        0 => "Granularity is 0, since no mapping can be written.".to_owned(),
        n => format!("Granularity is {n}, since mappings can be written, and nobody states how finely."),
    });
    let keys = ["VendorNumber", "ProductNumber", "RevisionNumber"];
    let unknown = keys.into_iter().zip(model.identity()).filter(|(_, value)| value.is_none());
    text.extend(unknown.map(|(key, _)| format!("{key} is 0, since object 1018h has no such default.")));
    text.extend([(COUNTED, counted(model)), (UNMAPPED, unmapped(model))].into_iter().filter_map(named));
    text.extend(assumed::of_entries(model));
    text
}

fn named((says, addresses): (&str, Vec<Address>)) -> Option<String> {
    (!addresses.is_empty()).then(|| format!("{says} {}", list(&addresses)))
}

/// How finely process data can be mapped: by bytes where a mapping can be written, else 0 for not at all.
pub(super) fn granularity(model: &Model) -> u8 {
    let maps =
        |at: Address| matches!(at.index, 0x1600..=0x17FF | 0x1A00..=0x1BFF) && matches!(at.sub, 0x01..=0xFE);
    let writable = |entry: &Entry| maps(entry.address) && entry.access.value == Access::Rw;
    if model.entries.as_slice().iter().any(writable) { 8 } else { 0 }
}

fn objects(model: &Model) -> impl Iterator<Item = &Object> {
    model.objects.as_slice().iter().filter(|object| object.index >= FIRST)
}

/// Entries at sub-index 0 that state the highest sub-index because nobody states a default.
fn counted(model: &Model) -> Vec<Address> {
    let count = |object: &Object| {
        let (_, entry) = model.entry(Address::new(object.index, 0))?;
        let highest = highest(object, model)?.into();
        let range = value::limits(entry, &mut |_| {});
        let silent = entry.default.is_none() && model.pdos.iter().all(|pdo| pdo.index != object.index);
        let fits = silent && value::default(entry, Some(highest), range, &mut |_| {}).is_some();
        fits.then_some(entry.address)
    };
    objects(model).filter(|object| !is_variable(object, model)).filter_map(count).collect()
}

/// Entries whose `PDOMapping` is 0 because nobody says whether they can be mapped.
fn unmapped(model: &Model) -> Vec<Address> {
    let entries = objects(model).flat_map(|object| &object.entries).map(|id| &model.entries[*id]);
    let silent = entries.filter(|e| e.mapping.is_none() && e.ty.value != Type::Domain);
    silent.map(|e| e.address).filter(|at| at.sub != 0xFF).collect()
}
