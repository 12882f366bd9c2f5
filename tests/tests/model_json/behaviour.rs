//! Homing, modes, states, the EtherCAT side, terminals, rules, examples and errata in the file.

use serde_json::{Value, json};

use super::{Lines, each, list, text};

pub(crate) fn tables(json: &Value, lines: &mut Lines) {
    each(&json["homing"], |row| homing(row, lines));
    each(&json["modes"], |row| mode(row, lines));
    each(&json["states"], |row| state("state", row, lines));
    each(&json["commands"], |row| state("command", row, lines));
    for abort in list(&json["aborts"]) {
        lines.fact(&format!("abort {}", text(&abort["at"])), "name", &abort["name"]);
    }
    each(&json["terminals"], |row| terminal(row, lines));
    ethercat(json, lines);
    for part in list(&json["emcy"]) {
        let key = format!("emcy {}", part["byte"]);
        lines.facts(&key, part, &["bytes", "holds"]);
        lines.own(&key, part, &["text"]);
    }
    for rule in list(&json["rules"]) {
        lines.facts(&format!("rule {}", text(&rule["id"])), rule, &["text", "require", "when", "on"]);
    }
    each(&json["examples"], |row| example(row, lines));
    each(&json["errata"], |row| erratum(row, lines));
}

fn ethercat(json: &Value, lines: &mut Lines) {
    let whole = &json["ethercat"];
    lines.facts("ethercat", whole, &["type", "group", "physics", "revision_check"]);
    lines.words("ethercat", "mailbox", &whole["mailbox"]);
    lines.hex_list("ethercat", "config", &whole["config"]);
    lines.hex_list("ethercat", "bootstrap", &whole["bootstrap"]);
    lines.fact("ethercat", "eeprom_bytes", &whole["eeprom_bytes"]);
    for manager in list(&json["sync_managers"]) {
        let key = format!("sync manager {}", manager["number"]);
        lines.fact(&key, "use", &manager["use"]);
        lines.hex(&key, "start", &manager["start"], 4);
        lines.facts(&key, manager, &["size", "min_size", "max_size"]);
        lines.hex(&key, "control", &manager["control"], 2);
        lines.fact(&key, "enable", &manager["enable"]);
    }
    for fmmu in list(&json["fmmus"]) {
        lines.fact(&format!("fmmu {}", fmmu["number"]), "use", &fmmu["use"]);
    }
    for coe in list(&json["coe"]) {
        lines.fact(&format!("coe {}", text(&coe["feature"])), "supported", &coe["supported"]);
    }
    for mode in list(&json["dc_modes"]) {
        let key = format!("dc mode {}", mode["number"]);
        lines.facts(&key, mode, &["name", "sync"]);
        lines.hex(&key, "assign_activate", &mode["assign_activate"], 4);
        lines.facts(&key, mode, &["cycle0", "shift0", "cycle1", "shift1"]);
        lines.own(&key, mode, &["text"]);
    }
    for startup in list(&json["startup"]) {
        let key = format!("startup {}", startup["number"]);
        lines.facts(&key, startup, &["transition", "write", "value"]);
        lines.own(&key, startup, &["text"]);
    }
}

fn homing(method: &Value, lines: &mut Lines) {
    let key = format!("homing {}", method["number"]);
    lines.facts(&key, method, &["status", "same", "start", "approach", "reference", "side", "edge"]);
    lines.own(&key, method, &["text", "note", "deviation"]);
    for case in list(&method["cases"]) {
        let key = format!("{key}.{}", case["number"]);
        lines.facts(&key, case, &["when", "moves", "abort"]);
        lines.words(&key, "mask", &case["mask"]);
    }
}

fn mode(mode: &Value, lines: &mut Lines) {
    let key = format!("mode {}", mode["number"]);
    lines.fact(&key, "name", &mode["name"]);
    lines.words(&key, "objects", &mode["objects"]);
    lines.own(&key, mode, &["text"]);
}

/// A state; or a command, which has two keys more.
fn state(kind: &str, state: &Value, lines: &mut Lines) {
    let key = format!("{kind} {}", text(&state["name"]));
    lines.hex(&key, "mask", &state["mask"], 4);
    lines.hex(&key, "value", &state["value"], 4);
    lines.fact(&key, "edge", &state["edge"]);
    lines.words(&key, "transitions", &state["transitions"]);
}

fn terminal(terminal: &Value, lines: &mut Lines) {
    let key = format!("terminal {}", text(&terminal["name"]));
    lines.facts(&key, terminal, &["kind", "pin", "object", "bit", "parameter"]);
    lines.own(&key, terminal, &["text", "note"]);
}

fn example(example: &Value, lines: &mut Lines) {
    let step = example.get("step").map_or_else(String::new, |step| format!(".{step}"));
    let key = format!("example {}{step}", text(&example["id"]));
    lines.facts(&key, example, &["write", "entry", "bits", "parameter", "min", "max"]);
    lines.own(&key, example, &["text"]);
    // Mapping words are read by their digits; a number below 0 has none.
    match text(&example["value"]["value"]).parse::<i128>() {
        Ok(n) if n >= 0 => lines.put(&key, "value", &example["value"], &format!("0x{n:X}")),
        _ => lines.fact(&key, "value", &example["value"]),
    }
}

/// The places of an erratum belong to what is printed and to what is used.
fn erratum(erratum: &Value, lines: &mut Lines) {
    let key = format!("erratum {}", text(&erratum["id"]));
    lines.own(&key, erratum, &["at", "field", "why", "sure"]);
    lines.put(&key, "was", &json!({ "cite": erratum["seen"] }), &text(&erratum["was"]));
    let used = match (erratum.get("set"), erratum.get("unset")) {
        (Some(set), None) => text(set),
        (None, Some(Value::Bool(true))) => "the printed value is dropped".to_owned(),
        (set, unset) => {
            assert_eq!((set, unset), (None, None), "{key}");
            "the printed value is kept".to_owned()
        }
    };
    lines.put(&key, "set", &json!({ "cite": erratum["by"] }), &used);
}
