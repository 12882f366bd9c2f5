//! What the sheet says: the model without everything that an EDS has no key for.

use std::collections::BTreeMap;

use super::loss::{Loss, Losses};
use super::names;
use super::value::{self, Default, Range};
use crate::emit::escape;
use crate::model::{Access, Address, Entry, Model, Object, ObjectKind, Type};
use crate::source::Span;

/// The lowered drive.
#[derive(Debug)]
pub(super) struct Sheet {
    /// Objects, ascending by index.
    pub(super) objects: Vec<Section>,
    /// What of the model the sheet does not hold.
    pub(super) losses: Losses,
    /// Entries at sub-index 0 whose default is another number than the highest sub-index: how much is mapped or assigned.
    pub(super) mapped: Vec<Address>,
}

/// An object.
#[derive(Debug)]
pub(super) struct Section {
    pub(super) index: u16,
    pub(super) name: String,
    pub(super) kind: ObjectKind,
    /// Its entries; exactly one for a variable.
    pub(super) entries: Vec<Keys>,
}

/// An entry.
#[derive(Debug)]
pub(super) struct Keys {
    pub(super) sub: u8,
    pub(super) name: String,
    pub(super) ty: Type,
    pub(super) access: Access,
    pub(super) range: Range,
    pub(super) default: Option<Default>,
    /// Whether a PDO can carry it; `None` for a DOMAIN, which has no such key.
    pub(super) mapped: Option<bool>,
}

/// Longest text of the drive: with the longest key, a line stays below 255 characters.
const TEXT: usize = 240;
/// The indexes below it are those of data types.
pub(super) const FIRST: u16 = 0x1000;
const MANDATORY: [u16; 3] = [0x1000, 0x1001, 0x1018];

/// Lowers a drive.
pub(super) fn lower(model: &Model) -> Sheet {
    let mut sheet = Sheet { objects: Vec::new(), losses: Losses::default(), mapped: Vec::new() };
    let maps = mapped_entries(model);
    for (object, name) in model.objects.as_slice().iter().zip(names::of_objects(model)) {
        if object.index < FIRST {
            sheet.losses.add(Loss::IndexOfDataTypes, Address::new(object.index, 0), object.name.span());
            continue;
        }
        let section = section(object, name, model, &maps, &mut sheet);
        sheet.objects.push(section);
    }
    missing(model, &mut sheet.losses);
    for text in [&model.drive.vendor, &model.drive.name] {
        if drive_text(text) != *text {
            sheet.losses.add_of_drive(Loss::DriveTextChanged);
        }
    }
    sheet
}

/// Whether an object is one section without sub-sections.
pub(super) fn is_variable(object: &Object, model: &Model) -> bool {
    let single = matches!(object.entries.as_slice(), [id] if model.entries[*id].address.sub == 0);
    single && object.kind.value == ObjectKind::Var
}

/// A text of the drive as the sheet holds it.
pub(super) fn drive_text(text: &str) -> String {
    escape::ini(text).chars().take(TEXT).collect::<String>().trim_end().to_owned()
}

/// The defaults that follow from the default process data: what each mapping entry holds, and how many there are.
fn mapped_entries(model: &Model) -> BTreeMap<Address, i128> {
    let mut maps = BTreeMap::new();
    for pdo in &model.pdos {
        maps.insert(Address::new(pdo.index, 0), pdo.entries.len() as i128);
        for mapped in &pdo.entries {
            let Address { index, sub } = model.entries[mapped.entry].address;
            let value = i128::from(index) << 16 | i128::from(sub) << 8 | i128::from(mapped.bits.value);
            maps.insert(Address::new(pdo.index, mapped.position), value);
        }
    }
    maps
}

fn section(
    object: &Object,
    name: String,
    model: &Model,
    maps: &BTreeMap<Address, i128>,
    sheet: &mut Sheet,
) -> Section {
    let entries = || object.entries.iter().map(|id| &model.entries[*id]);
    let variable = is_variable(object, model);
    let here = Address::new(object.index, 0);
    let kind = match object.kind.value {
        ObjectKind::Var if !variable => {
            sheet.losses.add(Loss::VarWithSubIndexes, here, object.kind.span());
            ObjectKind::Record
        }
        kind => kind,
    };
    if !variable && entries().all(|e| e.address.sub != 0) {
        sheet.losses.add(Loss::NoSubIndex0, here, object.name.span());
    }
    let printed = object.name.value.original();
    if !variable && names::text(printed) != printed {
        sheet.losses.add(Loss::NameChanged, here, object.name.span());
    }
    let highest = highest(object, model);
    let names = names::of_entries(object, model);
    let mut section = Section { index: object.index, name, kind, entries: Vec::new() };
    for (entry, name) in entries().zip(names) {
        if entry.address.sub == 0xFF {
            sheet.losses.add(Loss::SubIndexFf, entry.address, entry.name.span());
            continue;
        }
        let count = highest.filter(|_| entry.address.sub == 0 && !variable);
        section.entries.push(keys(entry, name, count, maps.get(&entry.address), sheet));
    }
    section
}

/// The highest sub-index of an object; `FFh` is none of the object's own.
pub(super) fn highest(object: &Object, model: &Model) -> Option<u8> {
    object.entries.iter().map(|id| model.entries[*id].address.sub).filter(|sub| *sub != 0xFF).max()
}

/// `count` is the highest sub-index at sub-index 0 of an array or record; `map` what the default process data says.
fn keys(entry: &Entry, name: String, count: Option<u8>, map: Option<&i128>, sheet: &mut Sheet) -> Keys {
    let address = entry.address;
    let mut lose = |loss| sheet.losses.add(loss, address, entry.name.span());
    if names::text(&entry.name.value) != entry.name.value {
        lose(Loss::NameChanged);
    }
    let range = value::limits(entry, &mut lose);
    let default = value::default(entry, map.copied().or(count.map(i128::from)), range, &mut lose);
    let mappable = entry.mapping.as_ref().map(|m| m.value.any());
    let domain = entry.ty.value == Type::Domain;
    if domain && mappable == Some(true) {
        lose(Loss::MappedDomain);
    }
    if count.is_some_and(|n| default.is_some_and(|d| d != Default::Int(n.into()))) {
        sheet.mapped.push(address);
    }
    Keys {
        sub: address.sub,
        name,
        ty: entry.ty.value,
        access: entry.access.value,
        range,
        default,
        mapped: (!domain).then(|| mappable.unwrap_or(false)),
    }
}

fn missing(model: &Model, losses: &mut Losses) {
    for index in MANDATORY.into_iter().filter(|index| model.object(*index).is_none()) {
        losses.add(Loss::MandatoryMissing, Address::new(index, 0), Span::nowhere());
    }
}

/// The list of an EDS in which an object stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum List {
    Mandatory,
    Optional,
    Manufacturer,
}

impl List {
    /// Every list, in the order of the file.
    pub(super) const ALL: [Self; 3] = [Self::Mandatory, Self::Optional, Self::Manufacturer];

    /// The list of an object.
    pub(super) fn of(index: u16) -> Self {
        match index {
            _ if MANDATORY.contains(&index) => Self::Mandatory,
            0x2000..=0x5FFF => Self::Manufacturer,
            _ => Self::Optional,
        }
    }

    /// The name of its section.
    pub(super) fn section(self) -> &'static str {
        match self {
            Self::Mandatory => "MandatoryObjects",
            Self::Optional => "OptionalObjects",
            Self::Manufacturer => "ManufacturerObjects",
        }
    }
}
