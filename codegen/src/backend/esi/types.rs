//! Data types: every one that the dictionary uses must be declared, base types too.

use std::collections::BTreeMap;

use super::loss::Loss;
use crate::model::{Access, Entry, EnumId, Mapping, Model, Type, Value};

/// Bytes of a text or domain of which nobody states more.
const TEXT_BYTES: u32 = 32;
/// Where the entries behind sub-index 0 start: it is padded to 16 bits.
pub(super) const FIRST: u32 = 16;

/// A data type.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct DataType {
    pub(super) name: String,
    pub(super) base: Option<String>,
    pub(super) bits: u32,
    pub(super) body: Body,
}

/// What a data type consists of.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Body {
    /// Nothing more.
    Plain,
    /// Named values.
    Enumeration(Vec<(String, i64)>),
    /// So many elements, from sub-index 1.
    Array(usize),
    /// Entries.
    Record(Vec<Item>),
}

/// An entry of a record, or the elements of an array.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Item {
    /// The sub-index; `None` for the elements of an array.
    pub(super) sub: Option<u8>,
    pub(super) name: String,
    pub(super) ty: Named,
    pub(super) offset: u32,
    pub(super) flags: Flags,
}

/// A type by its name.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Named {
    pub(super) name: String,
    pub(super) bits: u32,
}

/// Who may do what.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Flags {
    pub(super) access: &'static str,
    /// Directions in which a PDO may carry it.
    pub(super) mapping: Option<&'static str>,
}

impl Flags {
    /// What an entry states.
    pub(super) fn of(entry: &Entry) -> Self {
        Self {
            access: match entry.access.value {
                Access::Ro | Access::Const => "ro",
                Access::Rw => "rw",
                Access::Wo => "wo",
            },
            mapping: entry.mapping.as_ref().and_then(|m| directions(m.value)),
        }
    }
}

fn directions(mapping: Mapping) -> Option<&'static str> {
    match (mapping.rx, mapping.tx) {
        (false, false) => None,
        (true, false) => Some("R"),
        (false, true) => Some("T"),
        (true, true) => Some("RT"),
    }
}

/// What ETG.1020 calls a type, and its bits. `bytes` is the length of a text or domain.
pub(super) fn base(ty: Type, bytes: u32) -> Named {
    let fixed = |name: String| Named { name, bits: ty.bits().unwrap_or(0).into() };
    match ty {
        Type::Bool => fixed("BOOL".to_owned()),
        Type::Int { signed, bits } => {
            let sign = if signed { "" } else { "U" };
            fixed(match bits {
                8 => format!("{sign}SINT"),
                16 => format!("{sign}INT"),
                32 => format!("{sign}DINT"),
                64 => format!("{sign}LINT"),
                bits => format!("{sign}INT{bits}"),
            })
        }
        Type::Real { bits: 32 } => fixed("REAL".to_owned()),
        Type::Real { .. } => fixed("LREAL".to_owned()),
        Type::TimeOfDay => fixed("TIME_OF_DAY".to_owned()),
        Type::TimeDifference => fixed("TIME_DIFFERENCE".to_owned()),
        Type::VisibleString => Named { name: format!("STRING({bytes})"), bits: bytes * 8 },
        Type::OctetString => {
            Named { name: format!("ARRAY [0..{}] OF BYTE", bytes.saturating_sub(1)), bits: bytes * 8 }
        }
        Type::UnicodeString => {
            Named { name: format!("ARRAY [0..{}] OF UINT", bytes.saturating_sub(1)), bits: bytes * 16 }
        }
        Type::Domain => Named { name: "DOMAIN".to_owned(), bits: 0 },
    }
}

/// The types of a dictionary, each once.
#[derive(Default, Debug)]
pub(super) struct Types {
    base: BTreeMap<String, DataType>,
    enumerations: BTreeMap<String, DataType>,
    /// Names of the types of named values.
    named: BTreeMap<(EnumId, Type), Named>,
    composed: Vec<DataType>,
}

impl Types {
    /// The type of an entry. The first entry with a table of values names its type: `DT6060EN08`.
    pub(super) fn of(&mut self, entry: &Entry, model: &Model, lose: &mut impl FnMut(Loss)) -> Named {
        let ty = entry.ty.value;
        if ty.bits().is_none() {
            lose(Loss::LengthUnknown);
        }
        let base = self.plain(base(ty, text_bytes(entry)));
        let Some(id) = entry.values.as_ref().map(|v| v.value).filter(|_| ty.range().is_some()) else {
            return base;
        };
        if let Some(named) = self.named.get(&(id, ty)) {
            return named.clone();
        }
        let values = enumeration(model, id, lose);
        if values.is_empty() {
            return base;
        }
        let sub = if entry.address.sub == 0 { String::new() } else { format!("{:02X}", entry.address.sub) };
        let name = format!("DT{:04X}{sub}EN{:02}", entry.address.index, base.bits);
        let named = Named { name: name.clone(), bits: base.bits };
        let body = Body::Enumeration(values);
        let ty_of = DataType { name: name.clone(), base: Some(base.name), bits: base.bits, body };
        self.enumerations.insert(name, ty_of);
        self.named.insert((id, ty), named.clone());
        named
    }

    /// Declares a base type.
    fn plain(&mut self, named: Named) -> Named {
        let ty = DataType { name: named.name.clone(), base: None, bits: named.bits, body: Body::Plain };
        self.base.entry(named.name.clone()).or_insert(ty);
        named
    }

    /// Declares the type of an array or record.
    pub(super) fn add(&mut self, ty: DataType) -> Named {
        let named = Named { name: ty.name.clone(), bits: ty.bits };
        self.composed.push(ty);
        named
    }

    /// Every type: base types, named values, arrays and records.
    pub(super) fn iter(&self) -> impl Iterator<Item = &DataType> {
        self.base.values().chain(self.enumerations.values()).chain(&self.composed)
    }
}

/// Bytes of a text: as many as the default has.
fn text_bytes(entry: &Entry) -> u32 {
    let default = entry.default.as_ref().map(|d| &d.value);
    let length = match default {
        Some(Value::Text(text)) if entry.ty.value == Type::UnicodeString => text.encode_utf16().count(),
        Some(Value::Text(text)) => text.len(),
        _ => 0,
    };
    u32::try_from(length).ok().filter(|n| *n > 0).unwrap_or(TEXT_BYTES)
}

/// Named values, as far as 32 bits hold them: XSD 1.14 has no more.
fn enumeration(model: &Model, id: EnumId, lose: &mut impl FnMut(Loss)) -> Vec<(String, i64)> {
    let mut values = Vec::new();
    for value in &model.enums[id].values {
        match i64::try_from(value.value) {
            Ok(n) if (i64::from(i32::MIN)..=u32::MAX.into()).contains(&n) => {
                values.push((value.printed.clone(), n));
            }
            _ => lose(Loss::NamedValue),
        }
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_etg_1020() {
        let name = |word| base(Type::from_word(word).unwrap(), 7).name;
        let names = ["bool", "i8", "u16", "u24", "i40", "u64", "f32", "f64", "string", "octets"].map(name);
        let expected = ["BOOL", "SINT", "UINT", "UINT24", "INT40", "ULINT", "REAL", "LREAL", "STRING(7)"];
        assert_eq!(names[..9], expected);
        assert_eq!(names[9], "ARRAY [0..6] OF BYTE");
        for word in Type::words() {
            let ty = Type::from_word(word).unwrap();
            assert_eq!(Some(base(ty, 1).bits), ty.bits().map(u32::from).or(Some(base(ty, 1).bits)), "{word}");
        }
    }
}
