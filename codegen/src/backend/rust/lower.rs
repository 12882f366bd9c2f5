//! Names and types of the crate, decided once for all of its modules.

use std::collections::BTreeMap;

use drivewright_runtime::quantity::QuantityKind;

use super::loss;
use super::names::{Scope, ident};
use crate::diag::Sink;
use crate::model::{BitsId, Entry, EntryId, EnumId, Fact, Id, Mapping, Model, Pdo, Quantity, Type};
use crate::name::Case;

/// A drive with its Rust names.
pub(super) struct Lowered<'m> {
    pub(super) model: &'m Model,
    /// One for each entry, in the order of the model.
    pub(super) handles: Vec<Handle<'m>>,
    /// Type name of each value table, and the primitive below it.
    pub(super) enums: Vec<Meaning>,
    /// Type name of each bit table, and the primitive below it.
    pub(super) bits: Vec<Meaning>,
    /// One for each PDO, in the order of the model.
    pub(super) layouts: Vec<Layout>,
}

/// A handle.
pub(super) struct Handle<'m> {
    pub(super) name: String,
    /// Type of its value: `u32`, `enums::ModeOfOperation`.
    pub(super) ty: String,
    pub(super) access: &'static str,
    pub(super) mapping: &'static str,
    pub(super) quantity: String,
    /// Limits that a handle can hold.
    pub(super) range: Option<(Option<i128>, Option<i128>)>,
    /// Listed values, where a handle can hold them all.
    pub(super) allow: &'m [i128],
}

/// A type for named values or bits.
pub(super) struct Meaning {
    pub(super) name: String,
    /// The primitive type that carries it.
    pub(super) repr: &'static str,
}

/// A process data layout.
pub(super) struct Layout {
    pub(super) name: String,
    /// Field name of each entry; empty where the PDO has no typed layout.
    pub(super) fields: Vec<String>,
}

impl<'m> Lowered<'m> {
    pub(super) fn new(model: &'m Model, sink: &mut Sink) -> Self {
        let enums = meanings(
            model,
            model.enums.iter().map(|(id, e)| (id, &e.name)),
            |e| e.values.as_ref(),
            enum_repr,
            "i64",
        );
        let bits = meanings(
            model,
            model.bits.iter().map(|(id, b)| (id, &b.name)),
            |e| e.bits.as_ref(),
            bits_repr,
            "u64",
        );
        let mut lowered = Self { model, handles: Vec::new(), enums, bits, layouts: Vec::new() };
        lowered.handles = model.entries.iter().map(|(_, e)| lowered.handle(e, sink)).collect();
        lowered.layouts = model.pdos.iter().map(|p| lowered.layout(p, sink)).collect();
        lowered
    }

    pub(super) fn handle_of(&self, entry: EntryId) -> &Handle<'m> {
        &self.handles[entry.place()]
    }

    fn handle(&self, entry: &'m Entry, sink: &mut Sink) -> Handle<'m> {
        Handle {
            name: ident(&entry.handle, Case::UpperSnake),
            ty: self.value_type(entry, sink),
            access: access(entry),
            mapping: mapping(entry.mapping.as_ref()),
            quantity: entry.unit.as_ref().map_or_else(|| "Raw".to_owned(), |u| quantity(u.value.quantity)),
            range: range(entry, sink),
            allow: allow(entry, sink),
        }
    }

    /// The type of named values or bits, if there is one of this entry's width; else that of the wire.
    fn value_type(&self, entry: &Entry, sink: &mut Sink) -> String {
        let plain = wire_type(entry.ty.value);
        let values = entry.values.as_ref().map(|v| (&self.enums[v.value.place()], "enums"));
        let bits = entry.bits.as_ref().map(|b| (&self.bits[b.value.place()], "bits"));
        let Some((meaning, module)) = values.or(bits) else { return plain.to_owned() };
        if meaning.repr == plain {
            return format!("{module}::{}", meaning.name);
        }
        sink.push(loss::meaning(entry, &meaning.name));
        plain.to_owned()
    }

    fn layout(&self, pdo: &Pdo, sink: &mut Sink) -> Layout {
        let (word, first) =
            if pdo.direction == crate::model::Direction::Rx { ("Rx", 0x1600) } else { ("Tx", 0x1A00) };
        let name = match pdo.index.checked_sub(first) {
            Some(n) if n < 0x200 => format!("{word}{}", n + 1),
            _ => format!("{word}{:04X}", pdo.index),
        };
        let whole = |bits: Option<u8>| bits.is_some_and(|b| b > 0 && b % 8 == 0);
        if !pdo.entries.iter().all(|e| whole(self.model.entries[e.entry].ty.value.bits()))
            || pdo.entries.is_empty()
        {
            sink.push(loss::layout(pdo));
            return Layout { name, fields: Vec::new() };
        }
        let mut scope = Scope::default();
        let fields = pdo
            .entries
            .iter()
            .map(|e| scope.take(&ident(&self.model.entries[e.entry].handle, Case::Snake)))
            .collect();
        Layout { name, fields }
    }
}

/// The entries that refer to each table, in the order of the model.
pub(super) fn users<I: Id + Ord>(
    model: &Model,
    table: impl Fn(&Entry) -> Option<&Fact<I>>,
) -> BTreeMap<I, Vec<&Entry>> {
    let mut users: BTreeMap<I, Vec<&Entry>> = BTreeMap::new();
    for entry in model.entries.as_slice() {
        if let Some(table) = table(entry) {
            users.entry(table.value).or_default().push(entry);
        }
    }
    users
}

/// The name of each table, and the width of the first entry that uses it.
fn meanings<'m, I: Id + PartialEq>(
    model: &'m Model,
    tables: impl Iterator<Item = (I, &'m crate::name::Name)>,
    used: impl Fn(&Entry) -> Option<&Fact<I>>,
    repr: impl Fn(Type) -> Option<&'static str>,
    unused: &'static str,
) -> Vec<Meaning> {
    let mut reprs: BTreeMap<usize, &'static str> = BTreeMap::new();
    for (_, entry) in model.entries.iter() {
        if let (Some(table), Some(repr)) = (used(entry), repr(entry.ty.value)) {
            reprs.entry(table.value.place()).or_insert(repr);
        }
    }
    let meaning = |(id, name): (I, &crate::name::Name)| Meaning {
        name: ident(name, Case::Pascal),
        repr: reprs.get(&id.place()).copied().unwrap_or(unused),
    };
    tables.map(meaning).collect()
}

fn enum_repr(ty: Type) -> Option<&'static str> {
    ty.is_integer().then(|| wire_type(ty)).filter(|t| t.starts_with(['i', 'u']))
}

fn bits_repr(ty: Type) -> Option<&'static str> {
    ty.is_integer().then(|| wire_type(ty)).filter(|t| t.starts_with('u'))
}

/// The runtime's type of a value on the wire.
pub(super) fn wire_type(ty: Type) -> &'static str {
    match ty {
        Type::Bool => "bool",
        Type::Int { signed: true, bits } => match bits {
            8 => "i8",
            16 => "i16",
            24 => "I24",
            32 => "i32",
            40 => "I40",
            48 => "I48",
            56 => "I56",
            _ => "i64",
        },
        Type::Int { signed: false, bits } => match bits {
            8 => "u8",
            16 => "u16",
            24 => "U24",
            32 => "u32",
            40 => "U40",
            48 => "U48",
            56 => "U56",
            _ => "u64",
        },
        Type::Real { bits: 32 } => "f32",
        Type::Real { .. } => "f64",
        Type::VisibleString => "VisibleString",
        Type::OctetString => "OctetString",
        Type::UnicodeString => "UnicodeString",
        Type::TimeOfDay => "TimeOfDay",
        Type::TimeDifference => "TimeDifference",
        Type::Domain => "Domain",
    }
}

/// The runtime's marker of an access; also the variant of its `Access`.
pub(super) fn access(entry: &Entry) -> &'static str {
    use crate::model::Access;
    match entry.access.value {
        Access::Ro => "Ro",
        Access::Rw => "Rw",
        Access::Wo => "Wo",
        Access::Const => "Const",
    }
}

fn mapping(mapping: Option<&Fact<Mapping>>) -> &'static str {
    match mapping.map(|m| (m.value.rx, m.value.tx)) {
        None => "MapNotStated",
        Some((false, false)) => "Unmapped",
        Some((true, false)) => "Rx",
        Some((false, true)) => "Tx",
        Some((true, true)) => "RxTx",
    }
}

/// The runtime's marker of a quantity; also the variant of its `QuantityKind`.
pub(super) fn quantity(of: Quantity) -> String {
    format!("{:?}", QuantityKind::from(of))
}

/// Limits as a handle holds them: i64, and both ends of it stand for `not stated`. What the type sets by itself is no loss.
fn range(entry: &Entry, sink: &mut Sink) -> Option<(Option<i128>, Option<i128>)> {
    let (min, max) = (entry.min.as_ref().map(|f| f.value), entry.max.as_ref().map(|f| f.value));
    let fits = |n: &i128| (i128::from(i64::MIN) + 1..i128::from(i64::MAX)).contains(n);
    let ends = entry.ty.value.range();
    let wide =
        [min, max].iter().flatten().any(|n| *n >= i128::from(i64::MAX) && ends.is_none_or(|e| e.1 != *n));
    if wide {
        sink.push(loss::limit(entry));
    }
    let (min, max) = (min.filter(fits), max.filter(fits));
    (min.is_some() || max.is_some()).then_some((min, max))
}

/// Listed values as a handle holds them: i64. Half a list would refuse what the drive accepts.
fn allow<'m>(entry: &'m Entry, sink: &mut Sink) -> &'m [i128] {
    let list = entry.allow.as_ref().map_or(&[][..], |a| &a.value);
    if list.iter().all(|n| i64::try_from(*n).is_ok()) {
        return list;
    }
    sink.push(loss::limit(entry));
    &[]
}

/// The `use` line for the modules that some of `types` are in.
pub(super) fn imports<'a>(types: impl Iterator<Item = &'a str>, always: &[&str]) -> String {
    let mut used: std::collections::BTreeSet<&str> = always.iter().copied().collect();
    used.extend(types.filter_map(|t| t.split_once("::")).map(|(module, _)| module));
    match used.into_iter().collect::<Vec<_>>().as_slice() {
        [] => String::new(),
        [one] => format!("use super::{one};\n"),
        many => format!("use super::{{{}}};\n", many.join(", ")),
    }
}

/// What an entry's values or bits mean, as the tables refer to it.
pub(super) fn meaning_of(entry: &Entry) -> (Option<EnumId>, Option<BitsId>) {
    (entry.values.as_ref().map(|v| v.value), entry.bits.as_ref().map(|b| b.value))
}
