//! What the sheet holds because CiA 306 demands it, although the manual does not state it: one sentence for each, with the
//! reason. The comments of the file and the README of the crate say the same.

use super::lower::Sheet;
use super::write::granularity;
use crate::backend::assumed;
use crate::backend::losses::list;
use crate::model::{Address, Model};

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
    text.extend(assumed::of_entries(model));
    text
}

fn named((says, addresses): (&str, &Vec<Address>)) -> Option<String> {
    (!addresses.is_empty()).then(|| format!("{says} {}", list(addresses)))
}
