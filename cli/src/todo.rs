//! `drivewright todo`: what a profile does not state yet, most urgent first.

use drivewright_codegen::facts::facts;
use drivewright_codegen::todo::{Item, Priority, todo};
use serde_json::json;

use crate::End;
use crate::drives::find;
use crate::output::print;

pub(crate) fn run(drive: &str, json: bool) -> End {
    let found = match find(drive) {
        Ok(found) => found,
        Err(end) => return end,
    };
    let items = found.compiled.model.as_ref().map(|model| todo(&facts(model))).unwrap_or_default();
    print(&if json { as_json(&items) } else { as_text(&found.id, &items) })
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

fn as_json(items: &[Item]) -> String {
    let item = |i: &Item| json!({ "priority": i.priority.word(), "what": i.what, "why": i.why });
    format!("{}\n", json!(items.iter().map(item).collect::<Vec<_>>()))
}
