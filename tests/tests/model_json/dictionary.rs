//! The drive, its dictionary, values, bits, alarms and process data in the file.

use serde_json::Value;

use super::{Lines, each, joined, list, text};

pub(crate) fn tables(json: &Value, lines: &mut Lines) {
    drive(&json["drive"], lines);
    each(&json["manuals"], |row| manual(row, lines));
    each(&json["objects"], |row| object(row, lines));
    for table in list(&json["enums"]) {
        for value in list(&table["values"]) {
            let key = format!("enum {} {}", text(&table["name"]), text(&value["value"]));
            lines.fact(&key, "label", &value["name"]);
            lines.own(&key, value, &["text"]);
        }
    }
    for table in list(&json["bits"]) {
        each(&table["fields"], |field| bits(&text(&table["name"]), field, lines));
    }
    each(&json["alarms"], |row| alarm(row, lines));
    each(&json["pdos"], |row| pdo(row, lines));
}

fn drive(drive: &Value, lines: &mut Lines) {
    lines.own("drive", drive, &["id", "package", "vendor", "name", "crate_version"]);
    lines.own("drive", drive, &["eds_version", "eds_revision", "date", "note"]);
    lines.facts("drive", drive, &["pdo_entries", "pdo_bytes", "pdos_per_direction"]);
    if !list(&drive["bases"]).is_empty() {
        lines.put("drive", "bases", &Value::Null, &joined(&drive["bases"]));
    }
}

fn manual(manual: &Value, lines: &mut Lines) {
    let key = format!("manual {}", text(&manual["id"]));
    lines.own(&key, manual, &["title", "version", "date", "sha256", "lines"]);
}

fn object(object: &Value, lines: &mut Lines) {
    let (key, entries) = (format!("object {}", text(&object["at"])), list(&object["entries"]));
    if entries.len() != 1 || entries[0]["sub"] != 0 {
        lines.fact(&key, "name", &object["name"]);
    }
    lines.fact(&key, "kind", &object["kind"]);
    lines.own(&key, object, &["text", "note", "deviation", "also"]);
    each(&object["entries"], |row| entry(row, lines));
}

fn entry(entry: &Value, lines: &mut Lines) {
    let key = format!("object {}", text(&entry["at"]));
    lines.facts(&key, entry, &["name", "type", "access", "pdo", "min", "max", "default", "values", "bits"]);
    lines.facts(&key, entry, &["parameter", "effect"]);
    lines.own(&key, entry, &["text", "note", "deviation", "also"]);
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

fn bits(table: &str, field: &Value, lines: &mut Lines) {
    let mode = field.get("mode").map_or_else(String::new, |m| format!(" mode {m}"));
    let key = format!("bits {table} {}{mode}", field["bit"]);
    lines.fact(&key, "label", &field["name"]);
    lines.own(&key, field, &["text", "deviation"]);
    if field["width"] != 1 {
        lines.put(&key, "width", &field["name"], &field["width"].to_string());
    }
}

fn alarm(alarm: &Value, lines: &mut Lines) {
    let key = format!("alarm {}", text(&alarm["key"]));
    lines.facts(&key, alarm, &["name", "reset", "esm_after", "sync", "led"]);
    lines.hex(&key, "number", &alarm["number"], 2);
    lines.hex(&key, "code", &alarm["code"], 4);
    lines.hex(&key, "aux", &alarm["aux"], 4);
    lines.hex(&key, "al_status", &alarm["al_status"], 4);
    lines.words(&key, "esm", &alarm["esm"]);
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
        lines.facts(&key, entry, &["entry", "bits"]);
    }
}
