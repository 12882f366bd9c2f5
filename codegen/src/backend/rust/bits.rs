//! `bits.rs`: one type for each table of named bits. Bits that mean something in one mode only carry its short name.

use std::fmt::Write;

use super::docs::{self, comment};
use super::enums::source;
use super::lower::{Lowered, users};
use super::names::{Scope, ident};
use crate::emit::escape::rust_doc;
use crate::model::{BitField, BitsDef};
use crate::name::Case;

pub(super) fn body(lowered: &Lowered<'_>) -> String {
    let mut out = String::new();
    if !lowered.model.bits.is_empty() {
        out.push_str("use drivewright_runtime::prelude::*;\n");
    }
    let users = users(lowered.model, |e| e.bits.as_ref());
    for ((id, table), meaning) in lowered.model.bits.iter().zip(&lowered.bits) {
        let used = users.get(&id).map_or(&[][..], Vec::as_slice);
        let doc = comment("    ", &[docs::table(&table.name, "bits", used)]);
        let _ = write!(out, "\nbit_field! {{\n{doc}    pub struct {}({}) {{\n", meaning.name, meaning.repr);
        fields(&mut out, table);
        out.push_str("    }\n}\n");
    }
    out
}

fn fields(out: &mut String, table: &BitsDef) {
    let mut scope = Scope::default();
    for field in &table.fields {
        out.push_str(&comment("        ", &doc(field)));
        let name = scope.take(&ident(&field.scoped_name(), Case::UpperSnake));
        let last = u16::from(field.bit) + u16::from(field.width) - 1;
        let place = if field.width == 1 { field.bit.to_string() } else { format!("{}..={last}", field.bit) };
        let _ = writeln!(out, "        {name}: {place},");
    }
}

fn doc(field: &BitField) -> Vec<String> {
    let mode = field.mode.map_or_else(String::new, |m| format!(", in mode {m}"));
    let text = field.text.as_ref().map_or_else(String::new, |t| format!(" {}", rust_doc(t)));
    let mut lines = vec![format!(
        "{}{text}{}",
        rust_doc(&format!("{}{mode}.", field.printed)),
        source(&field.name.origin)
    )];
    if let Some(deviation) = &field.deviation {
        lines.extend([String::new(), format!("Deviates from the standard: {}", rust_doc(deviation))]);
    }
    lines
}
