//! `Cargo.toml`, `README.md` and `lib.rs` of the crate.

use std::fmt::Write;

use serde::Serialize;

use super::lower::{Handle, Lowered};
use super::{Module, behaviour};
use crate::backend::prose::outcome;
use crate::backend::template::render;
use crate::backend::{eds, esi};
use crate::emit::escape::{markdown, one_line};
use crate::model::{Address, Model, Sure};

/// What the templates may name. Everything is escaped for Markdown; TOML strings are escaped by the template.
#[derive(Serialize)]
struct Context {
    package: String,
    module: String,
    version: String,
    vendor: String,
    name: String,
    manuals: Vec<String>,
    objects: usize,
    entries: usize,
    alarms: usize,
    pdos: usize,
    assumed: Vec<String>,
    /// The same of the ESI; nothing for a drive without one.
    assumed_esi: Vec<String>,
    /// Errata with a heading for each degree of doubt, the least sure first.
    errata: Vec<(&'static str, Vec<String>)>,
    identity: Vec<String>,
    homing: usize,
    /// What the tables of behaviour hold, as a list in words.
    behaviour: String,
    example: Option<String>,
}

/// What the manifest says.
#[derive(Serialize)]
struct Manifest<'m> {
    package: &'m str,
    version: &'m str,
    vendor: String,
    name: String,
}

/// The manifest. Ids and versions are checked when they are read, so that they need no escaping.
pub(super) fn cargo_toml(model: &Model) -> String {
    let drive = &model.drive;
    let context = Manifest {
        package: &drive.package,
        version: &drive.crate_version,
        vendor: toml_text(&drive.vendor),
        name: toml_text(&drive.name),
    };
    render(include_str!("res/Cargo.toml.j2"), &context)
}

fn toml_text(text: &str) -> String {
    one_line(text).replace('\\', "\\\\").replace('"', "\\\"")
}

pub(super) fn readme(lowered: &Lowered<'_>) -> String {
    let fit = |h: &&Handle<'_>| h.access == "Rw" && h.ty == "u32" && h.range.is_some();
    // What a cycle carries tells a reader more than what a set-up does.
    let cyclic = lowered.handles.iter().find(|h| fit(h) && h.mapping.starts_with("Rx"));
    let example = cyclic.or_else(|| lowered.handles.iter().find(fit)).map(|h| h.name.clone());
    render(include_str!("res/README.md.j2"), &Context { example, ..context(lowered.model) })
}

const DOUBT: &[(Sure, &str)] = &[
    (Sure::Low, "Doubtful: only the device can settle it"),
    (Sure::Medium, "Likely: confirm it on the device"),
    (Sure::High, "Clear"),
];

fn context(model: &Model) -> Context {
    let drive = &model.drive;
    let manual = |m: &crate::model::Manual| format!("{}, {}", markdown(&m.title), markdown(&m.version));
    let erratum = |e: &crate::model::Erratum| {
        format!(
            "**{}** {} `{}`: printed {}{}. {}",
            markdown(&e.id),
            markdown(&e.at),
            e.field,
            markdown(&e.was),
            outcome(e, markdown),
            markdown(&e.why)
        )
    };
    let of = |sure: Sure| {
        model.errata.as_slice().iter().filter(|e| e.sure == sure).map(erratum).collect::<Vec<_>>()
    };
    let known =
        |sub, what: &str| model.default_int(Address::new(0x1018, sub)).map(|n| format!("{what} `{n:08X}h`"));
    Context {
        package: drive.package.clone(),
        module: drive.package.replace('-', "_"),
        version: drive.crate_version.clone(),
        vendor: markdown(&drive.vendor),
        name: markdown(&drive.name),
        manuals: model.manuals.iter().map(manual).collect(),
        objects: model.objects.len(),
        entries: model.entries.len(),
        alarms: model.alarms.len(),
        pdos: model.pdos.len(),
        homing: model.homing.iter().filter(|m| m.same.is_some() || !m.cases.is_empty()).count(),
        behaviour: behaviour::held(model),
        assumed: eds::assumptions(model).iter().map(|text| markdown(text)).collect(),
        assumed_esi: esi::assumptions(model).iter().map(|text| markdown(text)).collect(),
        errata: DOUBT
            .iter()
            .map(|(sure, title)| (*title, of(*sure)))
            .filter(|(_, l)| !l.is_empty())
            .collect(),
        identity: [known(1, "vendor"), known(2, "product"), known(3, "revision")]
            .into_iter()
            .flatten()
            .collect(),
        example: None,
    }
}

/// The crate's root. Its documentation is the README, whose example is run as a test.
pub(super) fn lib(preamble: &str, modules: &[Module]) -> String {
    let mut out = format!("{preamble}\n{ROOT}");
    for module in modules {
        let _ = write!(out, "\n#[rustfmt::skip]\npub mod {};\n", module.name);
    }
    out.push_str("\npub use table::MODEL;\n");
    out
}

const ROOT: &str = "\
#![doc = include_str!(\"../README.md\")]
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]

// Without rustfmt, since tables have one fact a line, however long.
";
