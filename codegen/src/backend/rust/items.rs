//! The two ways of writing Rust: tables row by row, already formatted, and items through `quote`.

use std::fmt::Write;

use proc_macro2::TokenStream;

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

/// Items as text: formatted, unless the build goes without the formatter.
#[cfg(feature = "format")]
pub(super) fn items(tokens: &TokenStream) -> String {
    match syn::parse2::<syn::File>(tokens.clone()) {
        Ok(file) => prettyplease::unparse(&file),
        // Cannot happen for tokens that this crate quotes; what the compiler then says is the best report.
        Err(_) => format!("{tokens}\n"),
    }
}

/// Items as text: formatted, unless the build goes without the formatter.
#[cfg(not(feature = "format"))]
pub(super) fn items(tokens: &TokenStream) -> String {
    format!("{tokens}\n")
}
