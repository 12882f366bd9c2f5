//! What the dictionary of an ESI says: objects with types, limits, units and access.

use std::collections::BTreeSet;

use super::loss::{Loss, Losses};
use super::types::{Body, DataType, FIRST, Flags, Item, Named, Types};
use super::units::{self, Own};
use super::value::{self, Values};
use crate::backend::unique;
use crate::emit::escape;
use crate::model::{Access, Address, Entry, Model, Object, ObjectKind};

/// The lowered dictionary.
#[derive(Default, Debug)]
pub(super) struct Dictionary {
    pub(super) types: Types,
    pub(super) objects: Vec<ObjectDef>,
    /// Units that the file itself names.
    pub(super) units: BTreeSet<Own>,
    /// What of the model the file does not hold.
    pub(super) losses: Losses,
}

/// An object.
#[derive(Debug)]
pub(super) struct ObjectDef {
    pub(super) index: u16,
    pub(super) name: String,
    pub(super) ty: Named,
    pub(super) info: Info,
    pub(super) flags: Flags,
}

/// Limits, defaults and units of an object.
#[derive(Debug)]
pub(super) enum Info {
    /// Of its one value.
    One(Values),
    /// Of each entry, by the name that its type gives it.
    Each(Vec<(String, Values)>),
}

/// Lowers a drive.
pub(super) fn lower(model: &Model) -> Dictionary {
    let mut out = Dictionary::default();
    for object in model.objects.as_slice() {
        if object.index < 0x1000 {
            out.losses.add(Loss::IndexOfDataTypes, Address::new(object.index, 0), object.name.span());
            continue;
        }
        let entries = entries(object, model, &mut out.losses);
        let lowered = match entries.as_slice() {
            [] => continue,
            [entry] if entry.address.sub == 0 && object.kind.value == ObjectKind::Var => {
                variable(entry, model, &mut out)
            }
            entries => composed(object, entries, model, &mut out),
        };
        out.objects.push(lowered);
    }
    unlisted_pdos(model, &mut out.losses);
    out
}

/// The entries that an ESI can hold.
fn entries<'m>(object: &Object, model: &'m Model, losses: &mut Losses) -> Vec<&'m Entry> {
    let mut entries: Vec<&Entry> = object.entries.iter().map(|id| &model.entries[*id]).collect();
    if let Some(last) = entries.pop_if(|entry| entry.address.sub == 0xFF) {
        losses.add(Loss::SubIndexFf, last.address, last.name.span());
    }
    entries
}

/// Mapping objects that map nothing by default have no PDO in the file.
fn unlisted_pdos(model: &Model, losses: &mut Losses) {
    let maps =
        model.objects.as_slice().iter().filter(|o| matches!(o.index, 0x1600..=0x17FF | 0x1A00..=0x1BFF));
    for object in maps.filter(|o| model.pdos.iter().all(|pdo| pdo.index != o.index)) {
        losses.add(Loss::EmptyPdo, Address::new(object.index, 0), object.name.span());
    }
}

fn variable(entry: &Entry, model: &Model, out: &mut Dictionary) -> ObjectDef {
    let values = values(entry, out);
    ObjectDef {
        index: entry.address.index,
        name: entry.name.value.clone(),
        ty: type_of(entry, model, out),
        info: Info::One(values),
        flags: Flags::of(entry),
    }
}

fn type_of(entry: &Entry, model: &Model, out: &mut Dictionary) -> Named {
    let losses = &mut out.losses;
    out.types.of(entry, model, &mut |loss| losses.add(loss, entry.address, entry.name.span()))
}

fn values(entry: &Entry, out: &mut Dictionary) -> Values {
    let mut values = value::of(entry, &mut |loss| out.losses.add(loss, entry.address, entry.name.span()));
    match entry.unit.as_ref().map(|unit| units::code(&unit.value)) {
        None => {}
        Some(None) => out.losses.add(Loss::NoUnit, entry.address, entry.name.span()),
        Some(Some((code, own))) => {
            values.unit = Some(code);
            out.units.extend(own);
        }
    }
    values
}

/// An array or record.
fn composed(object: &Object, entries: &[&Entry], model: &Model, out: &mut Dictionary) -> ObjectDef {
    let name = format!("DT{:04X}", object.index);
    let types: Vec<Named> = entries.iter().map(|entry| type_of(entry, model, out)).collect();
    let (ty, names) = if is_uniform(object, entries) {
        array(&name, entries, &types, out)
    } else {
        record(&name, entries, types, out)
    };
    let infos = entries.iter().zip(names).map(|(entry, name)| (name, values(entry, out))).collect();
    ObjectDef {
        index: object.index,
        name: object.name.value.original().to_owned(),
        ty,
        info: Info::Each(infos),
        flags: Flags { access: joint_access(entries), mapping: None },
    }
}

/// Whether the entries differ in number only, so that an array describes them: it has one name and access for all.
fn is_uniform(object: &Object, entries: &[&Entry]) -> bool {
    let [count, first, rest @ ..] = entries else { return false };
    let same = |entry: &&Entry| {
        let kind = |e: &Entry| {
            (
                e.ty.value,
                e.access.value,
                e.mapping.as_ref().map(|m| m.value),
                e.values.as_ref().map(|v| v.value),
            )
        };
        kind(entry) == kind(first) && entry.name.value == first.name.value
    };
    object.kind.value == ObjectKind::Array
        && first.ty.value.bits().is_some()
        && count.ty.value.bits() == Some(8)
        && (0..).zip(entries).all(|(sub, entry): (u8, _)| entry.address.sub == sub)
        && rest.iter().all(same)
}

/// `DT1C12ARR` for the elements, and `DT1C12` of sub-index 0 and them. Masters call the elements by their numbers.
fn array(name: &str, entries: &[&Entry], types: &[Named], out: &mut Dictionary) -> (Named, Vec<String>) {
    let names: Vec<String> =
        entries.iter().map(|entry| format!("SubIndex {:03}", entry.address.sub)).collect();
    let ([count, first, ..], [count_ty, element, rest @ ..]) = (entries, types) else {
        return (Named { name: name.to_owned(), bits: 0 }, names);
    };
    let elements = rest.len() + 1;
    let bits = element.bits * u32::try_from(elements).unwrap_or(u32::MAX);
    let elements = out.types.add(DataType {
        name: format!("{name}ARR"),
        base: Some(element.name.clone()),
        bits,
        body: Body::Array(elements),
    });
    let items = vec![
        Item {
            sub: Some(0),
            name: names[0].clone(),
            ty: count_ty.clone(),
            offset: 0,
            flags: Flags::of(count),
        },
        Item { sub: None, name: "Elements".to_owned(), ty: elements, offset: FIRST, flags: Flags::of(first) },
    ];
    let bits = whole_bytes(FIRST + bits);
    (out.types.add(DataType { name: name.to_owned(), base: None, bits, body: Body::Record(items) }), names)
}

/// Entries one behind the other; those behind sub-index 0 start at bit 16.
fn record(name: &str, entries: &[&Entry], types: Vec<Named>, out: &mut Dictionary) -> (Named, Vec<String>) {
    let numbered: Vec<(&str, String)> =
        entries.iter().map(|e| (e.name.value.as_str(), e.address.sub.to_string())).collect();
    let names = unique::unique(&numbered, escape::one_line, usize::MAX);
    let mut end = 0;
    let mut items = Vec::with_capacity(entries.len());
    for ((entry, ty), name) in entries.iter().zip(types).zip(&names) {
        // Bits follow bits; whole bytes start at one.
        let next = if ty.bits == 1 { end } else { whole_bytes(end) };
        let offset = if entry.address.sub == 0 { 0 } else { next.max(FIRST) };
        end = offset + ty.bits;
        let flags = Flags::of(entry);
        items.push(Item { sub: Some(entry.address.sub), name: name.clone(), ty, offset, flags });
    }
    let ty =
        DataType { name: name.to_owned(), base: None, bits: whole_bytes(end), body: Body::Record(items) };
    (out.types.add(ty), names)
}

fn whole_bytes(bits: u32) -> u32 {
    bits.next_multiple_of(8)
}

/// An object can be written if one of its entries can.
fn joint_access(entries: &[&Entry]) -> &'static str {
    let any = |accesses: &[Access]| entries.iter().any(|e| accesses.contains(&e.access.value));
    let reads = any(&[Access::Ro, Access::Const, Access::Rw]);
    match (reads, any(&[Access::Rw, Access::Wo])) {
        (true, true) => "rw",
        (false, true) => "wo",
        _ => "ro",
    }
}
