//! Objects with their entries: a table with a row for each entry, and what does not fit into a cell below it.

use serde::Serialize;

use super::book::{Book, entry_anchor, mark};
use super::fold::{runs, subs};
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
    let runs = runs(book.model, object);
    let single = object.entries.len() == 1;
    let kind = book.marked(object.kind.value.word(), &[&object.kind.origin]);
    let name = if single {
        book.name(&object.name.value)
    } else {
        book.marked(&book.name(&object.name.value), &[&object.name.origin])
    };
    ObjectView {
        anchor: book.anchored(&format!("{:04x}", object.index)),
        index: format!("{:04X}h", object.index),
        name: if single { runs.first().map_or(name, |run| book.text(&run[0].name.value)) } else { name },
        kind: if single { String::new() } else { kind },
        texts: texts(book, object, &runs),
        table: Table::of(&HEAD, runs.iter().map(|run| row(book, run))).text(book.plain),
        items: items(book, object, &runs),
        errata: errata(book, object),
        meanings: meanings::of(book, object),
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
    let sub = book.anchored(&entry_anchor(entry.address)) + &subs(run);
    let [name, ty, access, pdo, unit, range, default, manual] = values(book, entry);
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
    let shown = match (&fact.value, mapped(entry)) {
        (Value::Int(n), true) if *n > 0xFFFF => {
            let at = Address::new((*n >> 16 & 0xFFFF) as u16, (*n >> 8 & 0xFF) as u8);
            format!("{n:08X}h ({}, {} bits)", book.address(at), *n & 0xFF)
        }
        _ => prose::default(entry, names, book.escape()).unwrap_or_default(),
    };
    book.marked(&shown, &[&fact.origin])
}

/// Whether its value is a mapping word: index, sub-index and length of a mapped entry.
fn mapped(entry: &Entry) -> bool {
    let index = entry.address.index;
    let mapping = (0x1600..0x1800).contains(&index) || (0x1A00..0x1C00).contains(&index);
    mapping && entry.address.sub > 0 && entry.ty.value == Type::int(false, 32)
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
struct Items {
    /// What is said, with the entries of which it is said.
    said: Vec<(String, Vec<String>)>,
}

impl Items {
    fn say(&mut self, what: String, of: String) {
        match self.said.iter_mut().find(|(known, _)| *known == what) {
            Some((_, all)) if all.last() == Some(&of) => {}
            Some((_, all)) => all.push(of),
            None => self.said.push((what, vec![of])),
        }
    }
}

fn items(book: &Book<'_>, object: &Object, runs: &[Vec<&Entry>]) -> Vec<String> {
    let mut items = Items { said: Vec::new() };
    items.said.extend(whole(book, object).into_iter().map(|said| (said, Vec::new())));
    for run in runs {
        let of = subs(run);
        let told =
            |text: &Option<String>, before: &str| text.as_ref().map(|t| format!("{before}{}", book.prose(t)));
        // What an object with one row is for stands above its table.
        let text = if runs.len() == 1 { None } else { told(&run[0].text, "") };
        let notes =
            [text, told(&run[0].note, "Note: "), told(&run[0].deviation, "Deviates from the standard: ")];
        let effect = run[0].effect.as_ref().map(|e| {
            let when = prose::effect(e.value);
            let when = if book.plain { when.replace('*', "") } else { when.to_owned() };
            book.marked(&format!("A new value takes effect {when}."), &[&e.origin])
        });
        for said in notes.into_iter().flatten().chain(effect) {
            items.say(said, of.clone());
        }
        for (what, reason) in known(book, run[0]) {
            items.say(reason, format!("{what} of {of}"));
        }
    }
    let single = runs.len() == 1;
    items.said.into_iter().map(|(said, of)| item(&said, &of, single)).collect()
}

/// `01, 03: said`; without the sub-indexes where there is one row only.
fn item(said: &str, of: &[String], single: bool) -> String {
    let of: Vec<String> = if single {
        let whats = of.iter().filter_map(|o| o.split_once(" of ").map(|(what, _)| what.to_owned()));
        whats.collect()
    } else {
        of.to_vec()
    };
    if of.is_empty() { said.to_owned() } else { format!("{}: {said}", of.join(", ")) }
}

/// What to know of the object as a whole.
fn whole(book: &Book<'_>, object: &Object) -> Vec<String> {
    let note = object.note.as_ref().map(|n| format!("Note: {}", book.prose(n)));
    let deviation =
        object.deviation.as_ref().map(|d| format!("Deviates from the standard: {}", book.prose(d)));
    let also = object.also.as_ref().map(|a| format!("Printed again: {}.", book.text(&a.to_string())));
    [note, deviation, also].into_iter().flatten().collect()
}

/// Reasons of values that the manual does not state, and places of those that stand elsewhere than the row.
fn known(book: &Book<'_>, entry: &Entry) -> Vec<(&'static str, String)> {
    let row = row_cite(entry);
    let said = |(what, origin): (&'static str, &Origin)| match (&origin.class, &origin.cite) {
        // That of an erratum stands with the erratum.
        (Class::Inferred(_), _) if origin.erratum.is_some() => None,
        (Class::Inferred(rule) | Class::Assumed(rule), _) => {
            let text = book.prose(rule.trim_end_matches('.'));
            Some((what, format!("{} {}: {text}.", mark(&origin.class), origin.class.word())))
        }
        (Class::Stated, cite) if cite.is_some() && cite.as_ref() != row => {
            Some((what, format!("printed in {}.", book.cite(cite.as_ref()))))
        }
        _ => None,
    };
    facts(entry).into_iter().filter_map(said).collect()
}

/// Errata of the object and of its entries.
fn errata(book: &Book<'_>, object: &Object) -> Vec<String> {
    book.errata_of(object.index).map(|e| erratum(book, e)).collect()
}

/// An erratum in one line: what is printed and what is used.
pub(super) fn erratum(book: &Book<'_>, e: &Erratum) -> String {
    format!(
        "Erratum {}: {} `{}` is printed {}; {}. How sure: {}. {}",
        book.erratum(e),
        book.text(&e.at),
        e.field,
        book.text(&e.was),
        e.outcome(book.escape()),
        e.sure.word(),
        book.prose(&e.why)
    )
}
