//! Reports for programs.
//!
//! One object: `format` (1), and `drives`, a list of
//!
//! - `package`, `old_version` (`null` for a new drive), `new_version`;
//! - `verdict`: `bump` (`none`, `patch`, `minor`, `major`), `needs` (a version or `null`), `enough`, `rule`;
//! - `changes`, in the order of rows: `table`, `key`, `change` (`added`, `removed`, `changed`), `field` (of `changed`),
//!   `effect` (`breaking`, `axis`, `new`, `documentation`), `axis` (what the row is for an axis, or `null`), `rule`,
//!   `why`, and the values: `old` and `new` of `changed`, each `null` or `value`, `text`, `class`, `detail`, `cite`,
//!   `erratum`; `facts` of `added` and `removed`, by field.
//!
//! A change of the meaning of a key, or a key that goes, raises `format`; new keys do not.

use serde_json::{Map, Value, json};

use super::{Change, Report, Row, Said, Version, What};

/// The reports as one JSON text.
pub fn json(reports: &[Report]) -> String {
    let drives: Vec<Value> = reports.iter().map(drive).collect();
    format!("{:#}\n", json!({ "format": 1, "drives": drives }))
}

fn drive(report: &Report) -> Value {
    let verdict = &report.verdict;
    json!({
        "package": report.package,
        "old_version": (!report.old.is_empty()).then_some(&report.old),
        "new_version": report.new,
        "verdict": {
            "bump": verdict.bump.word(),
            "needs": verdict.needs.map(|v: Version| v.to_string()),
            "enough": verdict.enough,
            "rule": verdict.rule,
        },
        "changes": report.changes.iter().map(change).collect::<Vec<_>>(),
    })
}

fn change(change: &Change) -> Value {
    let mut out = json!({
        "table": change.table, "key": change.key, "effect": change.effect.word(), "axis": change.axis,
        "rule": change.rule, "why": change.why,
    });
    let more = match &change.what {
        What::Added(row) => json!({ "change": "added", "facts": facts(row) }),
        What::Removed(row) => json!({ "change": "removed", "facts": facts(row) }),
        What::Changed(field, old, new) => json!({
            "change": "changed", "field": field,
            "old": old.as_ref().map(said), "new": new.as_ref().map(said),
        }),
    };
    if let (Value::Object(out), Value::Object(more)) = (&mut out, more) {
        out.extend(more);
    }
    out
}

fn facts(row: &Row) -> Map<String, Value> {
    row.facts.iter().map(|(field, value)| (field.clone(), said(value))).collect()
}

fn said(said: &Said) -> Value {
    let Said { value, text, class, detail, cite, erratum } = said;
    json!({ "value": value, "text": text, "class": class, "detail": detail, "cite": cite, "erratum": erratum })
}
