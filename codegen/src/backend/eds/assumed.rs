//! What the sheet holds because CiA 306 demands it, although the manual does not state it: one sentence for each, with the
//! reason. The comments of the file and the README of the crate say the same.

use std::collections::BTreeMap;

use super::loss::list;
use super::lower::Sheet;
use super::write::granularity;
use crate::model::{Address, Class, Entry, Fact, Model};

const TIMES: &str = "Creation and modification carry the date of the last change of the facts, and 12:00AM for a time of \
    day that nobody knows.";
const ZERO: &str = "BaudRate, SimpleBootUp, DynamicChannelsSupported, GroupMessaging, LSS_Supported and Dummy keys are 0, \
    since nobody states them and 0 claims nothing.";
const PDOS: &str =
    "NrOfRXPDO and NrOfTXPDO count the mapping objects, since nobody states how many PDOs there are.";
const COUNTED: &str = "DefaultValue is the highest sub-index, since nobody states a default:";
const UNMAPPED: &str = "PDOMapping is 0, since nobody states whether a PDO can carry them:";

/// The sentences.
pub(super) fn sentences(model: &Model, sheet: &Sheet) -> Vec<String> {
    let mut text = vec![TIMES.to_owned(), ZERO.to_owned(), PDOS.to_owned()];
    text.push(match granularity(sheet) {
        0 => "Granularity is 0, since no mapping can be written.".to_owned(),
        n => format!("Granularity is {n}, since mappings can be written, and nobody states how finely."),
    });
    let keys = ["VendorNumber", "ProductNumber", "RevisionNumber"];
    let unknown = keys.into_iter().zip(model.identity()).filter(|(_, value)| value.is_none());
    text.extend(unknown.map(|(key, _)| format!("{key} is 0, since object 1018h has no such default.")));
    text.extend([(COUNTED, &sheet.counted), (UNMAPPED, &sheet.unmapped)].into_iter().filter_map(named));
    text.extend(of_entries(model));
    text
}

fn named((says, addresses): (&str, &Vec<Address>)) -> Option<String> {
    (!addresses.is_empty()).then(|| format!("{says} {}", list(addresses)))
}

/// Assumed values of entries, by field and reason.
fn of_entries(model: &Model) -> Vec<String> {
    let mut reasons: BTreeMap<(&str, &str), Vec<Address>> = BTreeMap::new();
    for entry in model.entries.as_slice() {
        for (field, class) in classes(entry) {
            if let Class::Assumed(reason) = class {
                reasons.entry((field, reason)).or_default().push(entry.address);
            }
        }
    }
    let line = |((field, reason), at): (&(&str, &str), &Vec<Address>)| {
        format!("Assumed {field} ({reason}): {}", list(at))
    };
    reasons.iter().map(line).collect()
}

/// What the file holds of an entry, and who says it.
fn classes(entry: &Entry) -> impl Iterator<Item = (&'static str, &Class)> {
    fn of<'a, T>(field: &'static str, fact: Option<&'a Fact<T>>) -> Option<(&'static str, &'a Class)> {
        fact.map(|fact| (field, &fact.origin.class))
    }
    let all = [
        of("name", Some(&entry.name)),
        of("type", Some(&entry.ty)),
        of("access", Some(&entry.access)),
        of("mapping", entry.mapping.as_ref()),
        of("lowest value", entry.min.as_ref()),
        of("highest value", entry.max.as_ref()),
        of("default", entry.default.as_ref()),
    ];
    all.into_iter().flatten()
}
