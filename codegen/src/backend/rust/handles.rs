//! `od.rs`: a typed const handle for each entry.

use std::fmt::Write;

use super::docs;
use super::lower::{Handle, Lowered, imports};
use super::number::grouped;
use super::values::literal;
use crate::emit::escape::one_line;
use crate::model::{Entry, ObjectKind};

pub(super) fn body(lowered: &Lowered<'_>) -> String {
    let mut out = imports(lowered.handles.iter().map(|h| h.ty.as_str()), &[]);
    if !lowered.model.entries.is_empty() {
        out.push_str("use drivewright_runtime::prelude::*;\n");
    }
    for (_, object) in lowered.model.objects.iter() {
        if object.kind.value != ObjectKind::Var {
            let name = one_line(object.name.value.original());
            let _ = write!(out, "\n// {:04X}h {name}\n", object.index);
        }
        for id in &object.entries {
            handle(&mut out, &lowered.model.entries[*id], lowered.handle_of(*id), lowered);
        }
    }
    out
}

fn handle(out: &mut String, entry: &Entry, handle: &Handle<'_>, lowered: &Lowered<'_>) {
    out.push('\n');
    out.push_str(&docs::comment("", &docs::entry(entry, lowered.model)));
    let index = entry.address.index;
    let _ = writeln!(out, "#[doc(alias = \"{index:04X}\")]");
    // rustdoc refuses quotes and blanks at the ends; a number of a parameter has neither.
    let plain = |number: &&str| number.chars().all(|c| c.is_ascii_alphanumeric() || ".-_".contains(c));
    if let Some(number) = entry.parameter.as_ref().map(|p| p.value.as_str()).filter(plain) {
        let _ = writeln!(out, "#[doc(alias = \"{number}\")]");
    }
    let Handle { name, ty, access, mapping, quantity, .. } = handle;
    let value = format!(
        "Object::new(0x{index:04X}, 0x{:02X}){}{}{}",
        entry.address.sub,
        range(entry, handle),
        allow(entry, handle),
        scale(entry)
    );
    let start = format!("pub const {name}: Object<{ty}, {access}, {mapping}, {quantity}> =");
    // As rustfmt breaks it at 100 columns.
    let gap = if start.len() + value.len() + 2 > 100 { "\n    " } else { " " };
    let _ = writeln!(out, "{start}{gap}{value};");
}

fn allow(entry: &Entry, handle: &Handle<'_>) -> String {
    let list: Vec<String> = handle.allow.iter().map(|n| literal(entry, *n)).collect();
    if list.is_empty() { String::new() } else { format!(".allow(&[{}])", list.join(", ")) }
}

fn range(entry: &Entry, handle: &Handle<'_>) -> String {
    let Some((min, max)) = handle.range else { return String::new() };
    limits(min.map(|n| literal(entry, n)), max.map(|n| literal(entry, n)))
}

/// The call that sets the limits which are stated.
pub(super) fn limits(min: Option<String>, max: Option<String>) -> String {
    match (min, max) {
        (Some(min), Some(max)) => format!(".range({min}, {max})"),
        (Some(min), None) => format!(".at_least({min})"),
        (None, Some(max)) => format!(".at_most({max})"),
        (None, None) => String::new(),
    }
}

fn scale(entry: &Entry) -> String {
    match &entry.unit {
        Some(unit) if (unit.value.num, unit.value.den) != (1, 1) => {
            format!(".scale({}, {})", grouped(unit.value.num.into()), grouped(unit.value.den.into()))
        }
        _ => String::new(),
    }
}
