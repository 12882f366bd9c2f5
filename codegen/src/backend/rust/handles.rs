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
        out.push_str("use drivewright_runtime::prelude::*;\nuse drivewright_runtime::row::*;\n");
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
    let value = value(entry, handle);
    let start = format!("pub const {name}: Object<{ty}, {access}, {mapping}, {quantity}> =");
    // As rustfmt breaks it at 100 columns.
    let gap = if start.len() + value.len() + 2 > 100 { "\n    " } else { " " };
    let _ = writeln!(out, "{start}{gap}{value};");
}

/// One call with everything that nearly every entry states; the rest are builders behind it.
fn value(entry: &Entry, handle: &Handle<'_>) -> String {
    let scale = scale(entry);
    let (range, limits) = match handle.range {
        Some((Some(min), Some(max))) => {
            (format!(", {}, {}", literal(entry, min), literal(entry, max)), String::new())
        }
        Some((min, max)) => (String::new(), limit(entry, min, max)),
        None => (String::new(), String::new()),
    };
    let function = match (range.is_empty(), scale.is_empty()) {
        (true, true) => "object",
        (false, true) => "ranged",
        (true, false) => "scaled",
        (false, false) => "ranged_scaled",
    };
    let at = entry.address;
    format!("{function}(0x{:04X}, 0x{:02X}{range}{scale}){limits}{}", at.index, at.sub, allow(entry, handle))
}

fn allow(entry: &Entry, handle: &Handle<'_>) -> String {
    let list: Vec<String> = handle.allow.iter().map(|n| literal(entry, *n)).collect();
    if list.is_empty() { String::new() } else { format!(".allow(&[{}])", list.join(", ")) }
}

/// The builder of a limit that stands alone.
fn limit(entry: &Entry, min: Option<i128>, max: Option<i128>) -> String {
    let min = min.map(|n| format!(".at_least({})", literal(entry, n)));
    min.or_else(|| max.map(|n| format!(".at_most({})", literal(entry, n)))).unwrap_or_default()
}

fn scale(entry: &Entry) -> String {
    match &entry.unit {
        Some(unit) if (unit.value.num, unit.value.den) != (1, 1) => {
            format!(", {}, {}", grouped(unit.value.num.into()), grouped(unit.value.den.into()))
        }
        _ => String::new(),
    }
}
