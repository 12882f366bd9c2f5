//! Values of entries that the profile assumes, in sentences for the files that carry them.

use std::collections::BTreeMap;

use super::losses::list;
use crate::model::{Address, Class, Entry, Fact, Model};

/// Assumed values of entries, by field and reason.
pub(super) fn of_entries(model: &Model) -> Vec<String> {
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
