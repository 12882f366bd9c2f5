//! `pdo.rs`: one struct for each default mapping.

use std::fmt::Write;

use super::docs::comment;
use super::enums::source;
use super::lower::{Layout, Lowered, imports};
use crate::emit::escape::rust_doc;
use crate::model::{Direction, Pdo};

pub(super) fn body(lowered: &Lowered<'_>) -> String {
    let typed = || lowered.model.pdos.iter().zip(&lowered.layouts).filter(|(_, l)| !l.fields.is_empty());
    let mut out = String::new();
    if typed().next().is_some() {
        let entries =
            typed().flat_map(|(p, _)| p.entries.iter().map(|e| lowered.handle_of(e.entry).ty.as_str()));
        out.push_str(&imports(entries, &["od"]));
        out.push_str("use drivewright_runtime::prelude::*;\n");
    }
    for (pdo, layout) in typed() {
        one(&mut out, pdo, layout, lowered);
    }
    out
}

fn one(out: &mut String, pdo: &Pdo, layout: &Layout, lowered: &Lowered<'_>) {
    let (word, verb) = if pdo.direction == Direction::Rx { ("Rx", "receives") } else { ("Tx", "sends") };
    let bytes = match pdo.bits() / 8 {
        1 => "1 byte".to_owned(),
        n => format!("{n} bytes"),
    };
    let text = format!("{word}PDO `{:04X}`: {bytes} that the drive {verb}.", pdo.index);
    let limits = &lowered.model.drive.limits;
    let entries =
        limits.pdo_entries.as_ref().map_or_else(String::new, |n| format!(", entries <= {}", n.value));
    let bytes = limits.pdo_bytes.as_ref().map_or_else(String::new, |n| format!(", bytes <= {}", n.value));
    let _ = write!(out, "\npdo_layout! {{\n{}", comment("    ", &[text]));
    let _ = writeln!(out, "    pub struct {}: {word}{entries}{bytes} {{", layout.name);
    let mut byte = 0;
    for (mapped, field) in pdo.entries.iter().zip(&layout.fields) {
        let (handle, entry) = (lowered.handle_of(mapped.entry), &lowered.model.entries[mapped.entry]);
        let place = format!("{}, from byte {byte}.{}", rust_doc(&entry.name.value), source(&mapped.origin));
        out.push_str(&comment("        ", &[place]));
        let _ = writeln!(out, "        {field}: {} = od::{},", handle.ty, handle.name);
        byte += u32::from(mapped.bits.value) / 8;
    }
    out.push_str("    }\n}\n");
}
