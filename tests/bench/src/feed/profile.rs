//! The drive as a profile of many files.

use std::fmt::Write;

use drivewright_codegen::source::Source;

use crate::synthetic::{Drive, Entry, Object, Table};

/// Files that objects are spread over at most.
const FILES: usize = 50;
/// PDOs of each direction, and entries of each.
const PDOS: usize = 4;
const PDO_ENTRIES: usize = 8;

const DRIVE: &str = r#"
manuals = [ { id = "m1", title = "S1 user manual", version = "V1.0", date = "2025-01", sha256 = "1111111111111111111111111111111111111111111111111111111111111111", lines = 99999 } ]
[drive]
format = 1
id = "s1"
vendor = "Acme"
vendor_id = "acme"
name = "S1"
crate_version = "0.1.0"
eds_version = 1
eds_revision = 0
date = "2026-01-01"
"#;

/// The files of `drive`.
pub fn write(drive: &Drive) -> Vec<Source> {
    let many = drive.objects.len().div_ceil(FILES).max(100);
    let objects = drive.objects.chunks(many).enumerate();
    let mut files: Vec<Source> = objects
        .map(|(n, chunk)| source(&format!("objects-{n:02}.toml"), &table("objects", chunk, object)))
        .collect();
    files.push(source("drive.toml", DRIVE));
    files.push(source("enums.toml", &table("enums", &drive.tables, values)));
    let alarms: Vec<usize> = (1..=drive.alarms).collect();
    files.push(source("alarms.toml", &table("alarms", &alarms, alarm)));
    files.push(source("pdo.toml", &table("pdo", &["rx", "tx"], |text, dir| mappings(text, drive, dir))));
    files
}

fn source(path: &str, text: &str) -> Source {
    Source { path: path.into(), text: text.into() }
}

fn table<T>(name: &str, rows: &[T], write: impl Fn(&mut String, &T)) -> String {
    let mut text = format!("{name} = [\n");
    rows.iter().for_each(|row| write(&mut text, row));
    text + "]\n"
}

fn object(text: &mut String, object: &Object) {
    let Object { index, name, entries } = object;
    if entries.len() > 1 {
        let _ = writeln!(
            text,
            "  {{ at = \"{index:04X}\", name = \"{name}\", kind = \"record\", src = \"6 L{index}\" }},"
        );
    }
    entries.iter().for_each(|e| entry(text, *index, e));
}

fn entry(text: &mut String, index: u16, entry: &Entry) {
    let Entry { sub, name, ty, .. } = entry;
    let (sign, access) = (if ty.signed { 'i' } else { 'u' }, if entry.writable { "rw" } else { "ro" });
    let _ = write!(
        text,
        "  {{ at = \"{index:04X}:{sub:02X}\", name = \"{name}\", type = \"{sign}{}\", access = \"{access}\"",
        ty.bits
    );
    let _ = write!(text, ", pdo = \"{}\"", direction(entry).unwrap_or("no"));
    let _ = entry.unit.map(|unit| write!(text, ", unit = \"{unit}\""));
    let _ =
        entry.range.map(|[min, max, first]| write!(text, ", min = {min}, max = {max}, default = {first}"));
    let _ = entry.table.map(|n| write!(text, ", values = \"table {n}\""));
    let _ = entry.text.as_ref().map(|words| write!(text, ", text = \"{words}\""));
    let _ = writeln!(text, ", src = \"6 L{index}\" }},");
}

fn direction(entry: &Entry) -> Option<&'static str> {
    entry.mapped.then_some(if entry.writable { "rx" } else { "tx" })
}

fn values(text: &mut String, table: &Table) {
    for (value, label) in table.labels.iter().enumerate() {
        let _ = writeln!(
            text,
            "  {{ name = \"{}\", value = {value}, label = \"{label}\", src = \"7 L70\" }},",
            table.name
        );
    }
}

fn alarm(text: &mut String, number: &usize) {
    let _ = writeln!(
        text,
        "  {{ display = \"Er.{number}\", number = {number}, code = 0xFF{:02X}, name = \"Fault {number}\", reset = \"resettable\", causes = [\"A part of the axis is blocked.\", \"A gain is too high.\"], remedies = [\"Free the axis.\", \"Lower the gain.\"], src = \"8 L80\" }},",
        number % 256
    );
}

fn mappings(text: &mut String, drive: &Drive, dir: &str) {
    let entries = drive.objects.iter().flat_map(|o| o.entries.iter().map(move |e| (o.index, e)));
    let mapped = entries.filter(|(_, e)| direction(e) == Some(dir));
    let first = if dir == "rx" { 0x1600 } else { 0x1A00 };
    for (n, (index, entry)) in mapped.take(PDOS * PDO_ENTRIES).enumerate() {
        let (map, pos) = (first + n / PDO_ENTRIES, n % PDO_ENTRIES + 1);
        let _ = writeln!(
            text,
            "  {{ map = 0x{map:X}, dir = \"{dir}\", pos = {pos}, entry = \"{index:04X}:{:02X}\", bits = {}, src = \"9 L90\" }},",
            entry.sub, entry.ty.bits
        );
    }
}
