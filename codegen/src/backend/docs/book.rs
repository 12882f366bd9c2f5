//! The pages and where in them a thing is: links, anchors, marks, and text in the language of the output.

use std::collections::{BTreeMap, BTreeSet};

use crate::backend::prose::Escape;
use crate::emit::escape::{anchor, markdown, one_line};
use crate::model::{
    Address, Alarm, BitsId, Cite, Class, Entry, EnumId, Erratum, ErratumId, Fact, Model, Object, Origin, Rule,
};
use crate::name::Name;

use super::fold;

/// Most entries on one page: with some hundred bytes each it stays below what code hosts render.
const ENTRIES: usize = 500;

/// A part of the object dictionary.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Area {
    /// Name of its first page.
    pub(super) file: &'static str,
    /// What it is called.
    pub(super) title: &'static str,
    first: u16,
}

/// The areas, ascending.
const AREAS: [Area; 3] = [
    Area { file: "communication", title: "Communication objects", first: 0 },
    Area { file: "manufacturer", title: "Manufacturer objects", first: 0x2000 },
    Area { file: "profile", title: "Profile objects", first: 0x6000 },
];

/// A page of objects.
pub(super) struct ObjectPage<'m> {
    /// Path below the folder of the pages.
    pub(super) file: String,
    /// Its area.
    pub(super) area: Area,
    /// What it holds.
    pub(super) objects: Vec<&'m Object>,
}

/// The pages of a drive, or what a terminal shows of them.
pub(super) struct Book<'m> {
    pub(super) model: &'m Model,
    /// Text of a terminal: no links, no marks of Markdown.
    pub(super) plain: bool,
    /// Pages of objects, ascending.
    pub(super) pages: Vec<ObjectPage<'m>>,
    /// The row of each entry that shares one with the entry before it.
    folded: BTreeMap<Address, Address>,
    /// Anchors by id.
    errata: BTreeMap<&'m str, String>,
    rules: BTreeMap<&'m str, String>,
    examples: BTreeMap<&'m str, String>,
    /// Entries by parameter number.
    parameters: BTreeMap<&'m str, Address>,
    /// The first entry that uses a table of values, and of bits.
    enums: BTreeMap<EnumId, Address>,
    bits: BTreeMap<BitsId, Address>,
    /// Errata of an object and of its entries, by index.
    concerned: BTreeMap<u16, BTreeSet<ErratumId>>,
    /// Rules that name an object, by index.
    ruled: BTreeMap<u16, Vec<&'m Rule>>,
}

impl<'m> Book<'m> {
    pub(super) fn new(model: &'m Model, plain: bool) -> Self {
        let folded = model.objects.as_slice().iter().flat_map(|object| {
            let runs = fold::runs(model, object);
            runs.into_iter()
                .flat_map(|run| run[1..].iter().map(|e| (e.address, run[0].address)).collect::<Vec<_>>())
        });
        let entries = || model.entries.as_slice().iter();
        let numbered = entries().filter_map(|e| Some((e.parameter.as_ref()?.value.as_str(), e.address)));
        // The last of several with one key stays in a map, so that the first has to come last.
        let enums = entries().rev().filter_map(|e| Some((e.values.as_ref()?.value, e.address)));
        let bits = entries().rev().filter_map(|e| Some((e.bits.as_ref()?.value, e.address)));
        Self {
            model,
            plain,
            pages: pages(model),
            folded: folded.collect(),
            errata: anchors("", model.errata.as_slice().iter().map(|e| e.id.as_str())),
            rules: anchors("rule-", model.rules.iter().map(|r| r.id.as_str())),
            examples: anchors("example-", model.examples.iter().map(|e| e.id.as_str())),
            parameters: numbered.collect(),
            enums: enums.collect(),
            bits: bits.collect(),
            concerned: concerned(model),
            ruled: ruled(model),
        }
    }

    /// The first entry that uses a table of values.
    pub(super) fn first_of_enum(&self, id: EnumId) -> Option<Address> {
        self.enums.get(&id).copied()
    }

    /// The first entry that uses a table of bits.
    pub(super) fn first_of_bits(&self, id: BitsId) -> Option<Address> {
        self.bits.get(&id).copied()
    }

    /// Errata of the object at `index` and of its entries.
    pub(super) fn errata_of(&self, index: u16) -> impl Iterator<Item = &'m Erratum> {
        let model = self.model;
        self.concerned.get(&index).into_iter().flatten().map(|id| &model.errata[*id])
    }

    /// Rules that name the object at `index`.
    pub(super) fn rules_of(&self, index: u16) -> impl Iterator<Item = &'m Rule> {
        self.ruled.get(&index).into_iter().flatten().copied()
    }

    /// The escaping function of the output.
    pub(super) fn escape(&self) -> Escape {
        if self.plain { one_line } else { markdown }
    }

    /// A short text of the profile: a name, a number.
    pub(super) fn text(&self, text: &str) -> String {
        self.escape()(text)
    }

    /// A sentence of the profile, in which errata, objects and parameters that it names are links.
    pub(super) fn prose(&self, text: &str) -> String {
        let escaped = self.text(text);
        if self.plain { escaped } else { self.linked(&escaped) }
    }

    fn linked(&self, text: &str) -> String {
        let mut out = String::with_capacity(text.len());
        let mut rest = text;
        while !rest.is_empty() {
            let plain = rest.find(|c: char| c.is_ascii_alphanumeric()).unwrap_or(rest.len());
            let (before, from) = rest.split_at(plain);
            out.push_str(before);
            let end =
                from.find(|c: char| !c.is_ascii_alphanumeric() && c != ':' && c != '.').unwrap_or(from.len());
            let word = from[..end].trim_end_matches([':', '.']);
            // A name of an entity is no word of the text, and one after a backslash is a part of one.
            let target = if before.ends_with(['&', '\\']) { None } else { self.target(word) };
            match target {
                Some(target) => out.extend(["[", word, "](", &target, ")"]),
                None => out.push_str(word),
            }
            rest = &from[word.len()..];
        }
        out
    }

    /// Where the thing is that a word of a text names.
    fn target(&self, word: &str) -> Option<String> {
        if word.len() < 4 {
            return None;
        }
        if let Some(anchor) = self.errata.get(word) {
            return Some(format!("errata.md#{anchor}"));
        }
        if let Some(at) = self.parameters.get(word) {
            return self.place(*at);
        }
        let address = match word.split_once(':') {
            Some((index, sub)) if index.len() == 4 && sub.len() == 2 => {
                Address::new(u16::from_str_radix(index, 16).ok()?, u8::from_str_radix(sub, 16).ok()?)
            }
            None if word.len() == 5 => {
                let index = u16::from_str_radix(word.strip_suffix('h')?, 16).ok()?;
                return self.model.object(index).map(|o| self.object_place(o));
            }
            _ => return None,
        };
        self.place(address)
    }

    fn file_of(&self, index: u16) -> &str {
        let page = self.pages.iter().rev().find(|p| p.objects.first().is_some_and(|o| o.index <= index));
        page.map_or("", |p| p.file.as_str())
    }

    fn object_place(&self, object: &Object) -> String {
        format!("{}#{:04x}", self.file_of(object.index), object.index)
    }

    /// Page and anchor of an entry that exists.
    fn place(&self, at: Address) -> Option<String> {
        self.model.entry(at)?;
        let row = self.folded.get(&at).unwrap_or(&at);
        Some(format!("{}#{}", self.file_of(at.index), entry_anchor(*row)))
    }

    /// `label` as a link.
    pub(super) fn link(&self, label: &str, target: &str) -> String {
        if self.plain { label.to_owned() } else { format!("[{label}]({target})") }
    }

    /// A word of the profile's language, such as a key of a row.
    pub(super) fn code(&self, word: &str) -> String {
        if self.plain { word.to_owned() } else { format!("`{word}`") }
    }

    /// An address, as a link where the drive has it.
    pub(super) fn address(&self, at: Address) -> String {
        let label = at.to_string();
        self.place(at).map_or(label.clone(), |target| self.link(&label, &target))
    }

    /// An index, as a link.
    pub(super) fn index(&self, object: &Object) -> String {
        self.link(&format!("{:04X}h", object.index), &self.object_place(object))
    }

    /// An erratum, as a link.
    pub(super) fn erratum(&self, erratum: &Erratum) -> String {
        self.link(&self.text(&erratum.id), &format!("errata.md#{}", self.erratum_anchor(erratum)))
    }

    /// The anchor of an erratum.
    pub(super) fn erratum_anchor(&self, erratum: &Erratum) -> String {
        self.errata.get(erratum.id.as_str()).cloned().unwrap_or_default()
    }

    /// A rule, as a link.
    pub(super) fn rule(&self, rule: &Rule) -> String {
        self.link(&self.text(&rule.id), &format!("rules.md#{}", self.rule_anchor(rule)))
    }

    /// The anchor of a rule.
    pub(super) fn rule_anchor(&self, rule: &Rule) -> String {
        self.rules.get(rule.id.as_str()).cloned().unwrap_or_default()
    }

    /// The anchor of a worked example.
    pub(super) fn example_anchor(&self, id: &str) -> String {
        self.examples.get(id).cloned().unwrap_or_default()
    }

    /// An alarm by its display, as a link.
    pub(super) fn alarm(&self, alarm: &Alarm) -> String {
        self.link(&self.text(&alarm.display), &format!("alarms.md#{}", self.alarm_anchor(alarm)))
    }

    /// The anchor of an alarm: its number, with its place among those that share it.
    pub(super) fn alarm_anchor(&self, alarm: &Alarm) -> String {
        let number = alarm.number.value;
        let same: Vec<&Alarm> = self.model.alarms.iter().filter(|a| a.number.value == number).collect();
        let place = same.iter().position(|a| a.display == alarm.display).unwrap_or(0);
        if place == 0 { format!("alarm-{number:02x}") } else { format!("alarm-{number:02x}-{}", place + 1) }
    }

    /// An anchor before what it names.
    pub(super) fn anchored(&self, anchor: &str) -> String {
        if self.plain { String::new() } else { format!("<a id=\"{anchor}\"></a>") }
    }

    /// A value with the mark of how it is known, and its erratum.
    pub(super) fn marked(&self, value: &str, origins: &[&Origin]) -> String {
        let mut out = value.to_owned();
        for origin in origins {
            let mark = mark(&origin.class);
            if !mark.is_empty() && !out.ends_with(mark) {
                out.push_str(mark);
            }
        }
        let mut errata: Vec<_> = origins.iter().filter_map(|o| o.erratum).collect();
        errata.dedup();
        for id in errata {
            out = format!("{out} {}", self.erratum(&self.model.errata[id]));
        }
        out
    }

    /// A value that may be there, marked; nothing where nobody says it.
    pub(super) fn fact<T>(&self, fact: Option<&Fact<T>>, shown: impl Fn(&T) -> String) -> String {
        fact.map_or_else(String::new, |f| self.marked(&shown(&f.value), &[&f.origin]))
    }

    /// Where the manual says it.
    pub(super) fn cite(&self, cite: Option<&Cite>) -> String {
        cite.map_or_else(String::new, |c| self.text(&c.to_string()))
    }

    /// Where a value comes from: the place in the manual, or the base that says it.
    pub(super) fn source(&self, origin: &Origin) -> String {
        match (&origin.cite, &origin.class) {
            (None, Class::Standard(base)) => self.text(base),
            (cite, _) => self.cite(cite.as_ref()),
        }
    }

    /// The name of an object or a table.
    pub(super) fn name(&self, name: &Name) -> String {
        self.text(name.original())
    }

    /// The entry with bits of the controlword or statusword.
    pub(super) fn word(&self, index: u16) -> Option<&'m Entry> {
        self.model.entry(Address::new(index, 0)).map(|(_, entry)| entry)
    }
}

/// Anchors of things by their ids. Ids that differ in signs only get anchors that differ all the same.
fn anchors<'m>(start: &str, ids: impl Iterator<Item = &'m str>) -> BTreeMap<&'m str, String> {
    let mut taken = BTreeSet::new();
    let mut all = BTreeMap::new();
    for id in ids {
        all.entry(id).or_insert_with(|| {
            let mut name = format!("{start}{}", anchor(id));
            while name.is_empty() || !taken.insert(name.clone()) {
                name.push_str("-2");
            }
            name
        });
    }
    all
}

/// Rules by the objects that they name.
fn ruled(model: &Model) -> BTreeMap<u16, Vec<&Rule>> {
    let mut all: BTreeMap<u16, Vec<&Rule>> = BTreeMap::new();
    for rule in &model.rules {
        let parts = rule.require.iter().chain(&rule.when).flat_map(|e| e.value.objects());
        let named: BTreeSet<u16> = parts.map(|at| at.index).collect();
        for index in named {
            all.entry(index).or_default().push(rule);
        }
    }
    all
}

/// Errata by the index that they are about, or where a value comes from them.
fn concerned(model: &Model) -> BTreeMap<u16, BTreeSet<ErratumId>> {
    let mut all: BTreeMap<u16, BTreeSet<ErratumId>> = BTreeMap::new();
    let objects = model.objects.as_slice().iter().flat_map(|o| {
        [&o.name.origin, &o.kind.origin].into_iter().filter_map(|origin| Some((o.index, origin.erratum?)))
    });
    let entries =
        model.entries.as_slice().iter().flat_map(|e| {
            e.origins().into_iter().filter_map(|origin| Some((e.address.index, origin.erratum?)))
        });
    let rows = model.errata.iter().filter_map(|(id, e)| {
        let index = e.at.get(..4).filter(|_| e.at.len() == 4 || e.at.as_bytes()[4] == b':')?;
        Some((u16::from_str_radix(index, 16).ok()?, id))
    });
    for (index, id) in objects.chain(entries).chain(rows) {
        all.entry(index).or_default().insert(id);
    }
    all
}

/// The anchor of an entry.
pub(super) fn entry_anchor(at: Address) -> String {
    format!("{:04x}-{:02x}", at.index, at.sub)
}

/// The mark of a value that the manual does not state.
pub(super) fn mark(class: &Class) -> &'static str {
    match class {
        Class::Stated => "",
        Class::Inferred(_) => "ⁱ",
        Class::Standard(_) => "ˢ",
        Class::Assumed(_) => "ᵃ",
    }
}

/// The pages of objects: one an area, and more where it is long.
fn pages(model: &Model) -> Vec<ObjectPage<'_>> {
    let mut pages: Vec<ObjectPage<'_>> = Vec::new();
    let mut entries = 0;
    for object in model.objects.as_slice() {
        let area = AREAS.iter().rev().find(|a| a.first <= object.index).unwrap_or(&AREAS[0]);
        let (new, full) = match pages.last() {
            Some(page) => (page.area != *area, entries + object.entries.len() > ENTRIES),
            None => (true, false),
        };
        if new || full {
            let file = if new {
                format!("{}.md", area.file)
            } else {
                format!("{}-{:04x}.md", area.file, object.index)
            };
            pages.push(ObjectPage { file, area: *area, objects: Vec::new() });
            entries = 0;
        }
        entries += object.entries.len();
        if let Some(page) = pages.last_mut() {
            page.objects.push(object);
        }
    }
    pages
}
