//! `enums.rs`: one open type for each table of named values.

use std::fmt::Write;

use super::docs::comment;
use super::lower::Lowered;
use super::names::{Scope, ident};
use super::number::grouped;
use crate::emit::escape::{one_line, rust_doc, rust_str};
use crate::model::{EnumDef, EnumValue, Origin};
use crate::name::Case;

pub(super) fn body(lowered: &Lowered<'_>) -> String {
    let mut out = String::new();
    if !lowered.model.enums.is_empty() {
        out.push_str("use drivewright_runtime::prelude::*;\n");
    }
    for ((_, table), meaning) in lowered.model.enums.iter().zip(&lowered.enums) {
        let title = one_line(table.name.original());
        let _ = write!(
            out,
            "\nwire_enum! {{\n{}",
            comment("    ", &[format!("Values of {}.", rust_doc(&title))])
        );
        let _ =
            writeln!(out, "    pub struct {}({}) = \"{}\" {{", meaning.name, meaning.repr, rust_str(&title));
        values(&mut out, table);
        out.push_str("    }\n}\n");
    }
    out
}

fn values(out: &mut String, table: &EnumDef) {
    // The runtime's macro keeps `DESC` for the table.
    let mut scope = Scope::without(&["DESC"]);
    for value in &table.values {
        out.push_str(&comment("        ", &[doc(value)]));
        let name = scope.take(&ident(&value.name.value, Case::UpperSnake));
        let _ =
            writeln!(out, "        {name} = {} => \"{}\",", grouped(value.value), rust_str(&value.printed));
    }
}

fn doc(value: &EnumValue) -> String {
    let text = value.text.as_ref().map_or_else(String::new, |t| format!(" {}", rust_doc(t)));
    format!("{}{text}{}", rust_doc(&format!("{}.", value.printed)), source(&value.name.origin))
}

/// ` (4.2 L441)` where the manual says it, ` (standard: cia402)` where a base does.
pub(super) fn source(origin: &Origin) -> String {
    match (&origin.cite, origin.class.detail()) {
        (Some(cite), _) => format!(" ({})", rust_doc(&cite.to_string())),
        (None, Some(detail)) => format!(" ({}: {})", origin.class.word(), rust_doc(detail)),
        (None, None) => String::new(),
    }
}
