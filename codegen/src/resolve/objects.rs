//! Objects and entries: the drive's rows joined, field by field, with those of the bases.

use std::collections::BTreeMap;

use super::contradiction;
use super::names;
use super::origin::Says;
use super::stated::{BaseRow, Stated};
use super::tables::Tables;
use crate::diag::{Code, Diagnostic, Sink, code};
use crate::limits;
use crate::merge::{ObjectIndex, Profile};
use crate::model::{
    Address, Arena, BitsDef, BitsId, Class, Entry, EntryId, EnumDef, EnumId, Fact, Id, Object, ObjectId,
    ObjectKind, Origin,
};
use crate::name::Name;
use crate::rows::address::Sub;
use crate::rows::tables::ObjectRow;
use crate::rows::value::Reason;
use crate::rows::{Row, suggest};
use crate::source::{Sp, Span};

pub(super) struct Resolved {
    pub(super) objects: Arena<ObjectId, Object>,
    pub(super) entries: Arena<EntryId, Entry>,
    pub(super) enums: Arena<EnumId, EnumDef>,
    pub(super) bits: Arena<BitsId, BitsDef>,
}

struct Resolver<'a, 's> {
    profile: &'a Profile,
    tables: Tables,
    base_entries: BTreeMap<Address, BaseRow<'a>>,
    base_whole: BTreeMap<u16, BaseRow<'a>>,
    sink: &'s mut Sink,
}

pub(super) fn resolve(profile: &Profile, tables: Tables, sink: &mut Sink) -> Resolved {
    let own = ObjectIndex::new(&profile.rows.objects, sink);
    let (base_entries, base_whole) = base_rows(profile, sink);
    for row in &profile.rows.objects {
        check_reasons(row, [row.inferred.as_ref(), row.assumed.as_ref()], sink);
    }
    let mut resolver = Resolver { profile, tables, base_entries, base_whole, sink };
    if own.entries.len() > limits::ENTRIES {
        resolver.too_many();
        let (enums, bits) = resolver.tables.into_used();
        return Resolved { objects: Arena::default(), entries: Arena::default(), enums, bits };
    }
    let mut objects = Arena::default();
    let mut entries: Arena<EntryId, Entry> = Arena::default();
    for (address, place) in &own.entries {
        let rows = Stated {
            row: &profile.rows.objects[*place],
            range: own.refined.get(address).map(|place| &profile.rows.objects[*place]),
            base: resolver.base_entries.get(address).copied(),
        };
        let Some(entry) = resolver.entry(*address, rows, ObjectId::at(objects.len())) else { continue };
        let object: ObjectId = match objects.as_slice().last() {
            Some(Object { index, .. }) if *index == address.index => ObjectId::at(objects.len() - 1),
            _ => objects.push(first_of(&entry)),
        };
        let id = entries.push(Entry { object, ..entry });
        objects.as_mut_slice()[object.place()].entries.push(id);
    }
    for object in objects.as_mut_slice() {
        let whole = own.whole.get(&object.index).map(|place| &profile.rows.objects[*place]);
        resolver.finish(object, whole, &entries);
    }
    resolver.check_whole_rows(&own, &objects);
    let (enums, bits) = resolver.tables.into_used();
    Resolved { objects, entries, enums, bits }
}

fn base_rows<'a>(
    profile: &'a Profile,
    sink: &mut Sink,
) -> (BTreeMap<Address, BaseRow<'a>>, BTreeMap<u16, BaseRow<'a>>) {
    let (mut entries, mut whole) = (BTreeMap::new(), BTreeMap::new());
    for base in &profile.bases {
        let index = ObjectIndex::new(&base.rows.objects, sink);
        let row = |place: usize| (base.name.as_str(), &base.rows.objects[place]);
        entries.extend(index.entries.into_iter().map(|(address, place)| (address, row(place))));
        whole.extend(index.whole.into_iter().map(|(at, place)| (at, row(place))));
    }
    (entries, whole)
}

/// Fields that `inferred` and `assumed` name must exist and be stated by the row.
pub(super) fn check_reasons<R: Row, const N: usize>(
    row: &R,
    lists: [Option<&Sp<Vec<Reason>>>; N],
    sink: &mut Sink,
) {
    let known: Vec<&str> = R::TABLE.fields.iter().map(|f| f.key).collect();
    for list in lists.into_iter().flatten() {
        for reason in &list.value {
            if row.meta().raw.get(&reason.field).is_some() {
                continue;
            }
            let help = if known.contains(&reason.field.as_str()) {
                format!("state `{} = ...` in the row, or remove the reason", reason.field)
            } else {
                suggest(&reason.field, &known)
            };
            sink.push(
                Diagnostic::new(
                    code::NAMED_FIELD,
                    list.span,
                    format!("the row states no `{}`", reason.field),
                )
                .why("a reason belongs to a value of its row")
                .help(help),
            );
        }
    }
}

/// An object with the entry's name, to be completed when all its entries are known.
fn first_of(entry: &Entry) -> Object {
    let origin = entry.name.origin.clone();
    Object {
        index: entry.address.index,
        name: Fact::new(entry.handle.clone(), origin.clone()),
        kind: Fact::new(ObjectKind::Var, origin),
        entries: Vec::new(),
        text: None,
        note: None,
        deviation: None,
        also: None,
    }
}

impl<'a> Resolver<'a, '_> {
    fn too_many(&mut self) {
        let span = self.profile.rows.objects.first().map_or_else(Span::nowhere, |r| r.meta.span());
        self.sink.push(
            Diagnostic::new(code::TOO_MANY_ENTRIES, span, "the drive has too many entries")
                .why(format!("a drive has at most {} entries", limits::ENTRIES))
                .help("look for a range of sub-indexes that is too wide"),
        );
    }

    fn says(&self, row: &'a ObjectRow, base: Option<&'a str>) -> Says<'a> {
        fn reasons(list: Option<&Sp<Vec<Reason>>>) -> &[Reason] {
            list.map_or(&[], |l| &l.value)
        }
        Says {
            inferred: reasons(row.inferred.as_ref()),
            assumed: reasons(row.assumed.as_ref()),
            base,
            ..Says::plain(&row.meta, row.src.as_ref(), &self.profile.rows.errata)
        }
    }

    /// The value of a key: the drive's, else the base's. A value that an erratum drops is stated by nobody.
    fn pick<T: Clone>(
        &self,
        key: &str,
        stated: Stated<'a>,
        get: impl Fn(&ObjectRow) -> Option<&Sp<T>>,
    ) -> Option<Fact<T>> {
        for row in [Some(stated.row), stated.range].into_iter().flatten() {
            if let Some(value) = get(row) {
                return Some(self.says(row, None).fact(key, value.clone()));
            }
            if row.meta.fix(key).is_some_and(|fix| fix.set) {
                return None;
            }
        }
        let (name, base_row) = stated.base?;
        get(base_row).map(|value| self.says(base_row, Some(name)).fact(key, value.clone()))
    }

    fn entry(&mut self, address: Address, stated: Stated<'a>, object: ObjectId) -> Option<Entry> {
        let row = stated.row;
        let (ty, access) = (
            self.pick("type", stated, |r| r.ty.as_ref()),
            self.pick("access", stated, |r| r.access.as_ref()),
        );
        let name = self.pick("name", stated, |r| r.name.as_ref());
        if name.is_none() {
            self.unknown(
                code::NAME_UNKNOWN,
                address,
                row,
                "name",
                "generated code could not be called anything",
            );
        }
        if ty.is_none() {
            self.unknown(
                code::TYPE_UNKNOWN,
                address,
                row,
                "type",
                "width and sign are needed to build a frame",
            );
        }
        if access.is_none() {
            self.unknown(code::ACCESS_UNKNOWN, address, row, "access", "a refused write must not compile");
        }
        let (name, ty, access) = (name?, ty?, access?);
        self.deviation(stated, &address.to_string());
        // A name that stands for several entries gets the number of each.
        let rows = [Some(row), stated.range, stated.base.map(|b| b.1)];
        let named = rows.into_iter().flatten().find(|r| r.name.is_some() || r.rename.is_some());
        let named = named.unwrap_or(row);
        let printed = Sp::new(name.value.clone(), name.span());
        let used = names::used(&printed, named.rename.as_ref(), self.sink);
        let handle = member_name(&used.value, named, address);
        let values = self.pick("values", stated, |r| r.values.as_ref());
        let bits = self.pick("bits", stated, |r| r.bits.as_ref());
        Some(Entry {
            address,
            object,
            name: name.map(|n| n.0.original().to_owned()),
            handle,
            ty,
            access,
            mapping: self.pick("pdo", stated, |r| r.pdo.as_ref()),
            unit: self.pick("unit", stated, |r| r.unit.as_ref()),
            min: self.pick("min", stated, |r| r.min.as_ref()).map(|f| f.map(|c| c.0)),
            max: self.pick("max", stated, |r| r.max.as_ref()).map(|f| f.map(|c| c.0)),
            allow: self
                .pick("allow", stated, |r| r.allow.as_ref())
                .map(|f| f.map(|l| l.iter().map(|c| c.0).collect())),
            default: self.pick("default", stated, |r| r.default.as_ref()),
            values: values.and_then(|f| self.enum_fact(f)),
            bits: bits.and_then(|f| self.bits_fact(f)),
            text: self.pick("text", stated, |r| r.text.as_ref()).map(|f| f.value.0),
            // A note of a range may be untrue of the row that refines it.
            note: row.note.as_ref().map(|n| n.value.0.clone()),
            deviation: stated.own(|r| r.deviation.as_ref()).map(|d| d.value.0.clone()),
            parameter: self.pick("parameter", stated, |r| r.parameter.as_ref()).map(|f| f.map(|p| p.0)),
            effect: self.pick("effect", stated, |r| r.effect.as_ref()),
            also: row.also.as_ref().map(|a| a.value.clone()),
        })
    }

    fn enum_fact(&mut self, fact: Fact<crate::rows::value::Text>) -> Option<Fact<EnumId>> {
        let id = self.tables.enum_id(&Sp::new(fact.value.clone(), fact.span()), self.sink)?;
        Some(fact.map(|_| id))
    }

    fn bits_fact(&mut self, fact: Fact<crate::rows::value::Text>) -> Option<Fact<BitsId>> {
        let id = self.tables.bits_id(&Sp::new(fact.value.clone(), fact.span()), self.sink)?;
        Some(fact.map(|_| id))
    }

    fn unknown(&mut self, code: Code, address: Address, row: &ObjectRow, key: &str, why: &str) {
        self.sink.push(
            Diagnostic::new(code, row.meta.span(), format!("nobody states the {key} of {address}"))
                .why(format!("{why}, and nothing is assumed in silence"))
                .help(format!(
                    "add `{key} = ...` from the manual; if it follows by a rule, name the rule in `inferred`; if it is a \
                     standard object, name its base in `drive`"
                )),
        );
    }

    /// A row may contradict the standard object only with a reason, and a reason needs a contradiction.
    fn deviation(&mut self, stated: Stated<'_>, at: &str) {
        let Stated { row, base, .. } = stated;
        let found = base.and_then(|(name, base)| contradiction::find(stated, base).map(|c| (name, c)));
        match (found, stated.own(|r| r.deviation.as_ref())) {
            (Some((name, c)), None) => self.sink.push(
                Diagnostic::new(
                    code::CONTRADICTS_BASE,
                    c.row,
                    format!("{} of {at} is `{}`, and `{}` in base `{name}`", c.key, c.here, c.there),
                )
                .related(c.base, "the standard object")
                .why("most contradictions of a standard type are slips of the pen or of the manual")
                .help("correct the row; if the drive really differs, say why in `deviation = ...`, or add an erratum"),
            ),
            (None, Some(deviation)) if base.is_some() && row.deviation.is_some() && !row.meta.raw.fields.iter().any(|f| f.key.value == "text") => {
                self.sink.push(
                    Diagnostic::new(code::DEVIATION_UNUSED, deviation.span, format!("{at} deviates in nothing that is checked"))
                        .why("a reason without a contradiction would hide the next one")
                        .help("remove `deviation`; if the meaning differs, describe it in `text` as well"),
                );
            }
            _ => {}
        }
    }

    /// Kind and name of an object, once all its entries are there.
    fn finish(&mut self, object: &mut Object, whole: Option<&'a ObjectRow>, entries: &Arena<EntryId, Entry>) {
        let base = self.base_whole.get(&object.index).copied();
        if let Some(row) = whole {
            self.deviation(Stated { row, range: None, base }, &format!("{:04X}", object.index));
            object.note = row.note.as_ref().map(|n| n.value.0.clone());
            object.deviation = row.deviation.as_ref().map(|d| d.value.0.clone());
            object.also = row.also.as_ref().map(|a| a.value.clone());
        }
        let texts = [whole, base.map(|b| b.1)];
        object.text =
            texts.into_iter().flatten().find_map(|r| r.text.as_ref()).map(|text| text.value.0.clone());
        let pick_name = |row: Option<&'a ObjectRow>| {
            row.and_then(|r| self.pick("name", Stated { row: r, range: None, base }, |r| r.name.as_ref()))
        };
        let standard =
            || base.and_then(|(name, r)| r.name.clone().map(|n| self.says(r, Some(name)).fact("name", n)));
        let single = object.entries.len() == 1 && entries[object.entries[0]].address.sub == 0;
        if let Some(name) = pick_name(whole).or_else(|| if single { None } else { standard() }) {
            object.name = name.map(|n| n.0);
        } else if !single {
            object.name.origin.class = Class::Inferred("the name of its lowest sub-index".to_owned());
        }
        let stated =
            whole.and_then(|r| self.pick("kind", Stated { row: r, range: None, base }, |r| r.kind.as_ref()));
        let standard = base.and_then(|(name, r)| r.kind.map(|k| self.says(r, Some(name)).fact("kind", k)));
        object.kind = stated.or(standard).unwrap_or_else(|| inferred_kind(object, entries));
    }

    /// A row for an index as a whole needs an entry of that index.
    fn check_whole_rows(&mut self, own: &ObjectIndex, objects: &Arena<ObjectId, Object>) {
        for (index, place) in &own.whole {
            if objects.as_slice().binary_search_by_key(index, |o| o.index).is_err() && !self.left_out(*index)
            {
                let row = &self.profile.rows.objects[*place];
                self.sink.push(
                    Diagnostic::new(code::UNKNOWN_OBJECT, row.at.span, format!("{index:04X} has no entries"))
                        .why("a row for an index as a whole describes the entries below it")
                        .help(format!("add `at = \"{index:04X}:00\"`, or remove the row")),
                );
            }
        }
    }

    fn left_out(&self, index: u16) -> bool {
        let prefix = format!("{index:04X}:");
        let next = self.profile.rows.left_out.range(prefix.clone()..).next();
        next.is_some_and(|at| at.starts_with(&prefix))
    }
}

/// The name of one of several entries that a row states: with its number behind.
fn member_name(name: &Name, row: &ObjectRow, address: Address) -> Name {
    match row.at.value.sub {
        Sub::Range(..) if !name.words().is_empty() => {
            Name::new(&format!("{name} {}", address.sub)).unwrap_or_else(|| name.clone())
        }
        _ => name.clone(),
    }
}

fn inferred_kind(object: &Object, entries: &Arena<EntryId, Entry>) -> Fact<ObjectKind> {
    let members: Vec<&Entry> =
        object.entries.iter().map(|id| &entries[*id]).filter(|e| e.address.sub > 0).collect();
    let (kind, rule) = match members.as_slice() {
        [] => (ObjectKind::Var, "only sub-index 0"),
        [first, rest @ ..] if rest.iter().all(|e| e.ty == first.ty) => {
            (ObjectKind::Array, "one type at every sub-index")
        }
        _ => (ObjectKind::Record, "several types"),
    };
    let span = object.name.span();
    Fact::new(kind, Origin { class: Class::Inferred(rule.to_owned()), span, cite: None, erratum: None })
}
