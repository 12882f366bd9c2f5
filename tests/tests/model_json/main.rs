//! `model.json`, read as any program reads it, says what the list of facts says.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod behaviour;
mod dictionary;

use std::collections::BTreeSet;

use drivewright_codegen::backend::json::Json;
use drivewright_codegen::emit;
use drivewright_codegen::facts::{FactLine, facts};
use drivewright_codegen::model::{Class, Model};
use drivewright_tests::cases::golden_cases;
use serde_json::Value;

/// The model as other programs see it.
fn read(model: &Model) -> Value {
    let (files, findings) = emit(model, &[&Json]);
    assert_eq!(findings, []);
    serde_json::from_slice(files.get("model.json").expect("the file")).expect("JSON")
}

fn list(value: &Value) -> &[Value] {
    value.as_array().expect("a list")
}

/// Reads every row of a table.
fn each(rows: &Value, read: impl FnMut(&Value)) {
    list(rows).iter().for_each(read);
}

fn text(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

/// Texts or numbers with blanks between.
fn joined(values: &Value) -> String {
    list(values).iter().map(text).collect::<Vec<_>>().join(" ")
}

/// A fact in one line.
type Line = String;

/// Facts of rows, collected from the file.
#[derive(Default)]
struct Lines(BTreeSet<Line>);

impl Lines {
    /// A value as `shown`, with what `fact` says of where it comes from.
    fn put(&mut self, key: &str, field: &str, fact: &Value, shown: &str) {
        let said = |name: &str| fact[name].as_str().unwrap_or("");
        let detail = ["rule", "base", "reason"].into_iter().map(said).find(|t| !t.is_empty()).unwrap_or("");
        let parts = [key, field, shown, said("class"), detail, said("cite"), said("erratum")];
        assert!(self.0.insert(parts.join(" | ")), "twice: {parts:?}");
    }

    fn fact(&mut self, key: &str, field: &str, fact: &Value) {
        if !fact.is_null() {
            self.put(key, field, fact, &text(&fact["value"]));
        }
    }

    /// Facts of `row` whose keys in the file are their fields.
    fn facts(&mut self, key: &str, row: &Value, fields: &[&str]) {
        for field in fields {
            self.fact(key, field, &row[field]);
        }
    }

    /// Values of `row` that are the profile's own.
    fn own(&mut self, key: &str, row: &Value, fields: &[&str]) {
        for field in fields.iter().filter(|field| !row[**field].is_null()) {
            self.put(key, field, &Value::Null, &text(&row[field]));
        }
    }

    fn words(&mut self, key: &str, field: &str, fact: &Value) {
        if !fact.is_null() {
            self.put(key, field, fact, &joined(&fact["value"]));
        }
    }

    fn hex(&mut self, key: &str, field: &str, fact: &Value, digits: usize) {
        if !fact.is_null() {
            let n = fact["value"].as_u64().expect("a number");
            self.put(key, field, fact, &format!("0x{n:0digits$X}"));
        }
    }

    fn hex_list(&mut self, key: &str, field: &str, fact: &Value) {
        if !fact.is_null() {
            let words = list(&fact["value"]).iter().map(|n| n.as_u64().expect("a number"));
            let texts: Vec<String> = words.map(|n| format!("0x{n:04X}")).collect();
            self.put(key, field, fact, &texts.join(" "));
        }
    }
}

fn from_json(json: &Value) -> BTreeSet<Line> {
    let mut lines = Lines::default();
    dictionary::tables(json, &mut lines);
    behaviour::tables(json, &mut lines);
    lines.0
}

/// Lines of the list. Names of code are left out: the file has them, as handles, whether they are the printed ones or not.
fn from_facts(lines: &[FactLine<'_>]) -> BTreeSet<Line> {
    let lines = lines.iter().filter(|line| line.field != "rename");
    lines
        .map(|line| {
            let cite = line.cite.map(ToString::to_string).unwrap_or_default();
            let parts = [
                line.key.as_str(),
                &line.field,
                &line.value,
                line.class.map_or("", Class::word),
                line.class.and_then(Class::detail).unwrap_or(""),
                &cite,
                line.erratum.unwrap_or(""),
            ];
            parts.join(" | ")
        })
        .collect()
}

#[test]
fn the_file_and_the_facts_agree() {
    for case in golden_cases() {
        let model = case.model();
        assert_eq!(from_json(&read(&model)), from_facts(&facts(&model)), "{}", case.name);
    }
}

/// Every number that a reader derives nothing from is right by itself: addresses, offsets, factors.
#[test]
fn derived_numbers_are_right() {
    for case in golden_cases() {
        let json = read(&case.model());
        for object in list(&json["objects"]) {
            assert_eq!(format!("{:04X}", object["index"].as_u64().expect("a number")), text(&object["at"]));
            for entry in list(&object["entries"]) {
                let (index, sub) = (entry["index"].as_u64(), entry["sub"].as_u64());
                let at = format!("{:04X}:{:02X}", index.expect("a number"), sub.expect("a number"));
                assert_eq!(at, text(&entry["at"]));
                assert_eq!(entry["width"].as_u64(), width(&text(&entry["type"]["value"])), "{at}");
            }
        }
        for abort in list(&json["aborts"]) {
            assert_eq!(format!("{:08X}", abort["code"].as_u64().expect("a number")), text(&abort["at"]));
        }
        for pdo in list(&json["pdos"]) {
            let mut offset = 0;
            for entry in list(&pdo["entries"]) {
                assert_eq!(entry["byte"].as_u64().zip(entry["bit"].as_u64()), Some((offset / 8, offset % 8)));
                offset += entry["bits"]["value"].as_u64().expect("a number");
            }
            assert_eq!(pdo["bits"].as_u64().zip(pdo["bytes"].as_u64()), Some((offset, offset.div_ceil(8))));
        }
    }
}

/// The width that a type's word says.
fn width(word: &str) -> Option<u64> {
    match word {
        "bool" => Some(1),
        "time" | "time_difference" => Some(48),
        number => number.strip_prefix(['i', 'u', 'f']).and_then(|n| n.parse().ok()),
    }
}

#[test]
fn large_numbers_are_texts_and_others_are_not() {
    let case = golden_cases().into_iter().find(|c| c.name == "integers-64").expect("the case");
    let json = read(&case.model());
    let entry = |n: usize| &json["objects"][n]["entries"][0];
    assert_eq!(entry(0)["min"]["value"], "-9223372036854775808");
    assert_eq!(entry(0)["default"]["value"], "-9007199254740992");
    assert_eq!(entry(1)["allow"]["value"][0], 9_007_199_254_740_991_u64);
    assert_eq!(entry(1)["allow"]["value"][1], "9007199254740992");
    assert_eq!(entry(1)["min"]["value"], 0);
}
