//! `table.rs`: the drive as data.

use std::fmt::Write;

use super::lower::{Lowered, access, meaning_of, quantity};
use super::number::{grouped, hex};
use super::values::literal;
use super::{behaviour, items};
use crate::emit::escape::rust_str;
use crate::model::{Address, BitField, BitsDef, Direction, Entry, Fact, Id, Model, Pdo, Unit, Value};

pub(super) fn body(lowered: &Lowered<'_>) -> String {
    let model = lowered.model;
    let mut out = String::from("use super::alarms::ALARMS;\nuse drivewright_runtime::prelude::*;\n");
    if !model.entries.is_empty() {
        out.push_str("use drivewright_runtime::row::*;\n");
    }
    let units = model.units();
    out.push_str(&items::table("Units.", "UNITS", "UnitDesc", units.iter().map(|u| unit(u))));
    let rows = model.entries.iter().map(|(_, e)| object(e, &units));
    out.push_str(&items::table(ENTRIES, "OBJECTS", "ObjectDesc", rows));
    let rows = model.entries.iter().filter_map(|(_, e)| allowed(e));
    out.push_str(&items::table(
        "Entries that take listed values only, by address.",
        "ALLOWED",
        "Allowed",
        rows,
    ));
    let rows = model.entries.iter().filter_map(|(_, e)| text(e));
    out.push_str(&items::table("Entries whose default is a text, by address.", "TEXTS", "TextDefault", rows));
    let rows = lowered.enums.iter().map(|e| format!("super::enums::{}::DESC", e.name));
    out.push_str(&items::table("Tables of named values.", "ENUMS", "EnumDesc", rows));
    let rows = model.bits.iter().map(|(_, b)| bit_table(b));
    out.push_str(&items::table("Tables of named bits.", "BIT_FIELDS", "BitFieldDesc", rows));
    let rows = model
        .pdos
        .iter()
        .zip(&lowered.layouts)
        .map(|(p, l)| pdo(p, (!l.fields.is_empty()).then_some(&l.name), model));
    out.push_str(&items::table("Process data as the drive ships, by index.", "PDOS", "PdoDesc", rows));
    out.push_str(&whole(model));
    out
}

const ENTRIES: &str = "Entries of the dictionary, by address: index, sub-index, type, access, mapping, name, unit; then lowest and highest raw value, default.";

fn unit(unit: &Unit) -> String {
    let kind = quantity(unit.quantity);
    format!(
        "UnitDesc::new(\"{}\", QuantityKind::{kind}, {}, {})",
        rust_str(&unit.text),
        grouped(unit.num.into()),
        grouped(unit.den.into())
    )
}

pub(super) fn address(at: Address) -> String {
    format!("Address::new(0x{:04X}, 0x{:02X})", at.index, at.sub)
}

/// One call with everything that nearly every entry states; the rest are builders behind it.
fn object(entry: &Entry, units: &[&Unit]) -> String {
    let limit = |f: &Option<Fact<i128>>| f.as_ref().map(|f| pattern(entry, f.value));
    let (min, max) = (limit(&entry.min), limit(&entry.max));
    let default = entry.default_int().map(|d| pattern(entry, d.value));
    let meaning = meaning(entry);
    let (function, numbers, alone) = match (min, max, default) {
        (Some(min), Some(max), Some(default)) => ("full", format!(", {min}, {max}, {default}"), None),
        (Some(min), Some(max), None) => ("limited", format!(", {min}, {max}"), None),
        (min, max, default) => {
            let least = min.map(|n| format!(".at_least({n})"));
            let alone = least.or_else(|| max.map(|n| format!(".at_most({n})")));
            let numbers = default.map(|n| format!(", {n}"));
            (if numbers.is_some() { "preset" } else { "entry" }, numbers.unwrap_or_default(), alone)
        }
    };
    let alone = alone.unwrap_or_default();
    format!("{function}({}{numbers}){alone}{meaning}", stated(entry, units))
}

/// What every row begins with: where it is, type, access, mapping, name, unit.
fn stated(entry: &Entry, units: &[&Unit]) -> String {
    let place = entry.unit.as_ref().and_then(|u| units.iter().position(|v| **v == u.value));
    format!(
        "0x{:04X}, 0x{:02X}, {}, {}, {}, \"{}\", {}",
        entry.address.index,
        entry.address.sub,
        entry.ty.value.cia301_name(),
        access(entry).to_ascii_uppercase(),
        mapping(entry),
        rust_str(&entry.name.value),
        place.map_or_else(|| "NO_UNIT".to_owned(), |place| place.to_string())
    )
}

fn mapping(entry: &Entry) -> &'static str {
    match entry.mapping.as_ref().map(|m| (m.value.rx, m.value.tx)) {
        None => "NOT_STATED",
        Some((false, false)) => "UNMAPPED",
        Some((true, false)) => "RX",
        Some((false, true)) => "TX",
        Some((true, true)) => "RX_TX",
    }
}

fn meaning(entry: &Entry) -> String {
    match meaning_of(entry) {
        (Some(values), _) => format!(".values({})", values.place()),
        (None, Some(bits)) => format!(".bits({})", bits.place()),
        (None, None) => String::new(),
    }
}

/// A number as the tables hold it: values of UNSIGNED64 above 63 bits as their bit pattern.
fn pattern(entry: &Entry, n: i128) -> String {
    let wrapped = if n > i128::from(i64::MAX) { n - (1 << 64) } else { n };
    literal(entry, wrapped)
}

fn allowed(entry: &Entry) -> Option<String> {
    let list: Vec<String> = entry.allow.as_ref()?.value.iter().map(|n| pattern(entry, *n)).collect();
    Some(format!("Allowed::new({}, &[{}])", address(entry.address), list.join(", ")))
}

fn text(entry: &Entry) -> Option<String> {
    match &entry.default.as_ref()?.value {
        Value::Text(text) => {
            Some(format!("TextDefault::new({}, \"{}\")", address(entry.address), rust_str(text)))
        }
        Value::Int(_) => None,
    }
}

fn bit_table(table: &BitsDef) -> String {
    let bit = |f: &BitField| {
        let mode = f.mode.map_or_else(String::new, |m| format!(".in_mode({m})"));
        format!("        BitDesc::new({}, {}, \"{}\"){mode},\n", f.bit, f.width, rust_str(&f.printed))
    };
    let bits: String = table.fields.iter().map(bit).collect();
    format!("BitFieldDesc::new(\"{}\", &[\n{bits}    ])", rust_str(table.name.original()))
}

fn pdo(pdo: &Pdo, layout: Option<&String>, model: &Model) -> String {
    let direction = if pdo.direction == Direction::Rx { "Rx" } else { "Tx" };
    let mapping = layout.map_or_else(|| mapped(pdo, model), |name| format!("&super::pdo::{name}::MAPPING"));
    let mut row =
        format!("PdoDesc::new({}, Direction::{direction}, {mapping})", address(Address::new(pdo.index, 0)));
    if let Some(most) = &model.drive.limits.pdo_entries {
        let _ = write!(row, ".with_max_entries({})", most.value);
    }
    if let Some(most) = &model.drive.limits.pdo_bytes {
        let _ = write!(row, ".with_max_bytes({})", grouped(most.value.into()));
    }
    row
}

/// The mapping of a PDO without a typed layout.
fn mapped(pdo: &Pdo, model: &Model) -> String {
    let entry = |e: &crate::model::PdoEntry| {
        format!("MapEntry::new({}, {})", address(model.entries[e.entry].address), e.bits.value)
    };
    let entries: Vec<String> = pdo.entries.iter().map(entry).collect();
    format!("&[{}]", entries.join(", "))
}

/// The static that holds all tables together, and the test that they fit.
fn whole(model: &Model) -> String {
    let mut out =
        String::from("\n/// The whole drive.\npub static MODEL: DriveModel<'static> = DriveModel::new(\n");
    out.push_str(&identity(model));
    out.push_str(",\n)");
    for table in TABLES {
        let _ = write!(out, "\n.with_{}(&{table})", table.to_ascii_lowercase());
    }
    if !model.homing.is_empty() {
        out.push_str("\n.with_homing(&super::homing::HOMING)");
    }
    for table in behaviour::names(model) {
        let _ = write!(out, "\n.with_{}(&super::behaviour::{table})", table.to_ascii_lowercase());
    }
    out + ";\n" + TEST
}

fn identity(model: &Model) -> String {
    let drive = &model.drive;
    let [id, vendor, name] = [&drive.id, &drive.vendor, &drive.name].map(|text| rust_str(text));
    let mut out = format!("    Identity::new(\"{id}\", \"{vendor}\", \"{name}\")");
    for (sub, method) in [(1, "with_vendor_id"), (2, "with_product_code"), (3, "with_revision")] {
        let number = model.default_int(Address::new(0x1018, sub)).filter(|n| u32::try_from(*n).is_ok());
        if let Some(number) = number {
            let _ = write!(out, "\n        .{method}({})", hex(number, 8));
        }
    }
    out
}

/// The tables of the model, as the statics are called.
const TABLES: [&str; 8] = ["OBJECTS", "UNITS", "ALLOWED", "TEXTS", "ENUMS", "BIT_FIELDS", "PDOS", "ALARMS"];

const TEST: &str = "
#[cfg(test)]
mod tests {
    #[test]
    fn the_tables_fit_together() {
        assert_eq!(super::MODEL.check(), Ok(()));
    }
}
";
