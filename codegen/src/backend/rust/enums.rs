//! `enums.rs`: one open type for each table of named values.

use std::fmt::Write;

use super::docs::{self, comment};
use super::lower::{Lowered, users};
use super::names::{Scope, ident};
use super::number::grouped;
use crate::emit::escape::{rust_doc, rust_str};
use crate::model::{Entry, EnumDef, EnumValue, Origin};
use crate::name::Case;

pub(super) fn body(lowered: &Lowered<'_>) -> String {
    let mut out = String::new();
    if !lowered.model.enums.is_empty() {
        out.push_str("use drivewright_runtime::prelude::*;\n");
    }
    let users = users(lowered.model, |e| e.values.as_ref());
    for ((id, table), meaning) in lowered.model.enums.iter().zip(&lowered.enums) {
        let used = users.get(&id).map_or(&[][..], Vec::as_slice);
        let doc = comment("    ", &[docs::table(&table.name, "values", used)]);
        let _ = write!(out, "\nwire_enum! {{\n{doc}");
        let _ = writeln!(
            out,
            "    pub struct {}({}) = \"{}\" {{",
            meaning.name,
            meaning.repr,
            rust_str(table.name.original())
        );
        let written: Vec<&Entry> = used.iter().copied().filter(|e| e.access.value.writes()).collect();
        values(&mut out, table, &written);
        out.push_str("    }\n}\n");
    }
    out
}

fn values(out: &mut String, table: &EnumDef, written: &[&Entry]) {
    // The runtime's macro keeps `DESC` for the table.
    let mut scope = Scope::without(&["DESC"]);
    for value in &table.values {
        out.push_str(&comment("        ", &[doc(value, written)]));
        let name = scope.take(&ident(&value.name.value, Case::UpperSnake));
        let _ =
            writeln!(out, "        {name} = {} => \"{}\",", grouped(value.value), rust_str(&value.printed));
    }
}

fn doc(value: &EnumValue, written: &[&Entry]) -> String {
    let text = value.text.as_ref().map_or_else(String::new, |t| format!(" {}", rust_doc(t)));
    let refused = refused(value.value, written);
    format!("{}{text}{}{refused}", rust_doc(&format!("{}.", value.printed)), source(&value.name.origin))
}

/// That none of the entries that are written takes the value: tables come from a standard, too, and a drive has some of
/// its values.
fn refused(value: i128, written: &[&Entry]) -> String {
    let lacks = |e: &&&Entry| e.allow.as_ref().is_some_and(|a| !a.value.contains(&value));
    let by: Vec<String> = written.iter().filter(lacks).map(|e| e.address.to_string()).collect();
    let nobody_takes_it = !by.is_empty() && by.len() == written.len();
    if nobody_takes_it { format!(" Not allowed by {}.", by.join(", ")) } else { String::new() }
}

/// ` (4.2 L441)` where the manual says it, ` (standard: cia402)` where a base does.
pub(super) fn source(origin: &Origin) -> String {
    match (&origin.cite, origin.class.detail()) {
        (Some(cite), _) => format!(" ({})", rust_doc(&cite.to_string())),
        (None, Some(detail)) => format!(" ({}: {})", origin.class.word(), rust_doc(detail)),
        (None, None) => String::new(),
    }
}
