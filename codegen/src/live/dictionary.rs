//! The dictionary: units, entries, value tables, bit tables and process data.

use drivewright_runtime::DataType;
use drivewright_runtime::access::Access;
use drivewright_runtime::bit_field::{BitDesc, BitFieldDesc};
use drivewright_runtime::mapping::{Direction, Mapping};
use drivewright_runtime::model::{Allowed, DriveModel, ObjectDesc, PdoDesc, TextDefault, UnitDesc};
use drivewright_runtime::pdo::MapEntry;
use drivewright_runtime::wire_enum::{EnumDesc, EnumValue};

use super::Arena;
use crate::model::{self, BitField, BitsDef, Entry, EnumDef, Id, Model, Pdo, Unit, Value};

pub(super) fn tables<'a>(profile: &'a Model, arena: &'a Arena, model: &DriveModel<'a>) -> DriveModel<'a> {
    let (units, entries) = (profile.units(), profile.entries.as_slice());
    model
        .with_units(arena.slice(units.iter().map(|u| unit(u))))
        .with_objects(arena.slice(entries.iter().map(|e| object(e, &units))))
        .with_allowed(arena.slice(entries.iter().filter_map(|e| allowed(e, arena))))
        .with_texts(arena.slice(entries.iter().filter_map(text)))
        .with_enums(arena.slice(profile.enums.as_slice().iter().map(|e| values(e, arena))))
        .with_bit_fields(arena.slice(profile.bits.as_slice().iter().map(|b| bits(b, arena))))
        .with_pdos(arena.slice(profile.pdos.iter().map(|p| pdo(p, profile, arena))))
}

fn unit(unit: &Unit) -> UnitDesc<'_> {
    UnitDesc::new(&unit.text, unit.quantity.into(), unit.num, unit.den)
}

fn object<'a>(entry: &'a Entry, units: &[&Unit]) -> ObjectDesc<'a> {
    let ty = DataType(u8::try_from(entry.ty.value.cia301_code()).unwrap_or_default());
    let (min, max) =
        (entry.min.as_ref().map(|f| pattern(f.value)), entry.max.as_ref().map(|f| pattern(f.value)));
    let mut row = ObjectDesc::new(entry.address.into(), ty, access(entry), mapping(entry), &entry.name.value)
        .range(min.unwrap_or(i64::MIN), max.unwrap_or(i64::MAX));
    if let Some(default) = entry.default_int() {
        row = row.default_int(pattern(default.value));
    }
    let place = entry.unit.as_ref().and_then(|u| units.iter().position(|v| **v == u.value));
    if let Some(place) = place.and_then(|place| u8::try_from(place).ok()) {
        row = row.unit(place);
    }
    let number = |id: usize| u16::try_from(id).unwrap_or(u16::MAX);
    match (&entry.values, &entry.bits) {
        (Some(values), _) => row.values(number(values.value.place())),
        (None, Some(bits)) => row.bits(number(bits.value.place())),
        (None, None) => row,
    }
}

/// A number as the tables hold it: those of UNSIGNED64 above 63 bits as their bit pattern.
#[allow(clippy::cast_possible_truncation, reason = "the low 64 bits are the pattern")]
fn pattern(n: i128) -> i64 {
    n as i64
}

fn access(entry: &Entry) -> Access {
    match entry.access.value {
        model::Access::Ro => Access::Ro,
        model::Access::Rw => Access::Rw,
        model::Access::Wo => Access::Wo,
        model::Access::Const => Access::Const,
    }
}

fn mapping(entry: &Entry) -> Mapping {
    match entry.mapping.as_ref().map(|m| (m.value.rx, m.value.tx)) {
        None => Mapping::NotStated,
        Some((false, false)) => Mapping::Unmapped,
        Some((true, false)) => Mapping::Rx,
        Some((false, true)) => Mapping::Tx,
        Some((true, true)) => Mapping::RxTx,
    }
}

fn allowed<'a>(entry: &Entry, arena: &'a Arena) -> Option<Allowed<'a>> {
    let values = entry.allow.as_ref()?.value.iter().map(|n| pattern(*n));
    Some(Allowed::new(entry.address.into(), arena.slice(values)))
}

fn text(entry: &Entry) -> Option<TextDefault<'_>> {
    match &entry.default.as_ref()?.value {
        Value::Text(text) => Some(TextDefault::new(entry.address.into(), text)),
        Value::Int(_) => None,
    }
}

fn values<'a>(table: &'a EnumDef, arena: &'a Arena) -> EnumDesc<'a> {
    let rows = table.values.iter().map(|v| EnumValue::new(pattern(v.value), &v.printed));
    EnumDesc::new(table.name.original(), arena.slice(rows))
}

fn bits<'a>(table: &'a BitsDef, arena: &'a Arena) -> BitFieldDesc<'a> {
    BitFieldDesc::new(table.name.original(), arena.slice(table.fields.iter().map(bit)))
}

fn bit(field: &BitField) -> BitDesc<'_> {
    let row = BitDesc::new(field.bit, field.width, &field.printed);
    field.mode.map_or(row, |mode| row.in_mode(mode))
}

fn pdo<'a>(pdo: &Pdo, profile: &Model, arena: &'a Arena) -> PdoDesc<'a> {
    let entry = |e: &model::PdoEntry| MapEntry::new(profile.entries[e.entry].address.into(), e.bits.value);
    let direction = if pdo.direction == model::Direction::Rx { Direction::Rx } else { Direction::Tx };
    let address = model::Address::new(pdo.index, 0).into();
    let row = PdoDesc::new(address, direction, arena.slice(pdo.entries.iter().map(entry)));
    let limits = &profile.drive.limits;
    let row = limits.pdo_entries.as_ref().map_or(row, |most| row.with_max_entries(most.value));
    limits.pdo_bytes.as_ref().map_or(row, |most| row.with_max_bytes(most.value))
}
