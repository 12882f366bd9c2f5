//! Value tables and bit tables. A drive's own rows replace a base's table of the same name as a whole: its manual lists
//! what it has.

use std::collections::BTreeMap;

use super::names;
use super::origin::Says;
use crate::diag::{Code, Diagnostic, Sink, code};
use crate::merge::Profile;
use crate::model::{Arena, BitField, BitsDef, BitsId, EnumDef, EnumId, EnumValue};
use crate::name::Name;
use crate::rows::Row;
use crate::rows::tables::{BitRow, EnumRow, ErratumRow};
use crate::rows::{suggest, value::Text};
use crate::source::Sp;

/// All tables that the drive or its bases define, and those in use.
pub(super) struct Tables {
    enums: Named<EnumDef, EnumId>,
    bits: Named<BitsDef, BitsId>,
}

/// Definitions by the words of their name. A base's definition becomes part of the model when something refers to it.
struct Named<T, I> {
    defined: BTreeMap<Vec<String>, (T, bool)>,
    ids: BTreeMap<Vec<String>, I>,
    used: Arena<I, T>,
}

impl<T: Clone, I: crate::model::Id> Named<T, I> {
    fn new(defined: BTreeMap<Vec<String>, (T, bool)>) -> Self {
        let mut named = Self { defined, ids: BTreeMap::new(), used: Arena::default() };
        let own: Vec<Vec<String>> =
            named.defined.iter().filter(|(_, d)| d.1).map(|(k, _)| k.clone()).collect();
        for words in own {
            named.id(&words);
        }
        named
    }

    fn id(&mut self, words: &[String]) -> Option<I> {
        if let Some(id) = self.ids.get(words) {
            return Some(*id);
        }
        let id = self.used.push(self.defined.get(words)?.0.clone());
        self.ids.insert(words.to_vec(), id);
        Some(id)
    }

    fn find(&mut self, text: &Sp<Text>, unknown: Code, sink: &mut Sink) -> Option<I> {
        let name = Name::new(&text.value.0);
        let found = name.as_ref().and_then(|n| self.id(n.words()));
        if found.is_none() {
            let known: Vec<String> = self.defined.keys().take(200).map(|words| words.join(" ")).collect();
            let known: Vec<&str> = known.iter().map(String::as_str).collect();
            let kind = if unknown == code::UNKNOWN_ENUM { "value" } else { "bit" };
            sink.push(
                Diagnostic::new(unknown, text.span, format!("there is no {kind} table `{}`", text.value.0))
                    .why("its values would stay without a meaning")
                    .help(suggest(&text.value.0.to_ascii_lowercase(), &known)),
            );
        }
        found
    }
}

impl Tables {
    pub(super) fn new(profile: &Profile, sink: &mut Sink) -> Self {
        let mut enums = BTreeMap::new();
        let mut bits = BTreeMap::new();
        for base in &profile.bases {
            let from = Some(base.name.as_str());
            define(&mut enums, group(&base.rows.enums, |r| &r.name), false, |rows| {
                enum_def(rows, from, &[], sink)
            });
            define(&mut bits, group(&base.rows.bits, |r| &r.name), false, |rows| {
                bits_def(rows, from, &[], sink)
            });
        }
        let errata = &profile.rows.errata;
        define(&mut enums, group(&profile.rows.enums, |r| &r.name), true, |rows| {
            enum_def(rows, None, errata, sink)
        });
        define(&mut bits, group(&profile.rows.bits, |r| &r.name), true, |rows| {
            bits_def(rows, None, errata, sink)
        });
        Self { enums: Named::new(enums), bits: Named::new(bits) }
    }

    pub(super) fn enum_id(&mut self, name: &Sp<Text>, sink: &mut Sink) -> Option<EnumId> {
        self.enums.find(name, code::UNKNOWN_ENUM, sink)
    }

    pub(super) fn bits_id(&mut self, name: &Sp<Text>, sink: &mut Sink) -> Option<BitsId> {
        self.bits.find(name, code::UNKNOWN_BITS, sink)
    }

    pub(super) fn into_used(self) -> (Arena<EnumId, EnumDef>, Arena<BitsId, BitsDef>) {
        (self.enums.used, self.bits.used)
    }
}

fn group<R>(rows: &[R], name: impl Fn(&R) -> &Sp<Name>) -> BTreeMap<Vec<String>, Vec<&R>> {
    let mut groups: BTreeMap<Vec<String>, Vec<&R>> = BTreeMap::new();
    for row in rows {
        groups.entry(name(row).value.words().to_vec()).or_default().push(row);
    }
    groups
}

fn define<R, T>(
    out: &mut BTreeMap<Vec<String>, (T, bool)>,
    groups: BTreeMap<Vec<String>, Vec<&R>>,
    own: bool,
    mut make: impl FnMut(Vec<&R>) -> T,
) {
    for (words, rows) in groups {
        out.insert(words, (make(rows), own));
    }
}

/// Sorts rows by `key`; of two with one key the second is reported and left out.
fn unique<'a, R: Row, K: Ord>(mut rows: Vec<&'a R>, key: impl Fn(&R) -> K, sink: &mut Sink) -> Vec<&'a R> {
    rows.sort_by_key(|r| (key(r), r.meta().span()));
    let mut out: Vec<&R> = Vec::with_capacity(rows.len());
    for row in rows {
        match out.last() {
            Some(first) if key(first) == key(row) => crate::merge::duplicate(row, *first, sink),
            _ => out.push(row),
        }
    }
    out
}

fn enum_def(rows: Vec<&EnumRow>, base: Option<&str>, errata: &[ErratumRow], sink: &mut Sink) -> EnumDef {
    let name = rows[0].name.value.clone();
    let rows = unique(rows, |r| r.value.value, sink);
    let value = |row: &&EnumRow| {
        let says = Says { base, ..Says::plain(&row.meta, row.src.as_ref(), errata) };
        EnumValue {
            value: row.value.value.0,
            name: says.joint(&["label", "value"], names::used(&row.label, row.rename.as_ref(), sink)),
            printed: row.label.value.0.original().to_owned(),
            text: row.text.as_ref().map(|t| t.value.0.clone()),
        }
    };
    EnumDef { name, values: rows.iter().map(value).collect() }
}

fn bits_def(rows: Vec<&BitRow>, base: Option<&str>, errata: &[ErratumRow], sink: &mut Sink) -> BitsDef {
    let name = rows[0].name.value.clone();
    let rows = unique(rows, |r| (r.mode.map(|m| m.value), r.bit.value), sink);
    let field = |row: &&BitRow| {
        let says = Says { base, ..Says::plain(&row.meta, row.src.as_ref(), errata) };
        BitField {
            bit: row.bit.value.0,
            width: row.width.map_or(1, |w| w.value.0),
            mode: row.mode.map(|m| m.value),
            name: says.joint(
                &["label", "bit", "width", "mode"],
                names::used(&row.label, row.rename.as_ref(), sink),
            ),
            printed: row.label.value.0.original().to_owned(),
            text: row.text.as_ref().map(|t| t.value.0.clone()),
            deviation: row.deviation.as_ref().map(|d| d.value.0.clone()),
        }
    };
    BitsDef { name, fields: rows.iter().map(field).collect() }
}
