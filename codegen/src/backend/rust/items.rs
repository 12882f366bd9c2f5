//! Tables, row by row.

use std::fmt::{Debug, Write};

use super::docs::comment;

/// A static table: a row a line.
pub(super) fn table(doc: &str, name: &str, row: &str, rows: impl Iterator<Item = String>) -> String {
    typed_table(doc, name, &format!("{row}<'static>"), rows)
}

/// A static table of rows without a lifetime.
pub(super) fn typed_table(doc: &str, name: &str, row: &str, rows: impl Iterator<Item = String>) -> String {
    let rows: Vec<String> = rows.collect();
    let mut out = format!("\n{}", comment("", &[doc.to_owned()]));
    let _ = write!(out, "pub static {name}: [{row}; {}] = [", rows.len());
    if !rows.is_empty() {
        out.push('\n');
    }
    for row in rows {
        let _ = writeln!(out, "    {row},");
    }
    out.push_str("];\n");
    out
}

/// A list of values of an enum of the runtime, which show as their variants.
pub(super) fn variants<T: Debug>(name: &str, values: &[T]) -> String {
    let list: Vec<String> = values.iter().map(|value| format!("{name}::{value:?}")).collect();
    list.join(", ")
}
