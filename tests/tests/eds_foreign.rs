//! Foreign readers of our EDS files, the Rust ones. `cargo xtask test` runs the Python ones of `tests/judges`.
//!
//! `canopen-host` reads no limits and skips types that it does not know, so those are not judged here.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "tests")]

use std::path::{Path, PathBuf};

use canopen_host::canopen_rs::datatypes::{DataType, Value as Read};
use canopen_host::canopen_rs::object_dictionary::AccessType;
use canopen_host::eds::{self, ObjectDescription};
use drivewright_codegen::backend::eds::Eds;
use drivewright_codegen::model::{Access, Entry, Model, ObjectKind, Value};
use drivewright_codegen::source::Source;
use drivewright_codegen::{compile, emit, load};

/// Every drive of `profiles/`, and one with all types.
fn drives() -> Vec<Model> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../profiles");
    let folders = |of: &Path| -> Vec<PathBuf> {
        let mut found: Vec<PathBuf> =
            std::fs::read_dir(of).expect("a folder").map(|e| e.expect("an entry").path()).collect();
        found.retain(|path| path.is_dir());
        found.sort();
        found
    };
    let vendors = folders(&root).into_iter().filter(|vendor| !vendor.ends_with("standard"));
    let profiles = vendors.flat_map(|vendor| folders(&vendor)).filter(|p| p.join("drive.toml").exists());
    let mut models: Vec<Model> = profiles.map(|profile| sound(load::folder(&profile).sources)).collect();
    models.push(sound(vec![Source { path: "drive.toml".into(), text: ALL_TYPES.into() }]));
    models
}

fn sound(sources: Vec<Source>) -> Model {
    let compiled = compile(sources);
    compiled.sound().cloned().unwrap_or_else(|| panic!("{:#?}", compiled.diagnostics))
}

const ALL_TYPES: &str = r#"
manuals = [ { id = "m1", title = "T", version = "1", sha256 = "0000000000000000000000000000000000000000000000000000000000000000", lines = 10 } ]
objects = [
  { at = "2000:00", name = "Count", type = "u8", access = "ro", default = 12, src = "1 L1" },
  { at = "2000:01", name = "Bool", type = "bool", access = "rw", pdo = "rx", default = 1, src = "1 L1" },
  { at = "2000:02", name = "Least byte", type = "i8", access = "ro", pdo = "tx", default = -128, src = "1 L1" },
  { at = "2000:03", name = "Least word", type = "i16", access = "wo", default = -32768, src = "1 L1" },
  { at = "2000:04", name = "Least long", type = "i32", access = "const", default = -2147483648, src = "1 L1" },
  { at = "2000:05", name = "Least quad", type = "i64", access = "rw", default = -9223372036854775808, src = "1 L1" },
  { at = "2000:06", name = "Most word", type = "u16", access = "rw", default = 65535, src = "1 L1" },
  { at = "2000:07", name = "Most long", type = "u32", access = "rw", pdo = "rx tx", default = 4294967295, src = "1 L1" },
  { at = "2000:08", name = "Quad", type = "u64", access = "rw", default = 9223372036854775807, src = "1 L1" },
  { at = "2000:09", name = "Real", type = "f32", access = "rw", src = "1 L1" },
  { at = "2000:0A", name = "Double", type = "f64", access = "rw", default = 3, src = "1 L1" },
  { at = "2000:0B", name = "Three bytes", type = "i24", access = "rw", default = -1, src = "1 L1" },
  { at = "2000:0C", name = "Text", type = "string", access = "ro", default = "x", src = "1 L1" },
]
[drive]
format = 1
id = "x1"
vendor = "Acme"
vendor_id = "acme"
name = "X1"
crate_version = "0.1.0"
eds_version = 1
eds_revision = 0
date = "2026-01-01"
"#;

fn text(model: &Model) -> String {
    let (files, _) = emit(model, &[&Eds]);
    let (_, bytes) = files.iter().next().expect("one file");
    String::from_utf8(bytes.to_vec()).expect("ASCII")
}

/// What `canopen-host` reads otherwise than the model has it.
fn differences(text: &str, model: &Model) -> Vec<String> {
    let read = match eds::Eds::parse(text) {
        Ok(read) => read,
        Err(error) => return vec![error.to_string()],
    };
    let known: Vec<&Entry> = model.entries.as_slice().iter().filter(|e| data_type(e).is_some()).collect();
    let mut out = Vec::new();
    if read.objects.len() != known.len() {
        out.push(format!("{} entries read, the model has {}", read.objects.len(), known.len()));
    }
    for (read, entry) in read.objects.iter().zip(known) {
        let wanted = wanted(entry, model);
        if found(read) != wanted {
            out.push(format!("{:?}, not {wanted:?}", found(read)));
        }
    }
    out
}

/// Index, sub-index, type, access, whether it can be mapped, default.
type Facts = (u16, u8, Option<DataType>, AccessType, bool, Option<i128>);

fn found(read: &ObjectDescription) -> Facts {
    let (index, sub) = (read.address.index, read.address.subindex);
    (index, sub, Some(read.data_type), read.access, read.pdo_mappable, number(read.default_value))
}

fn wanted(entry: &Entry, model: &Model) -> Facts {
    let access = match entry.access.value {
        Access::Ro => AccessType::Ro,
        Access::Rw => AccessType::Rw,
        Access::Wo => AccessType::Wo,
        Access::Const => AccessType::Const,
    };
    let ty = data_type(entry);
    let object = &model.objects[entry.object];
    let highest = object.entries.last().map_or(0, |id| i128::from(model.entries[*id].address.sub));
    let counts = object.kind.value != ObjectKind::Var && entry.address.sub == 0;
    let default = match (&entry.default, entry.ty.value.range()) {
        (_, None) => None,
        (Some(default), Some(_)) => match default.value {
            Value::Int(n) => Some(n),
            Value::Text(_) => None,
        },
        (None, Some(_)) => Some(if counts { highest } else { 0 }),
    };
    let mapped = entry.mapping.as_ref().is_some_and(|m| m.value.any());
    (entry.address.index, entry.address.sub, ty, access, mapped, default)
}

/// What `canopen-host` calls the type, if it knows it.
fn data_type(entry: &Entry) -> Option<DataType> {
    DataType::from_index(entry.ty.value.cia301_code())
}

/// The integer that was read; it takes an empty default for 0.
fn number(value: Read) -> Option<i128> {
    match value {
        Read::Boolean(b) => Some(b.into()),
        Read::Integer8(n) => Some(n.into()),
        Read::Integer16(n) => Some(n.into()),
        Read::Integer32(n) => Some(n.into()),
        Read::Integer64(n) => Some(n.into()),
        Read::Unsigned8(n) => Some(n.into()),
        Read::Unsigned16(n) => Some(n.into()),
        Read::Unsigned32(n) => Some(n.into()),
        Read::Unsigned64(n) => Some(n.into()),
        _ => None,
    }
}

#[test]
fn canopen_host_reads_what_the_model_has() {
    for model in drives() {
        assert_eq!(differences(&text(&model), &model), Vec::<String>::new(), "{}", model.drive.package);
    }
}

#[test]
fn canopen_host_sees_a_changed_character() {
    let model = sound(vec![Source { path: "drive.toml".into(), text: ALL_TYPES.into() }]);
    let text = text(&model);
    let changes = [
        ("DataType=0x0003", "DataType=0x0006"),
        ("AccessType=wo", "AccessType=ro"),
        ("AccessType=wo", "AccessType=we"),
        ("DefaultValue=-128", "DefaultValue=-127"),
        ("DefaultValue=0xC", "DefaultValue=0xD"),
        ("PDOMapping=1", "PDOMapping=0"),
        ("[2000sub7]", "[2000sub7"),
        ("[2000sub7]", "[2000subD]"),
    ];
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        let broken = text.replacen(from, to, 1);
        assert_ne!(differences(&broken, &model), Vec::<String>::new(), "{from} -> {to}");
    }
}
