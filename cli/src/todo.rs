//! `drivewright todo`: what a profile does not state yet, most urgent first.

use drivewright_codegen::facts::facts;
use drivewright_codegen::todo::{Item, Priority, todo};
use serde_json::{Value, json};

use crate::End;
use crate::drives::{Found, find_all};
use crate::output::print;

pub(crate) fn run(drives: &[String], json: bool) -> End {
    let found = match find_all(drives) {
        Ok(found) => found,
        Err(end) => return end,
    };
    let lists: Vec<(String, Vec<Item>)> = found.iter().map(list).collect();
    print(&if json {
        as_json(&lists)
    } else {
        lists.iter().map(|(drive, items)| as_text(drive, items)).collect()
    })
}

/// What the drive lacks, under the name of its package: ids of two makers may be the same.
fn list(found: &Found) -> (String, Vec<Item>) {
    let model = found.compiled.model.as_ref();
    let name = model.map_or_else(|| found.id.clone(), |model| model.drive.package.clone());
    (name, model.map(|model| todo(&facts(model))).unwrap_or_default())
}

fn as_text(drive: &str, items: &[Item]) -> String {
    let mut out = format!("{drive}: {} not stated; a drive may not have all of it\n", items.len());
    for priority in Priority::ALL {
        let these: Vec<&Item> = items.iter().filter(|item| item.priority == priority).collect();
        if !these.is_empty() {
            out.extend([format!("{} ({})\n", priority.word(), these.len())]);
        }
        out.extend(these.iter().map(|item| format!("  {} ({})\n", item.what, item.why)));
    }
    out
}

fn as_json(lists: &[(String, Vec<Item>)]) -> String {
    let item = |i: &Item| json!({ "priority": i.priority.word(), "what": i.what, "why": i.why });
    let list = |items: &[Item]| Value::Array(items.iter().map(item).collect());
    let drives = lists.iter().map(|(drive, items)| (drive.clone(), list(items)));
    format!("{}\n", Value::Object(drives.collect()))
}
