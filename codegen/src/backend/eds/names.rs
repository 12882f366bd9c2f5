//! `ParameterName`s: as printed, or the name of generated code where one print stands for several objects or entries.
//!
//! Programs find an object by its name, and of two equal names they find one.

use std::collections::BTreeMap;

use super::lower::is_variable;
use crate::emit::escape;
use crate::model::{Entry, Model, Object};

/// The names of the objects of a drive, in their order.
pub(super) fn of_objects(model: &Model) -> Vec<String> {
    let objects = model.objects.as_slice().iter();
    let names = objects.filter_map(|object| Some((printed(object, model), entries(object, model).next()?)));
    unique(&names.collect::<Vec<_>>())
}

/// The names of the entries of an object, in their order.
pub(super) fn of_entries(object: &Object, model: &Model) -> Vec<String> {
    unique(&entries(object, model).map(|entry| (entry.name.value.as_str(), entry)).collect::<Vec<_>>())
}

fn entries<'a>(object: &'a Object, model: &'a Model) -> impl Iterator<Item = &'a Entry> {
    object.entries.iter().map(|id| &model.entries[*id])
}

/// A variable is called what its entry is called.
fn printed<'a>(object: &'a Object, model: &'a Model) -> &'a str {
    match entries(object, model).next() {
        Some(entry) if is_variable(object, model) => &entry.name.value,
        _ => object.name.value.original(),
    }
}

/// Names that stand once as they are; of the others, the handles of their entries. An address where no letter is left.
fn unique(names: &[(&str, &Entry)]) -> Vec<String> {
    let mut times: BTreeMap<&str, u32> = BTreeMap::new();
    for (name, _) in names {
        *times.entry(name).or_insert(0) += 1;
    }
    let name = |(name, entry): &(&str, &Entry)| {
        let once = times.get(name).is_none_or(|n| *n == 1);
        let text = escape::ini(if once { name } else { entry.handle.original() });
        if text.is_empty() { entry.address.to_string() } else { text }
    };
    names.iter().map(name).collect()
}
