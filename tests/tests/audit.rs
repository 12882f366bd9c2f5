//! The audit judged: facts of a real drive are changed one at a time, and it must see it.
//!
//! The makers' manuals are no part of the project: without `DRIVEWRIGHT_MANUALS` this is skipped, and said.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "a test reads files")]

use std::path::Path;

use drivewright_codegen::audit::{Contradiction, Finding, Kind, audit, contradictions, facts_hash};
use drivewright_codegen::facts::{FactLine, Table, facts};
use drivewright_codegen::model::{Address, Cite, Class, Model};
use drivewright_codegen::{Compiled, compile, load};
use drivewright_tests::random::Random;
use drivewright_tests::{drives, skipped};

const CHANGES: usize = 2000;

/// The text of a drive's manual.
fn manual(drive: &str) -> Option<String> {
    let Some(folder) = std::env::var_os("DRIVEWRIGHT_MANUALS") else {
        skipped(
            &format!("audit of {drive}"),
            "DRIVEWRIGHT_MANUALS names no folder with the text of the manual",
        );
        return None;
    };
    let file = Path::new(&folder).join(format!("{drive}.txt"));
    let Ok(text) = std::fs::read_to_string(&file) else {
        skipped(&format!("audit of {drive}"), &format!("{} is not there", file.display()));
        return None;
    };
    Some(text)
}

/// Every drive with its id.
fn profiles() -> impl Iterator<Item = (String, Compiled)> {
    drives::all().into_iter().map(|folder| {
        let compiled = compile(load::folder(&folder).sources);
        (compiled.model.as_ref().expect("a model").drive.id.clone(), compiled)
    })
}

/// How a fact is changed; `None` where it cannot be in this way.
fn changed(
    kind: usize,
    at: usize,
    all: &[FactLine<'_>],
    random: &mut Random,
) -> Option<(String, Option<Cite>)> {
    let fact = &all[at];
    let value = match kind {
        0 => digit(&fact.value, random)?,
        1 => sign(&fact.value)?,
        2 => all[at + 1..].iter().find(|f| f.table == fact.table && f.field == fact.field)?.value.clone(),
        3 => {
            let row: Vec<_> = all.iter().filter(|f| f.key == fact.key && f.class.is_some()).collect();
            row[random.below(row.len())].value.clone()
        }
        _ => return Some((fact.value.clone(), Some(elsewhere(fact.cite?, random)))),
    };
    (value != fact.value).then_some((value, None))
}

fn digit(value: &str, random: &mut Random) -> Option<String> {
    let start = if value.starts_with("0x") { 2 } else { 0 };
    let places: Vec<usize> =
        value.char_indices().filter(|(n, c)| *n >= start && c.is_ascii_digit()).map(|(n, _)| n).collect();
    let place = *places.get(random.below(places.len().max(1)))?;
    let old = value.as_bytes()[place] - b'0';
    let new = (usize::from(old) + 1 + random.below(9)) % 10;
    Some(format!("{}{new}{}", &value[..place], &value[place + 1..]))
}

fn sign(value: &str) -> Option<String> {
    let number: i128 = value.parse().ok()?;
    (number != 0).then(|| (-number).to_string())
}

/// The citation with one of its lines moved by up to five.
fn elsewhere(cite: &Cite, random: &mut Random) -> Cite {
    let mut cite = cite.clone();
    let place = random.below(cite.places.len());
    let lines = &mut cite.places[place].lines;
    let line = random.below(lines.len());
    let step = u32::try_from(1 + random.below(5)).expect("small");
    lines[line] =
        if random.below(2) == 0 { lines[line] + step } else { lines[line].saturating_sub(step).max(1) };
    cite
}

/// What the audit holds against the row of a fact, with the fact as changed.
fn found(
    compiled: &Compiled,
    all: &[FactLine<'_>],
    at: usize,
    value: &str,
    cite: Option<&Cite>,
    text: &str,
) -> bool {
    let model = compiled.model.as_ref().expect("a model");
    if names_no_object(model, value) {
        return true;
    }
    let row = |fact: &&FactLine<'_>| fact.key.split('.').next() == all[at].key.split('.').next();
    let lines: Vec<FactLine<'_>> = all
        .iter()
        .filter(row)
        .map(|fact| {
            let here = fact.key == all[at].key;
            // A row has one citation: all its facts move with it.
            let cite = cite.filter(|_| here && fact.cite == all[at].cite).or(fact.cite);
            let value = if here && fact.field == all[at].field { value } else { &fact.value };
            FactLine { value: value.to_owned(), cite, ..fact.clone() }
        })
        .collect();
    let report = audit(model, &lines, &compiled.rows, "m1", text).expect("the manual");
    report.open().any(|f| {
        matches!(f.kind, Kind::Unproved | Kind::IdleLine | Kind::NotCited) && !f.at.starts_with("erratum")
    })
}

/// Whether an address in `value` is none of the drive: `check` refuses such a rule (E0308) before anybody audits it.
fn names_no_object(model: &Model, value: &str) -> bool {
    let hex =
        |text: &str, digits| (text.len() == digits).then(|| u32::from_str_radix(text, 16).ok()).flatten();
    let address = |word: &str| {
        let (index, sub) = word.split_once(':')?;
        let index = u16::try_from(hex(index, 4)?).ok()?;
        Some(Address::new(index, u8::try_from(hex(sub, 2)?).ok()?))
    };
    let words = value.split(|c: char| !c.is_ascii_hexdigit() && c != ':');
    words.filter_map(address).any(|address| model.entry(address).is_none())
}

/// Facts that a manual states in its own words.
fn provable(fact: &FactLine<'_>) -> bool {
    let worded = matches!(
        (fact.table, fact.field.as_ref()),
        (Table::Rules, "text" | "on" | "when")
            | (Table::Aborts, "name")
            | (Table::Terminals, "kind")
            | (Table::Homing, "status")
            | (Table::Objects, "values" | "bits")
    );
    let told = fact.field.starts_with("cause") || fact.field.starts_with("remedy");
    matches!(fact.class, Some(Class::Stated)) && fact.cite.is_some() && !worded && !told
}

#[test]
fn a_changed_fact_is_seen() {
    for (drive, compiled) in profiles() {
        let Some(text) = manual(&drive) else { continue };
        let all = facts(compiled.model.as_ref().expect("a model"));
        let places: Vec<usize> = (0..all.len()).filter(|n| provable(&all[*n])).collect();
        let mut random = Random::new(2026);
        let (mut made, mut survivors) = (0, Vec::new());
        while made < CHANGES {
            let at = places[random.below(places.len())];
            let Some((value, cite)) = changed(random.below(5), at, &all, &mut random) else { continue };
            made += 1;
            if !found(&compiled, &all, at, &value, cite.as_ref(), &text) {
                let moved = cite.map_or_else(String::new, |c| format!(" at {c}"));
                survivors
                    .push(format!("{} {}: {} -> {value}{moved}", all[at].key, all[at].field, all[at].value));
            }
        }
        println!("{drive}: {} of {made} changes seen; not seen: {survivors:#?}", made - survivors.len());
        assert!(survivors.len() * 100 <= made, "{drive}: {survivors:#?}");
    }
}

/// Runs without the manuals: facts that changed need a new audit.
#[test]
fn the_record_is_of_these_facts() {
    for (drive, compiled) in profiles() {
        let model = compiled.model.as_ref().expect("a model");
        let [record] = compiled.rows.audited.as_slice() else { panic!("{drive} has no `audit.toml`") };
        assert_eq!(record.extract.value.0, model.manuals[0].sha256, "{drive}: another extract was audited");
        let help = format!("facts of {drive} have changed: run `drivewright audit {drive} --record`");
        assert_eq!(record.facts.value.0, facts_hash(&facts(model)), "{help}");
    }
}

#[test]
fn nothing_is_open_and_the_record_has_the_counts() {
    for (drive, compiled) in profiles() {
        let Some(text) = manual(&drive) else { continue };
        let all = facts(compiled.model.as_ref().expect("a model"));
        let report =
            audit(compiled.model.as_ref().expect("a model"), &all, &compiled.rows, "m1", &text).expect("it");
        assert_eq!(report.open().collect::<Vec<_>>(), Vec::<&Finding>::new());
        let model = compiled.model.as_ref().expect("a model");
        let differing = contradictions(model, &all, &compiled.rows, "m1", &text);
        assert!(!differing.is_empty() && differing.iter().all(Contradiction::settled), "{differing:#?}");
        let record = &compiled.rows.audited[0];
        assert_eq!(record.proved.value as usize, report.proved);
        assert_eq!(record.accepted.value as usize, report.accepted());
    }
}
