//! Facts of the drive, its dictionary, values, bits, alarms and process data.

use super::{Lines, Table, words};
use crate::model::{Alarm, BitField, BitsDef, Drive, Entry, EnumDef, Manual, Object, Pdo, Value};

pub(super) fn drive<'m>(drive: &'m Drive, lines: &mut Lines<'m>) {
    lines.row(Table::Drive, "drive".to_owned());
    lines.own("id", &drive.id);
    lines.own("package", &drive.package);
    lines.own("vendor", &drive.vendor);
    lines.own("name", &drive.name);
    let bases = drive.bases.join(" ");
    lines.own_text("bases", Some(&bases).filter(|b| !b.is_empty()));
    lines.own("crate_version", &drive.crate_version);
    lines.own("eds_version", &drive.eds_version);
    lines.own("eds_revision", &drive.eds_revision);
    lines.own("date", &drive.date);
    lines.fact("pdo_entries", drive.limits.pdo_entries.as_ref(), u8::to_string);
    lines.fact("pdo_bytes", drive.limits.pdo_bytes.as_ref(), u16::to_string);
    lines.fact("pdos_per_direction", drive.limits.pdos_per_direction.as_ref(), u8::to_string);
    lines.own_text("note", drive.note.as_ref());
}

pub(super) fn manual<'m>(manual: &'m Manual, lines: &mut Lines<'m>) {
    lines.row(Table::Manuals, format!("manual {}", manual.id));
    lines.own("title", &manual.title);
    lines.own("version", &manual.version);
    lines.own_text("date", manual.date.as_ref());
    lines.own("sha256", &manual.sha256);
    lines.own("lines", &manual.lines);
}

pub(super) fn object<'m>(object: &'m Object, lines: &mut Lines<'m>) {
    let entries = object.entries.iter().map(|id| &lines.model.entries[*id]).collect::<Vec<_>>();
    lines.row(Table::Objects, format!("object {:04X}", object.index));
    // The name of a variable is that of its entry.
    if !matches!(entries.as_slice(), [only] if only.address.sub == 0) {
        lines.said("name", &object.name.value, &object.name.origin);
    }
    lines.said("kind", object.kind.value.word(), &object.kind.origin);
    lines.own_text("text", object.text.as_ref());
    lines.own_text("note", object.note.as_ref());
    lines.own_text("deviation", object.deviation.as_ref());
    if let Some(also) = &object.also {
        lines.own("also", also);
    }
    for each in entries {
        entry(each, lines);
    }
}

fn entry<'m>(entry: &'m Entry, lines: &mut Lines<'m>) {
    lines.row(Table::Objects, format!("object {}", entry.address));
    lines.said("name", &entry.name.value, &entry.name.origin);
    lines.rename(&entry.name.value, &entry.handle);
    lines.said("type", &entry.ty.value, &entry.ty.origin);
    lines.said("access", entry.access.value.word(), &entry.access.origin);
    lines.fact("pdo", entry.mapping.as_ref(), |m| m.word().to_owned());
    lines.fact("unit", entry.unit.as_ref(), ToString::to_string);
    lines.fact("min", entry.min.as_ref(), i128::to_string);
    lines.fact("max", entry.max.as_ref(), i128::to_string);
    lines.fact("allow", entry.allow.as_ref(), |list| numbers(list));
    lines.fact("default", entry.default.as_ref(), value);
    let model = lines.model;
    lines.fact("values", entry.values.as_ref(), |id| model.enums[*id].name.to_string());
    lines.fact("bits", entry.bits.as_ref(), |id| model.bits[*id].name.to_string());
    lines.fact("parameter", entry.parameter.as_ref(), Clone::clone);
    lines.fact("effect", entry.effect.as_ref(), |e| e.word().to_owned());
    lines.own_text("text", entry.text.as_ref());
    lines.own_text("note", entry.note.as_ref());
    lines.own_text("deviation", entry.deviation.as_ref());
    if let Some(also) = &entry.also {
        lines.own("also", also);
    }
}

fn numbers(list: &[i128]) -> String {
    format!("[{}]", list.iter().map(i128::to_string).collect::<Vec<_>>().join(", "))
}

fn value(value: &Value) -> String {
    match value {
        Value::Int(n) => n.to_string(),
        Value::Text(text) => format!("\"{text}\""),
    }
}

pub(super) fn enumeration<'m>(table: &'m EnumDef, lines: &mut Lines<'m>) {
    for value in &table.values {
        lines.row(Table::Enums, format!("enum {} {}", table.name, value.value));
        lines.said("label", &value.printed, &value.name.origin);
        lines.rename(&value.printed, &value.name.value);
        lines.own_text("text", value.text.as_ref());
    }
}

pub(super) fn bits<'m>(table: &'m BitsDef, lines: &mut Lines<'m>) {
    for field in &table.fields {
        lines.row(Table::Bits, format!("bits {} {}{}", table.name, field.bit, mode(field)));
        if field.width != 1 {
            lines.said("width", &field.width, &field.name.origin);
        }
        lines.said("label", &field.printed, &field.name.origin);
        lines.rename(&field.printed, &field.name.value);
        lines.own_text("text", field.text.as_ref());
        lines.own_text("deviation", field.deviation.as_ref());
    }
}

fn mode(field: &BitField) -> String {
    field.mode.map_or_else(String::new, |mode| format!(" mode {mode}"))
}

pub(super) fn alarm<'m>(alarm: &'m Alarm, lines: &mut Lines<'m>) {
    lines.row(Table::Alarms, format!("alarm {} 0x{:02X}", alarm.display, alarm.number.value));
    lines.said("name", &alarm.printed, &alarm.name.origin);
    lines.rename(&alarm.printed, &alarm.name.value);
    lines.fact("number", Some(&alarm.number), |n| format!("0x{n:02X}"));
    lines.fact("code", Some(&alarm.code), |n| format!("0x{n:04X}"));
    lines.fact("aux", alarm.aux.as_ref(), |n| format!("0x{n:04X}"));
    lines.fact("reset", alarm.reset.as_ref(), |r| r.word().to_owned());
    for (word, list) in [("cause", &alarm.causes), ("remedy", &alarm.remedies)] {
        for (n, text) in (1..).zip(list) {
            lines.said(format!("{word} {n}"), &text.value, &text.origin);
        }
    }
    let detection = &alarm.detection;
    lines.fact("esm", detection.esm.as_ref(), |s| words(s));
    lines.fact("esm_after", detection.esm_after.as_ref(), |s| s.word().to_owned());
    lines.fact("sync", detection.sync.as_ref(), |s| s.word().to_owned());
    lines.fact("al_status", detection.al_status.as_ref(), |n| format!("0x{n:04X}"));
    lines.fact("led", detection.led.as_ref(), |l| l.word().to_owned());
}

pub(super) fn pdo<'m>(pdo: &'m Pdo, lines: &mut Lines<'m>) {
    lines.row(Table::Pdos, format!("pdo {:04X}", pdo.index));
    lines.said("dir", pdo.direction.word(), &pdo.origin);
    for mapped in &pdo.entries {
        lines.row(Table::Pdos, format!("pdo {:04X} {}", pdo.index, mapped.position));
        lines.said("entry", &lines.model.entries[mapped.entry].address, &mapped.origin);
        lines.fact("bits", Some(&mapped.bits), u8::to_string);
    }
}
