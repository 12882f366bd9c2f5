//! E1303: the number of a parameter does not go with its object.

use std::collections::BTreeMap;

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Address, Model};
use crate::source::Span;

const CODE: Code = Code::error("E1303", "the number of a parameter does not go with its object");
const WHY: &str = "a drive numbers its parameters by one rule, so that one which stands elsewhere would set another parameter";
const HELP: &str = "look for a number that is decimal in one place and hexadecimal in the other; if the manual prints it so, add an erratum";

/// Compares the parameters of a drive, of its objects and of its examples: one index for each group, one distance between number and sub-index, no number twice.
pub(in crate::check) const LINT: Lint =
    Lint { code: CODE, page: include_str!("parameters_in_place.md"), run };

/// A parameter with the place that a row gives it.
struct Place<'m> {
    row: String,
    span: Span,
    text: &'m str,
    address: Address,
}

/// A group of parameters: its letters and its number.
type Group<'m> = (&'m str, u16);

/// A parameter whose number has a group, with its distance from the sub-index.
struct Member<'a> {
    place: &'a Place<'a>,
    group: Group<'a>,
    distance: i32,
}

fn run(model: &Model, sink: &mut Sink) {
    let objects: Vec<Place<'_>> = objects(model).collect();
    let examples: Vec<Place<'_>> = examples(model).collect();
    let members: Vec<Member<'_>> = objects.iter().chain(&examples).filter_map(member).collect();
    for (place, wrong) in twice(&objects).into_iter().chain(out_of_place(&members)) {
        let text = format!("`{}` is {}, {wrong}", place.row, place.text);
        sink.push(super::finding(CODE, place.span, &place.row, text, WHY, HELP));
    }
}

fn objects(model: &Model) -> impl Iterator<Item = Place<'_>> {
    model.entries.iter().filter_map(|(_, entry)| {
        let fact = super::unsettled(entry.parameter.as_ref())?;
        let row = entry.address.to_string();
        Some(Place { row, span: fact.span(), text: &fact.value, address: entry.address })
    })
}

fn examples(model: &Model) -> impl Iterator<Item = Place<'_>> {
    model.examples.iter().filter_map(|example| {
        let (fact, entry) =
            (super::unsettled(example.parameter.as_ref())?, super::unsettled(example.entry.as_ref())?);
        let row = format!("example {}", example.label());
        Some(Place { row, span: fact.span(), text: &fact.value, address: entry.value })
    })
}

/// Splits `P1.52` and `H0205` into letters, group and number; other forms have no group.
fn member<'a>(place: &'a Place<'_>) -> Option<Member<'a>> {
    let (letters, digits) = place.text.split_at(place.text.find(|c: char| !c.is_ascii_alphabetic())?);
    let plain = digits.len() == 4 && digits.bytes().all(|b| b.is_ascii_digit());
    let (group, number) = if plain { digits.split_at(2) } else { digits.split_once('.')? };
    let (group, number): (u16, u8) = (group.parse().ok()?, number.parse().ok()?);
    let distance = i32::from(place.address.sub) - i32::from(number);
    (!letters.is_empty()).then_some(Member { place, group: (letters, group), distance })
}

/// Parameters that a second object has.
fn twice<'a>(places: &'a [Place<'a>]) -> Vec<(&'a Place<'a>, String)> {
    let mut seen: BTreeMap<&str, Address> = BTreeMap::new();
    let again = |place: &'a Place<'a>| {
        let first = *seen.entry(place.text).or_insert(place.address);
        (first != place.address).then(|| (place, format!("and so is {first}")))
    };
    places.iter().filter_map(again).collect()
}

/// Parameters that stand elsewhere than the others of the drive.
fn out_of_place<'a>(members: &[Member<'a>]) -> Vec<(&'a Place<'a>, String)> {
    let index = |m: &Member<'_>| m.place.address.index;
    let indexes = usual(members.iter().map(|m| (m.group, index(m))));
    let groups = usual(members.iter().map(|m| (index(m), m.group)));
    let distances = usual(members.iter().map(|m| ((), m.distance)));
    let wrong = |m: &Member<'a>| {
        let (home, distance) = (*indexes.get(&m.group)?, *distances.get(&())?);
        let (letters, group) = *groups.get(&index(m))?;
        if home != index(m) {
            return Some(format!("whose group is at {home:04X}h"));
        }
        if (letters, group) != m.group {
            return Some(format!("and its index is that of group {letters}{group}"));
        }
        (m.distance != distance).then(|| {
            format!("and its sub-index differs from its number by {}, not by {distance}", m.distance)
        })
    };
    members.iter().filter_map(|m| Some((m.place, wrong(m)?))).collect()
}

/// What most pairs have for each key; of several the lowest.
fn usual<K: Ord, V: Ord + Copy>(pairs: impl Iterator<Item = (K, V)>) -> BTreeMap<K, V> {
    let mut counts: BTreeMap<K, BTreeMap<V, usize>> = BTreeMap::new();
    for (key, value) in pairs {
        *counts.entry(key).or_default().entry(value).or_default() += 1;
    }
    let most = |values: BTreeMap<V, usize>| values.into_iter().rev().max_by_key(|(_, n)| *n).map(|(v, _)| v);
    counts.into_iter().filter_map(|(key, values)| Some((key, most(values)?))).collect()
}
