//! Tables, row by row.

use std::fmt::Write;

use super::docs::comment;

/// A static table: a row a line.
pub(super) fn table(doc: &str, name: &str, row: &str, rows: impl Iterator<Item = String>) -> String {
    let rows: Vec<String> = rows.collect();
    let mut out = format!("\n{}", comment("", &[doc.to_owned()]));
    let _ = write!(out, "pub static {name}: [{row}<'static>; {}] = [", rows.len());
    if !rows.is_empty() {
        out.push('\n');
    }
    for row in rows {
        let _ = writeln!(out, "    {row},");
    }
    out.push_str("];\n");
    out
}
