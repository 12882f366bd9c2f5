//! `ParameterName`s: as printed, with the number behind where one print stands for several objects or entries.
//!
//! Programs find an object by its name, and of two equal names they find one.

use std::collections::BTreeMap;

use super::lower::is_variable;
use crate::emit::escape;
use crate::limits;
use crate::model::{Model, Object};

/// The names of the objects of a drive, in their order: `Gain`, or `Gain 2001h`.
pub(super) fn of_objects(model: &Model) -> Vec<String> {
    let objects = model.objects.as_slice().iter();
    unique(&objects.map(|o| (printed(o, model), format!("{:04X}h", o.index))).collect::<Vec<_>>())
}

/// The names of the entries of an object, in their order: `Gain`, or `Gain 12` at sub-index 0Ch.
pub(super) fn of_entries(object: &Object, model: &Model) -> Vec<String> {
    let entries = object.entries.iter().map(|id| &model.entries[*id]);
    unique(&entries.map(|e| (e.name.value.as_str(), e.address.sub.to_string())).collect::<Vec<_>>())
}

/// A variable is called what its entry is called.
fn printed<'a>(object: &'a Object, model: &'a Model) -> &'a str {
    match object.entries.first() {
        Some(id) if is_variable(object, model) => &model.entries[*id].name.value,
        _ => object.name.value.original(),
    }
}

/// Escapes names; one that stands there twice, or of which nothing is left, gets its number.
fn unique(names: &[(&str, String)]) -> Vec<String> {
    let texts: Vec<String> = names.iter().map(|(name, _)| short(name)).collect();
    let mut times: BTreeMap<&str, u32> = BTreeMap::new();
    for text in &texts {
        *times.entry(text).or_insert(0) += 1;
    }
    let numbered = |(text, (_, number)): (&String, &(&str, String))| {
        let once = times.get(text.as_str()) == Some(&1) && !text.is_empty();
        if once { text.clone() } else { escape::ini(&format!("{text} {number}")) }
    };
    texts.iter().zip(names).map(numbered).collect()
}

/// Escaping can make a name longer than a line may be.
fn short(name: &str) -> String {
    escape::ini(name).chars().take(limits::NAME_BYTES).collect::<String>().trim_end().to_owned()
}
