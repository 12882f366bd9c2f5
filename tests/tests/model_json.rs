//! `model.json`, read as any program reads it, says what the list of facts says.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeSet;

use drivewright_codegen::backend::json::Json;
use drivewright_codegen::emit;
use drivewright_codegen::facts::{FactLine, facts};
use drivewright_codegen::model::Model;
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

fn text(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

/// A fact in one line.
type Line = String;

/// Facts of rows, collected from the file.
#[derive(Default)]
struct Lines(BTreeSet<Line>);

impl Lines {
    fn put(&mut self, key: &str, field: &str, fact: &Value, shown: &str) {
        let detail = ["rule", "base", "reason"].iter().find_map(|k| fact[k].as_str());
        let parts = [
            key,
            field,
            shown,
            &text(&fact["class"]),
            detail.unwrap_or(""),
            fact["cite"].as_str().unwrap_or(""),
            fact["erratum"].as_str().unwrap_or(""),
        ];
        assert!(self.0.insert(parts.join(" | ")), "twice: {parts:?}");
    }

    fn fact(&mut self, key: &str, field: &str, fact: &Value) {
        if !fact.is_null() {
            self.put(key, field, fact, &text(&fact["value"]));
        }
    }

    fn hex(&mut self, key: &str, field: &str, fact: &Value, digits: usize) {
        if !fact.is_null() {
            let n = fact["value"].as_u64().expect("a number");
            self.put(key, field, fact, &format!("0x{n:0digits$X}"));
        }
    }
}

fn from_json(json: &Value) -> BTreeSet<Line> {
    let mut lines = Lines::default();
    for field in ["pdo_entries", "pdo_bytes", "pdos_per_direction"] {
        lines.fact("drive", field, &json["drive"][field]);
    }
    for each in list(&json["objects"]) {
        object(each, &mut lines);
    }
    for table in list(&json["enums"]) {
        for value in list(&table["values"]) {
            let key = format!("enum {} {}", text(&table["name"]), text(&value["value"]));
            lines.fact(&key, "label", &value["name"]);
        }
    }
    for table in list(&json["bits"]) {
        for field in list(&table["fields"]) {
            bits(&text(&table["name"]), field, &mut lines);
        }
    }
    for each in list(&json["alarms"]) {
        alarm(each, &mut lines);
    }
    for each in list(&json["pdos"]) {
        pdo(each, &mut lines);
    }
    lines.0
}

fn object(object: &Value, lines: &mut Lines) {
    let (key, entries) = (format!("object {}", text(&object["at"])), list(&object["entries"]));
    if entries.len() != 1 || entries[0]["sub"] != 0 {
        lines.fact(&key, "name", &object["name"]);
    }
    lines.fact(&key, "kind", &object["kind"]);
    for entry in entries {
        let key = format!("object {}", text(&entry["at"]));
        for field in ["name", "type", "access", "pdo", "min", "max", "default", "values", "bits"] {
            lines.fact(&key, field, &entry[field]);
        }
        if let Some(unit) = entry.get("unit") {
            lines.put(&key, "unit", unit, &text(&unit["value"]["text"]));
        }
        if let Some(default) = entry.get("default_text") {
            lines.put(&key, "default", default, &format!("\"{}\"", text(&default["value"])));
        }
        if let Some(allow) = entry.get("allow") {
            let numbers: Vec<String> = list(&allow["value"]).iter().map(text).collect();
            lines.put(&key, "allow", allow, &format!("[{}]", numbers.join(", ")));
        }
    }
}

fn bits(table: &str, field: &Value, lines: &mut Lines) {
    let mode = field.get("mode").map_or_else(String::new, |m| format!(" mode {m}"));
    let key = format!("bits {table} {}{mode}", field["bit"]);
    lines.fact(&key, "label", &field["name"]);
    if field["width"] != 1 {
        lines.put(&key, "width", &field["name"], &field["width"].to_string());
    }
}

fn alarm(alarm: &Value, lines: &mut Lines) {
    let key = format!("alarm {}", text(&alarm["key"]));
    lines.fact(&key, "name", &alarm["name"]);
    lines.fact(&key, "reset", &alarm["reset"]);
    lines.hex(&key, "number", &alarm["number"], 2);
    lines.hex(&key, "code", &alarm["code"], 4);
    lines.hex(&key, "aux", &alarm["aux"], 4);
    for (word, texts) in [("cause", &alarm["causes"]), ("remedy", &alarm["remedies"])] {
        for (n, cause) in (1..).zip(list(texts)) {
            lines.fact(&key, &format!("{word} {n}"), cause);
        }
    }
}

fn pdo(pdo: &Value, lines: &mut Lines) {
    let key = format!("pdo {}", text(&pdo["at"]));
    lines.fact(&key, "dir", &pdo["direction"]);
    for entry in list(&pdo["entries"]) {
        let key = format!("{key} {}", entry["position"]);
        lines.fact(&key, "entry", &entry["entry"]);
        lines.fact(&key, "bits", &entry["bits"]);
    }
}

fn from_facts(lines: &[FactLine<'_>]) -> BTreeSet<Line> {
    let known = lines.iter().filter_map(|line| line.class.map(|class| (line, class)));
    known
        .map(|(line, class)| {
            let cite = line.cite.map(ToString::to_string).unwrap_or_default();
            let detail = class.detail().unwrap_or("");
            let parts = [
                &line.key,
                &*line.field,
                &line.value,
                class.word(),
                detail,
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
