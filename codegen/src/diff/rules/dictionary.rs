//! Rules of objects, tables of values and bits, and process data.

use super::{Case, Rule, added, removed, rule};
use crate::diff::Effect::{Axis, Breaking, Documentation, New};

#[rustfmt::skip]
pub(super) const OBJECTS: &[Rule] = &[
    rule("entry_removed", Breaking, "Its handle is gone: code that names it does not compile.", removed),
    rule("entry_added", New, "There was no such entry.", added),
    rule("handle_renamed", Breaking, "The name in code is another: code that names it does not compile.", |c| c.field_is(&["handle"])),
    rule("type_changed", Breaking, "The type is part of the handle, and the number of bytes may differ.", |c| c.field_is(&["type"])),
    rule("access_narrowed", Breaking, "What could be read or written no longer can: such calls do not compile.", access_narrowed),
    rule("access_widened", New, "More can be read or written than before.", |c| c.field_is(&["access"])),
    rule("mapping_removed", Breaking, "A PDO that carries it is refused, and such a layout does not compile.", mapping_narrowed),
    rule("mapping_added", New, "More PDOs can carry it than before.", |c| c.field_is(&["pdo"])),
    rule("unit_changed", Breaking, "Quantity and scale are part of the handle, and the same raw count means another amount.", |c| c.field_is(&["unit"])),
    rule("range_narrowed", Breaking, "Constants that were inside may be outside: such code does not compile, and the drive refuses them.", |c| c.writable() && narrowed(c)),
    rule("range_widened", Axis, "The drive takes values that it refused.", |c| c.writable() && c.field_is(&["min", "max", "allow"])),
    rule("range_of_a_read_value", Documentation, "It is only read: the range says what to expect.", |c| c.field_is(&["min", "max", "allow"])),
    rule("names_of_values_changed", Breaking, "The table of its values or bits is its type in code.", |c| c.field_is(&["values", "bits"])),
    rule("identity_changed", Breaking, "A master that checks the identity refuses the drive.", |c| c.field_is(&["default"]) && matches!(c.index(), 0x1000 | 0x1018)),
    rule("default_mapping_changed", Breaking, "The PDO as the drive ships has another content.", |c| c.field_is(&["default"]) && matches!(c.index(), 0x1600..=0x1BFF | 0x1C10..=0x1C2F)),
    rule("default_changed", Axis, "The drive starts with another value where nobody writes one.", |c| c.field_is(&["default"]) && c.writable()),
    rule("capability_changed", Axis, "The drive says that it can do something else.", |c| c.field_is(&["default"]) && c.any().is_some_and(|row| row.axis.is_some())),
    rule("default_of_a_read_value", Documentation, "It is only read: the default says what to expect.", |c| c.field_is(&["default"])),
    rule("effect_changed", Axis, "A written value takes effect at another time.", |c| c.field_is(&["effect"])),
    rule("wording", Documentation, "Texts only; the name in code is the same.", |c| c.field_is(&["name", "object name", "kind", "parameter", "text", "note", "deviation", "also"])),
];

#[rustfmt::skip]
pub(super) const ENUMS: &[Rule] = &[
    rule("value_removed", Breaking, "Its name is gone: code that uses it does not compile.", removed),
    rule("value_added", New, "There was no name for this value.", added),
    rule("value_renamed", Breaking, "The name in code is another: code that uses it does not compile.", |c| c.field_is(&["handle"])),
    rule("wording", Documentation, "Texts only; the name in code is the same.", |c| c.field_is(&["name", "text"])),
];

#[rustfmt::skip]
pub(super) const BITS: &[Rule] = &[
    rule("bit_removed", Breaking, "Its name is gone: code that uses it does not compile.", removed),
    rule("bit_added", New, "There was no name for this bit.", added),
    rule("bit_renamed", Breaking, "The name in code is another: code that uses it does not compile.", |c| c.field_is(&["handle"])),
    rule("bits_wider_or_narrower", Breaking, "The field holds another number of bits.", |c| c.field_is(&["width"])),
    rule("wording", Documentation, "Texts only; the name in code is the same.", |c| c.field_is(&["name", "text", "deviation"])),
];

#[rustfmt::skip]
pub(super) const PDOS: &[Rule] = &[
    rule("pdo_added", New, "There was no such PDO.", |c| added(c) && !c.parent_stays),
    rule("pdo_removed", Breaking, "Its layout is gone: code that uses it does not compile.", |c| removed(c) && !c.parent_stays),
    rule("layout_changed", Breaking, "Bytes stand elsewhere or are others: a master with the former layout reads and writes the wrong ones.", |_| true),
];

fn access_narrowed(case: &Case<'_>) -> bool {
    let (old, new) = case.texts();
    let reads = |word: &str| word != "wo";
    let writes = |word: &str| word.contains('w');
    case.field_is(&["access"]) && (reads(old) && !reads(new) || writes(old) && !writes(new))
}

fn mapping_narrowed(case: &Case<'_>) -> bool {
    let (old, new) = case.texts();
    case.field_is(&["pdo"]) && ["rx", "tx"].iter().any(|way| old.contains(way) && !new.contains(way))
}

/// Whether a value that was allowed no longer is.
fn narrowed(case: &Case<'_>) -> bool {
    let (old, new) = case.numbers();
    match case.field {
        Some("min") => new.is_some_and(|new| old.is_none_or(|old| new > old)),
        Some("max") => new.is_some_and(|new| old.is_none_or(|old| new < old)),
        Some("allow") => match case.said {
            (_, None) => false,
            (None, Some(_)) => true,
            (Some(old), Some(new)) => {
                let allowed =
                    |list: &serde_json::Value, item| list.as_array().is_some_and(|l| l.contains(item));
                old.value.as_array().is_none_or(|items| !items.iter().all(|item| allowed(&new.value, item)))
            }
        },
        _ => false,
    }
}
