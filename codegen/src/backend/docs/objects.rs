//! Objects with their entries: a table with a row for each entry, and what does not fit into a cell below it.

use serde::Serialize;

use super::book::{Book, entry_anchor, mark};
use super::errata::{outcome, value};
use super::fold::{runs, span, sub_span};
use super::meanings::{self, Meaning};
use super::table::Table;
use crate::backend::prose;
use crate::model::{Address, Cite, Class, Entry, EnumDef, Erratum, Object, Origin, Type, Value};

/// An object for a reader.
#[derive(Serialize)]
pub(super) struct ObjectView {
    anchor: String,
    index: String,
    name: String,
    /// Kind of an object with sub-indexes.
    kind: String,
    texts: Vec<String>,
    table: String,
    /// What to know of single entries, and who says what.
    items: Vec<String>,
    errata: Vec<String>,
    meanings: Vec<Meaning>,
}

const HEAD: [&str; 9] =
    ["Sub", "Name", "Type", "Access", "PDO", "Unit of a count", "Range", "Default", "Manual"];

/// What to tell of `object`.
pub(super) fn view(book: &Book<'_>, object: &Object) -> ObjectView {
    told(book, object, None)
}

/// What to tell of `object`, or of its entry at `at` only.
pub(super) fn told(book: &Book<'_>, object: &Object, at: Option<Address>) -> ObjectView {
    let mut runs = runs(book.model, object);
    if let Some(at) = at {
        // The row of an entry that is asked for is its own.
        runs = book.model.entry(at).map(|(_, entry)| vec![vec![entry]]).unwrap_or_default();
    }
    let single = object.entries.len() == 1;
    let kind = format!("{} of {} entries", prose::capital(object.kind.value.word()), object.entries.len());
    let kind = book.marked(&kind, &[&object.kind.origin]);
    let name = if single {
        book.name(&object.name.value)
    } else {
        book.marked(&book.name(&object.name.value), &[&object.name.origin])
    };
    ObjectView {
        anchor: book.anchored(&format!("{:04x}", object.index)),
        index: format!("{:04X}h", object.index),
        name: if single { runs.first().map_or(name, |run| book.text(&run[0].name.value)) } else { name },
        kind: if single { String::new() } else { kind + "." },
        texts: texts(book, object, &runs),
        table: Table::of(&HEAD, runs.iter().map(|run| row(book, run))).text(book.plain),
        items: items(book, object, &runs),
        errata: errata(book, object, at),
        meanings: meanings::of(book, &runs),
    }
}

/// What the object is for; of an object with one entry, what that is for.
fn texts(book: &Book<'_>, object: &Object, runs: &[Vec<&Entry>]) -> Vec<String> {
    let mut texts: Vec<String> = object.text.iter().map(|t| book.prose(t)).collect();
    if let [run] = runs {
        texts.extend(run[0].text.as_ref().filter(|t| object.text.as_ref() != Some(t)).map(|t| book.prose(t)));
    }
    texts
}

/// The row of one entry, or of several that say the same.
pub(super) fn row(book: &Book<'_>, run: &[&Entry]) -> [String; 9] {
    let entry = run[0];
    let sub = book.anchored(&entry_anchor(entry.address)) + &sub_span(span(run).0, span(run).1);
    let [mut name, ty, access, pdo, unit, range, default, manual] = values(book, entry);
    // The heading above the one row of an object says it.
    if book.model.objects[entry.object].entries.len() == 1 && name == book.text(&entry.name.value) {
        name.clear();
    }
    [sub, name, ty, access, pdo, unit, range, default, manual]
}

/// The cells of an entry but for its sub-index.
pub(super) fn values(book: &Book<'_>, entry: &Entry) -> [String; 8] {
    let names = entry.values.as_ref().map(|v| &book.model.enums[v.value]);
    let number = entry.parameter.as_ref().map(|p| format!("{} ", book.text(&p.value))).unwrap_or_default();
    let name = book.marked(&(number + &book.text(&entry.name.value)), &name_origins(entry));
    [
        name,
        book.marked(entry.ty.value.word(), &[&entry.ty.origin]),
        book.marked(entry.access.value.word(), &[&entry.access.origin]),
        book.fact(entry.mapping.as_ref(), |m| m.word().to_owned()),
        book.fact(entry.unit.as_ref(), |u| book.text(&u.text)),
        range(book, entry),
        default(book, entry, names),
        manual(book, entry),
    ]
}

fn name_origins(entry: &Entry) -> Vec<&Origin> {
    let parameter = entry.parameter.as_ref().map(|p| &p.origin);
    std::iter::once(&entry.name.origin).chain(parameter).collect()
}

/// Which numbers it takes.
fn range(book: &Book<'_>, entry: &Entry) -> String {
    let escape = book.escape();
    let limits = [entry.min.as_ref(), entry.max.as_ref()];
    let span = match prose::always(entry) {
        Some(n) => Some(format!("always {}", prose::shown(entry, n))),
        None => prose::range(entry, escape),
    };
    let origins: Vec<&Origin> = limits.into_iter().flatten().map(|f| &f.origin).collect();
    let span = span.map(|s| book.marked(&s, &origins));
    let list = prose::allow(entry, None, escape)
        .map(|l| book.marked(&l, &entry.allow.as_ref().map(|f| vec![&f.origin]).unwrap_or_default()));
    [span, list].into_iter().flatten().collect::<Vec<_>>().join("; ")
}

fn default(book: &Book<'_>, entry: &Entry, names: Option<&EnumDef>) -> String {
    let Some(fact) = &entry.default else { return String::new() };
    let shown = match mapped(entry, &fact.value) {
        Some((at, bits, word)) => format!("{word:08X}h ({}, {bits} bits)", book.address(at)),
        None => prose::default(entry, names, book.escape()).unwrap_or_default(),
    };
    book.marked(&shown, &[&fact.origin])
}

/// The entry and the length that a mapping word names, with the word.
fn mapped(entry: &Entry, value: &Value) -> Option<(Address, u8, u32)> {
    let Value::Int(n) = value else { return None };
    let index = entry.address.index;
    let mapping = (0x1600..0x1800).contains(&index) || (0x1A00..0x1C00).contains(&index);
    let word = u32::try_from(*n).ok().filter(|word| mapping && entry.address.sub > 0 && *word > 0xFFFF)?;
    let [high, low, sub, bits] = word.to_be_bytes();
    (entry.ty.value == Type::int(false, 32))
        .then(|| (Address::new(u16::from_be_bytes([high, low]), sub), bits, word))
}

/// The place of the row, and where it is printed again.
fn manual(book: &Book<'_>, entry: &Entry) -> String {
    let row = book.cite(row_cite(entry));
    let again = entry.also.as_ref().map(|a| format!("again {}", book.text(&a.to_string())));
    [Some(row).filter(|r| !r.is_empty()), again].into_iter().flatten().collect::<Vec<_>>().join("; ")
}

fn row_cite(entry: &Entry) -> Option<&Cite> {
    facts(entry).into_iter().find_map(|(_, origin)| origin.cite.as_ref())
}

/// The values of an entry by the name that a reader gives them.
pub(super) fn facts(entry: &Entry) -> Vec<(&'static str, &Origin)> {
    let all = [
        ("name", Some(&entry.name.origin)),
        ("type", Some(&entry.ty.origin)),
        ("access", Some(&entry.access.origin)),
        ("mapping", entry.mapping.as_ref().map(|f| &f.origin)),
        ("unit", entry.unit.as_ref().map(|f| &f.origin)),
        ("minimum", entry.min.as_ref().map(|f| &f.origin)),
        ("maximum", entry.max.as_ref().map(|f| &f.origin)),
        ("list of values", entry.allow.as_ref().map(|f| &f.origin)),
        ("default", entry.default.as_ref().map(|f| &f.origin)),
        ("names of values", entry.values.as_ref().map(|f| &f.origin)),
        ("names of bits", entry.bits.as_ref().map(|f| &f.origin)),
        ("parameter", entry.parameter.as_ref().map(|f| &f.origin)),
        ("effect", entry.effect.as_ref().map(|f| &f.origin)),
    ];
    all.into_iter().filter_map(|(what, origin)| Some((what, origin?))).collect()
}

/// What a list below the table says: the same thing of several entries once.
#[derive(Default)]
struct Items {
    said: Vec<Item>,
}

/// One thing that is said, of which values (or of the entry itself) and of which sub-indexes.
struct Item {
    of: String,
    text: String,
    subs: Vec<(u8, u8)>,
}

impl Items {
    fn say(&mut self, of: &str, text: String, run: &[&Entry]) {
        let (first, last) = span(run);
        let known = self.said.iter_mut().find(|item| item.of == of && item.text == text);
        let Some(item) = known else {
            return self.said.push(Item { of: of.to_owned(), text, subs: vec![(first, last)] });
        };
        match item.subs.last_mut() {
            Some(before) if before.1.checked_add(1) == Some(first) => before.1 = last,
            _ => item.subs.push((first, last)),
        }
    }
}

impl Item {
    /// `Type, access of 01 to 03: said`; without the sub-indexes where there is one row only.
    fn line(&self, single: bool) -> String {
        let Self { of, text, .. } = self;
        let subs: Vec<String> = self.subs.iter().map(|(first, last)| sub_span(*first, *last)).collect();
        match (of.is_empty(), single || subs.is_empty()) {
            (true, true) => text.clone(),
            (true, false) => format!("{}: {text}", subs.join(", ")),
            (false, true) => format!("{}: {text}", prose::capital(of)),
            (false, false) => format!("{} of {}: {text}", prose::capital(of), subs.join(", ")),
        }
    }
}

fn items(book: &Book<'_>, object: &Object, runs: &[Vec<&Entry>]) -> Vec<String> {
    let mut items = Items::default();
    let whole = whole(book, object);
    items.said.extend(whole.into_iter().map(|text| Item { of: String::new(), text, subs: Vec::new() }));
    let single = runs.len() == 1;
    for run in runs {
        let entry = run[0];
        for text in words(book, entry, single) {
            items.say("", text, run);
        }
        for (what, text) in known(book, entry) {
            items.say(&what, text, run);
        }
    }
    let rules = book.rules_of(object.index);
    let rules = rules.map(|rule| format!("Rule {}: {}", book.rule(rule), book.prose(&rule.text.value)));
    items.said.iter().map(|item| item.line(single)).chain(rules).collect()
}

/// Our words on an entry. What an object with one row is for stands above its table.
fn words(book: &Book<'_>, entry: &Entry, single: bool) -> Vec<String> {
    let prose =
        |text: &Option<String>, before: &str| text.as_ref().map(|t| format!("{before}{}", book.prose(t)));
    let text = if single { None } else { prose(&entry.text, "") };
    let effect = entry.effect.as_ref().map(|e| {
        let when = prose::effect(e.value);
        let when = if book.plain { when.replace('*', "") } else { when.to_owned() };
        book.marked(&format!("A new value takes effect {when}."), &[&e.origin])
    });
    let deviation = prose(&entry.deviation, "Deviates from the standard: ");
    [text, effect, prose(&entry.note, "Note: "), deviation].into_iter().flatten().collect()
}

/// What to know of the object as a whole.
fn whole(book: &Book<'_>, object: &Object) -> Vec<String> {
    let note = object.note.as_ref().map(|n| format!("Note: {}", book.prose(n)));
    let deviation =
        object.deviation.as_ref().map(|d| format!("Deviates from the standard: {}", book.prose(d)));
    let also = object.also.as_ref().map(|a| format!("Printed again: {}.", book.text(&a.to_string())));
    [note, deviation, also].into_iter().flatten().collect()
}

/// Reasons of values that the manual does not state, and places of those that stand elsewhere than the row: which values,
/// and what to say of them.
fn known(book: &Book<'_>, entry: &Entry) -> Vec<(String, String)> {
    let row = row_cite(entry);
    let said = |origin: &Origin| match (&origin.class, &origin.cite) {
        // That of an erratum stands with the erratum.
        (Class::Inferred(_), _) if origin.erratum.is_some() => None,
        (Class::Inferred(rule) | Class::Assumed(rule), _) => {
            let text = book.prose(rule.trim_end_matches('.'));
            Some(format!("{}{}: {text}.", origin.class.word(), mark(&origin.class)))
        }
        (Class::Stated, cite) if cite.is_some() && cite.as_ref() != row => {
            Some(format!("{}.", book.cite(cite.as_ref())))
        }
        _ => None,
    };
    let mut all: Vec<(String, String)> = Vec::new();
    for (what, origin) in facts(entry) {
        let Some(text) = said(origin) else { continue };
        match all.iter_mut().find(|(_, known)| *known == text) {
            Some((whats, _)) => whats.extend([", ", what]),
            None => all.push((what.to_owned(), text)),
        }
    }
    all
}

/// Errata of the object and of its entries, or of one of them.
fn errata(book: &Book<'_>, object: &Object, at: Option<Address>) -> Vec<String> {
    match at.and_then(|at| book.model.entry(at)) {
        Some((_, entry)) => prose::errata_of(entry, book.model).map(|e| erratum(book, e)).collect(),
        None => book.errata_of(object.index).map(|e| erratum(book, e)).collect(),
    }
}

/// An erratum in one line: what is printed and what is used.
pub(super) fn erratum(book: &Book<'_>, e: &Erratum) -> String {
    format!(
        "Erratum {}: {} {} is printed {}; {}. How sure: {}. {}",
        book.erratum(e),
        book.text(&e.at),
        book.code(&e.field),
        value(book, e, &e.was),
        outcome(book, e),
        e.sure.word(),
        book.prose(&e.why)
    )
}
