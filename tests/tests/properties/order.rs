//! The order of files, tables, rows and keys means nothing, nor do line ends, a byte order mark or how a path is written.

use std::fmt::Write;
use std::path::Path;

use drivewright_codegen::diag::Sink;
use drivewright_codegen::load;
use drivewright_codegen::raw::{self, RawValue};
use drivewright_codegen::source::{Source, SourceMap};
use drivewright_tests::cases::{golden_cases, toml_files};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;

use super::{Outcome, cases, difference, run, source};

const FILES: [&str; 4] = ["z.toml", "B.toml", "a/1.toml", "a\\0.toml"];

struct Profile {
    name: String,
    sources: Vec<Source>,
}

/// A row: its table, and its keys with their values as TOML.
#[derive(Clone, Debug)]
struct Row {
    table: String,
    fields: Vec<String>,
}

fn golden() -> Vec<Profile> {
    golden_cases().into_iter().map(|c| Profile { name: c.name, sources: c.sources }).collect()
}

fn real() -> Profile {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../profiles/savch/sdv3-e");
    Profile { name: "sdv3-e".into(), sources: load::folder(&folder).sources }
}

/// Profiles with findings, most of them not sound.
fn wrong() -> Vec<Profile> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("diagnostics");
    let shared = toml_files(&folder.join("shared"));
    let profile = |case: Source| {
        let name = case.path.clone();
        let own = if case.text.contains("[drive]") { Vec::new() } else { shared.clone() };
        Profile { name, sources: own.into_iter().chain([case]).collect() }
    };
    toml_files(&folder).into_iter().map(profile).collect()
}

/// The rows of a profile; `None` where some of it is not TOML or no value that a row takes, and could not be written anew.
fn rows(sources: &[Source]) -> Option<Vec<Row>> {
    let (mut map, mut sink, mut rows) = (SourceMap::default(), Sink::default(), Vec::new());
    for source in sources {
        let file = map.add(&source.path, &source.text);
        for table in raw::toml::read(file, &map, &mut sink) {
            for row in table.rows {
                let field = |f: &raw::RawField| Some(format!("{} = {}", f.key.value, toml(&f.value.value)?));
                let fields = row.fields.iter().map(field).collect::<Option<_>>()?;
                rows.push(Row { table: table.name.value.clone(), fields });
            }
        }
    }
    sink.as_slice().is_empty().then_some(rows)
}

fn toml(value: &RawValue) -> Option<String> {
    match value {
        RawValue::Text(text) => Some(quoted(text)),
        RawValue::Int(n) => Some(n.to_string()),
        RawValue::Bool(b) => Some(b.to_string()),
        RawValue::List(items) => {
            let items: Option<Vec<String>> = items.iter().map(|i| toml(&i.value)).collect();
            Some(format!("[{}]", items?.join(", ")))
        }
        RawValue::Other(_) | RawValue::Reported => None,
    }
}

/// A TOML string in ASCII.
pub(crate) fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            ' ' | '!' | '#'..='[' | ']'..='~' => out.push(c),
            c => drop(write!(out, "\\U{:08X}", u32::from(c))),
        }
    }
    out + "\""
}

/// The same rows in any order, spread over files, the keys of each in any order, and the files in any order.
fn arrangements(rows: &[Row]) -> impl Strategy<Value = Vec<Source>> + use<> {
    let row = |row: &Row| (Just(row.table.clone()), Just(row.fields.clone()).prop_shuffle());
    let places = vec(0..FILES.len(), rows.len());
    let rows: Vec<_> = rows.iter().map(row).collect();
    (rows.prop_shuffle(), places, Just(FILES.to_vec()).prop_shuffle()).prop_map(|(rows, places, order)| {
        let file = |path: &str| {
            let here = rows.iter().zip(&places).filter(|(_, place)| FILES[**place] == path);
            source(path, written(here.map(|(row, _)| row)))
        };
        order.iter().map(|path| file(path)).collect()
    })
}

/// A file of rows, each table where its first row is.
fn written<'a>(rows: impl Iterator<Item = &'a (String, Vec<String>)>) -> String {
    let mut tables: Vec<(&str, String)> = Vec::new();
    for (table, fields) in rows {
        let row = format!("{{ {} }},\n", fields.join(", "));
        match tables.iter_mut().find(|(name, _)| name == table) {
            Some((_, text)) => text.push_str(&row),
            None => tables.push((table, row)),
        }
    }
    tables.iter().flat_map(|(name, rows)| [name, " = [\n", rows, "]\n"]).collect()
}

/// Compares each arrangement of a profile with the profile as it lies in its folder. False where it has no rows.
fn same_in_any_order(profile: &Profile, tried: u32) -> bool {
    let Some(rows) = rows(&profile.sources) else { return false };
    let wanted = run(profile.sources.clone());
    let check = |sources: Vec<Source>| match difference(&run(sources), &wanted) {
        Some(found) => Err(TestCaseError::fail(found)),
        None => Ok(()),
    };
    if let Err(error) = TestRunner::new(cases(tried)).run(&arrangements(&rows), check) {
        panic!("{}: {error}", profile.name);
    }
    true
}

#[test]
fn golden_profiles_in_any_order() {
    let tried = golden().iter().filter(|profile| same_in_any_order(profile, 6)).count();
    assert_eq!(tried, golden().len(), "a sound profile can be written anew");
}

#[test]
fn a_real_profile_in_any_order() {
    assert!(same_in_any_order(&real(), 4));
}

#[test]
fn findings_in_any_order() {
    let tried = wrong().iter().filter(|profile| same_in_any_order(profile, 6)).count();
    assert!(tried >= 50, "only {tried} profiles could be written anew");
}

/// What a change of every text of a profile does to its result.
fn changed(profile: &Profile, change: impl Fn(&Source) -> Source) -> Option<String> {
    let result: Outcome = run(profile.sources.iter().map(change).collect());
    difference(&result, &run(profile.sources.clone()))
}

#[test]
fn bytes_that_mean_nothing() {
    for profile in golden().into_iter().chain([real()]).chain(wrong()) {
        let lines = changed(&profile, |s| source(&s.path, s.text.replace('\n', "\r\n")));
        assert_eq!(lines, None, "{} with CR/LF", profile.name);
        let mark = changed(&profile, |s| source(&s.path, format!("\u{FEFF}{}", s.text)));
        assert_eq!(mark, None, "{} with a byte order mark", profile.name);
        let folder = changed(&profile, |s| source(&format!("x1\\{}", s.path), s.text.as_str()));
        assert_eq!(folder, None, "{} below a folder with `\\`", profile.name);
    }
}

#[test]
fn bytes_that_mean_something() {
    let profile = real();
    let twice = changed(&profile, |s| source(&s.path, format!("\u{FEFF}\u{FEFF}{}", s.text)));
    assert!(twice.expect("a finding").contains("E0101"), "a second byte order mark is no TOML");
    let name =
        changed(&profile, |s| source(&s.path, s.text.replacen("Profile Velocity", "Profile velocity", 1)));
    assert!(name.expect("a difference").contains("velocity"));
}

/// Rows may spell the name of their table in several ways, of which one is chosen; and rows without a number have an
/// order all the same.
#[test]
fn one_choice_in_any_order() {
    let rows = r#"
enums = [ { name = "State of drive", value = 0, label = "off", src = "L1" }, { name = "state_of_drive", value = 1, label = "on", src = "L1" } ]
bits = [ { name = "Ctl", bit = 1, label = "run", src = "L1" }, { name = "CTL", bit = 0, label = "stop", src = "L1" } ]
homing = [
  { method = 7, when = "home off", moves = "+ fast until home on; - slow until home off; latch", text = "From the home.", src = "L2" },
  { method = 7, when = "home on", moves = "- slow until home off; latch", src = "L2" },
]
io = [ { terminal = "CN1", kind = "port", src = "L1" }, { terminal = "CN2", kind = "port", src = "L1" } ]
"#;
    let sources = vec![source("drive.toml", super::DRIVE), source("rows.toml", rows)];
    assert!(!run(sources.clone()).files.is_empty(), "{:#?}", run(sources).findings);
    assert!(same_in_any_order(&Profile { name: "choices".into(), sources }, 20));
}
