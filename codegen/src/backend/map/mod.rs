//! `map.txt`: one sorted line for each fact, the file that reviewers read.
//!
//! A line depends on its fact alone: column widths are fixed and nothing is wrapped, so a changed value is a changed line.

use super::Backend;
use crate::diag::Sink;
use crate::emit::FileSet;
use crate::emit::escape::push_plain_line;
use crate::facts::{FactLine, Table, Totals, facts};
use crate::model::Model;

/// `map.txt`: one sorted line for each fact.
pub struct Map;

impl Backend for Map {
    fn id(&self) -> &'static str {
        "map"
    }

    fn emit(&self, model: &Model, out: &mut FileSet, _sink: &mut Sink) {
        // The path is a literal that every RelPath rule allows.
        let _ = out.add("map.txt", text(model));
    }
}

const PREAMBLE: &str = "\
# Facts of the drive, one a line: row, field, value, how it is known, where the manual says it, erratum.
# stated: the manual says it. inferred: it follows by the named rule. standard: the named base says it.
# assumed: a format demands it and nobody says it. own: written for the profile (ids, versions, wording, errata).
# Written by drivewright with `cargo xtask regen`. Edit the profile, not this file.
";

fn text(model: &Model) -> String {
    let lines = facts(model);
    let mut out = String::with_capacity(lines.len() * 100);
    out.push_str(PREAMBLE);
    for line in &lines {
        push(line, &mut out);
    }
    out.push_str(&last(&Totals::of(&lines)));
    out
}

/// Widths of the columns of rows and of fields; what is longer pushes the rest of its line.
fn widths(table: Table) -> (usize, usize) {
    match table {
        Table::Drive => (5, 18),
        Table::Manuals | Table::Pdos => (12, 9),
        Table::Enums | Table::Bits => (32, 9),
        Table::Alarms | Table::Errata => (16, 9),
        Table::Objects
        | Table::Homing
        | Table::Modes
        | Table::EtherCat
        | Table::Emcy
        | Table::Rules
        | Table::Examples => (14, 9),
        Table::States | Table::Commands | Table::Aborts | Table::Terminals => (32, 11),
    }
}

fn push(line: &FactLine<'_>, out: &mut String) {
    let (rows, fields) = widths(line.table);
    column(out, &line.key, rows);
    column(out, &line.field, fields);
    column(out, &line.value, 32);
    match line.class {
        Some(class) => push_plain_line(out, &class.to_string()),
        None => out.push_str("own"),
    }
    if let Some(cite) = line.cite {
        out.push_str("  ");
        push_plain_line(out, &cite.to_string());
    }
    if let Some(erratum) = line.erratum {
        out.push_str("  [");
        push_plain_line(out, erratum);
        out.push(']');
    }
    out.push('\n');
}

/// `text` in a column of at least `width` characters, and the gap behind it.
fn column(out: &mut String, text: &str, width: usize) {
    const BLANKS: &str = "                                ";
    let start = out.len();
    push_plain_line(out, text);
    let missing = width.saturating_sub(out[start..].chars().count());
    out.push_str(&BLANKS[..missing.min(BLANKS.len())]);
    out.push_str("  ");
}

fn last(totals: &Totals) -> String {
    let Totals { stated, inferred, standard, assumed, own } = totals;
    let facts = totals.facts();
    format!(
        "# {facts} facts: {stated} stated, {inferred} inferred, {standard} standard, {assumed} assumed. {own} own.\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Source;

    fn map(min: i64) -> String {
        let text = format!(
            r#"
manuals = [ {{ id = "m1", title = "T", version = "1", sha256 = "0000000000000000000000000000000000000000000000000000000000000000", lines = 9 }} ]
objects = [ {{ at = "2000:00", name = "Speed", type = "i32", access = "rw", min = {min}, src = "1 L2" }} ]
drive = {{ format = 1, id = "x1", vendor = "Acme", vendor_id = "acme", name = "X1", crate_version = "0.1.0", eds_version = 1, eds_revision = 0, date = "2026-01-01" }}
"#
        );
        let compiled = crate::compile(vec![Source { path: "a.toml".into(), text }]);
        super::text(compiled.sound().unwrap())
    }

    #[test]
    fn a_changed_value_is_one_changed_line() {
        let (a, b) = (map(-1), map(-2_000_000_000));
        let changed: Vec<_> = a.lines().zip(b.lines()).filter(|(a, b)| a != b).collect();
        assert_eq!(changed.len(), 1);
        assert_eq!(a.lines().count(), b.lines().count());
        assert_eq!(changed[0].1, "object 2000:00  min        -2000000000                       stated  1 L2");
    }

    #[test]
    fn hidden_characters_are_seen() {
        let line = FactLine {
            table: Table::Objects,
            key: "object 2000:00".into(),
            field: "name".into(),
            value: "a\n\u{202E}\\b".into(),
            class: None,
            cite: None,
            erratum: None,
        };
        let mut out = String::new();
        push(&line, &mut out);
        assert_eq!(out.lines().count(), 1);
        assert!(out.contains(r"  a\u{a}\u{202e}\\b  "), "{out}");
    }
}
