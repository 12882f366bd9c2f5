//! `drivewright coverage`: how much of each table of a drive is known.

use drivewright_codegen::coverage::{COLUMNS, Count, coverage, name};
use drivewright_codegen::facts::facts;
use serde_json::{Map, Value, json};

use crate::End;
use crate::drives::{Found, find_all};
use crate::output::print;

pub(crate) fn run(drives: &[String], json: bool) -> End {
    let found = match find_all(drives) {
        Ok(found) => found,
        Err(end) => return end,
    };
    let counts: Vec<(String, Vec<Count>)> = found.iter().map(|f| (name_of(f, &found), counts(f))).collect();
    print(&if json { format!("{}\n", as_json(&counts)) } else { counts.iter().map(as_text).collect() })
}

/// The drive's id; with its maker where another one has the same.
fn name_of(one: &Found, all: &[Found]) -> String {
    let twice = all.iter().filter(|f| f.id == one.id).count() > 1;
    let package = one.compiled.model.as_ref().map(|m| m.drive.package.clone()).filter(|_| twice);
    package.unwrap_or_else(|| one.id.clone())
}

fn counts(found: &Found) -> Vec<Count> {
    found.compiled.model.as_ref().map(|model| coverage(&facts(model))).unwrap_or_default()
}

fn as_text((drive, counts): &(String, Vec<Count>)) -> String {
    let heads: Vec<String> = COLUMNS.iter().map(|(head, _)| (*head).to_owned()).collect();
    let rows = counts.iter().map(|count| {
        let cells: Vec<String> = count.with.iter().map(|n| cell(*n)).collect();
        line(name(count.table), &count.rows.to_string(), &cells, &cell(count.cited))
    });
    std::iter::once(line(drive, "rows", &heads, "cited")).chain(rows).collect()
}

fn line(first: &str, rows: &str, cells: &[String], last: &str) -> String {
    let cells: Vec<String> = cells.iter().map(|cell| format!("{cell:>12}")).collect();
    format!("{first:<18} {rows:>6} {} {last:>8}\n", cells.join(" "))
}

/// Nothing where there is nothing, so that what is there can be seen.
fn cell(n: usize) -> String {
    if n == 0 { "-".to_owned() } else { n.to_string() }
}

fn as_json(drives: &[(String, Vec<Count>)]) -> Value {
    let count = |count: &Count| {
        let mut row = Map::new();
        row.insert("rows".into(), json!(count.rows));
        row.insert("cited".into(), json!(count.cited));
        row.extend(COLUMNS.iter().zip(&count.with).map(|((head, _), n)| (head.replace(' ', "_"), json!(n))));
        (name(count.table).replace(' ', "_"), Value::Object(row))
    };
    let drives = drives
        .iter()
        .map(|(drive, counts)| (drive.clone(), Value::Object(counts.iter().map(count).collect())));
    Value::Object(drives.collect())
}
