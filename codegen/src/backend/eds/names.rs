//! `ParameterName`s: as printed, with the number behind where one print stands for several objects or entries.
//!
//! Programs find an object by its name, and of two equal names they find one.

use super::lower::is_variable;
use crate::backend::unique;
use crate::emit::escape;
use crate::model::{Model, Object};

/// Longest name: behind `ParameterName=`, a line has the 255 characters that CiA 306 allows.
const LONGEST: usize = 241;

/// A name as the sheet holds it, where no number has to stand behind it.
pub(super) fn text(name: &str) -> String {
    unique::capped(&escape::ini(name), LONGEST)
}

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

fn unique(names: &[(&str, String)]) -> Vec<String> {
    unique::unique(names, escape::ini, LONGEST)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(names: &[&str]) -> Vec<String> {
        let numbered: Vec<(&str, String)> = names.iter().zip(1..).map(|(n, i)| (*n, i.to_string())).collect();
        unique(&numbered)
    }

    #[test]
    fn equal_prints_get_numbers() {
        assert_eq!(of(&["Gain", "Speed", "Gain"]), ["Gain 1", "Speed", "Gain 3"]);
        assert_eq!(of(&["", "\u{202E}"]), ["1", "2"]);
    }

    #[test]
    fn what_becomes_equal_gets_numbers_too() {
        assert_eq!(of(&["a;b", "a,b"]), ["a,b 1", "a,b 2"]);
        assert_eq!(of(&["Gain", "Gain", "Gain 1"]), ["Gain 1 1", "Gain 2", "Gain 1"]);
    }

    #[test]
    fn names_end_where_a_line_does() {
        let long = "a#".repeat(100);
        let names = of(&[&long, &(long.clone() + "b"), &"x".repeat(241), &"y".repeat(242)]);
        assert_eq!(names.iter().map(String::len).collect::<Vec<_>>(), [241; 4]);
        assert!(names[0].ends_with(" 1") && names[1].ends_with(" 2"), "{names:?}");
    }
}
