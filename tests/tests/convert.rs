//! Profiles in XML: every profile there is goes to XML and back, and compiles to the same bytes from both.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use drivewright_codegen::convert::convert;
use drivewright_codegen::diag::{Severity, Sink, render};
use drivewright_codegen::emit::RelPath;
use drivewright_codegen::raw::{self, RawTable};
use drivewright_codegen::source::{Format, Source, SourceMap};
use drivewright_codegen::{backend, compile, emit, rows};
use drivewright_tests::cases::{golden_cases, profiles};

/// `text`, a file of the format `from`, in the format `to`, or the findings as a person reads them.
fn converted(text: &str, from: Format, to: Format) -> Result<String, String> {
    let mut sources = SourceMap::default();
    let file = sources.add(format!("case.{}", from.extension()), text);
    convert(file, &sources, rows::shape, to)
        .map_err(|found| render::text(&found, &sources, render::Style::default()))
}

fn to_xml(text: &str) -> String {
    converted(text, Format::Toml, Format::Xml).unwrap_or_else(|found| panic!("{found}\n{text}"))
}

fn to_toml(text: &str) -> String {
    converted(text, Format::Xml, Format::Toml).unwrap_or_else(|found| panic!("{found}\n{text}"))
}

/// The raw tree of a text: names, keys and values in order.
fn tree(text: &str, format: Format) -> Vec<String> {
    let (mut sources, mut sink) = (SourceMap::default(), Sink::default());
    let file = sources.add(format!("case.{}", format.extension()), text);
    let tables = raw::read(file, &sources, rows::shape, &mut sink);
    let found = sink.as_slice();
    assert_eq!(sink.count(Severity::Error), 0, "{found:#?}\n{text}");
    let row = |table: &RawTable| table.rows.iter().map(|row| format!("{:?}", pairs(row))).collect::<Vec<_>>();
    tables.iter().map(|table| format!("{} {:#?}", table.name.value, row(table))).collect()
}

fn pairs(row: &raw::RawRow) -> Vec<(&str, String)> {
    row.fields.iter().map(|f| (f.key.value.as_str(), value(&f.value.value))).collect()
}

fn value(value: &raw::RawValue) -> String {
    format!("{} {value}", value.kind())
}

/// Tables in the order of names: TOML writes blocks behind the others.
fn sorted(mut tree: Vec<String>) -> Vec<String> {
    tree.sort();
    tree
}

/// Every file of every profile and golden case.
fn files() -> Vec<(String, Source)> {
    let golden = golden_cases().into_iter().map(|case| (case.name, case.sources));
    let all = profiles().into_iter().chain(golden);
    all.flat_map(|(name, files)| files.into_iter().map(move |f| (format!("{name}/{}", f.path), f))).collect()
}

#[test]
fn every_profile_goes_to_xml_and_back() {
    for (name, source) in files() {
        let xml = to_xml(&source.text);
        assert_eq!(tree(&xml, Format::Xml), tree(&source.text, Format::Toml), "{name}\n{xml}");
        let toml = to_toml(&xml);
        assert_eq!(
            sorted(tree(&toml, Format::Toml)),
            sorted(tree(&source.text, Format::Toml)),
            "{name}\n{toml}"
        );
        let again = to_xml(&toml);
        assert_eq!(to_xml(&to_toml(&again)), again, "{name}");
    }
}

fn xml_files(sources: &[Source]) -> Vec<Source> {
    let xml = |s: &Source| Source { path: s.path.replace(".toml", ".xml"), text: to_xml(&s.text) };
    sources.iter().map(xml).collect()
}

/// Every file that a profile gives, and what is found, without places.
fn built(sources: Vec<Source>, name: &str) -> (Vec<(RelPath, Vec<u8>)>, Vec<String>) {
    let compiled = compile(sources);
    let model = compiled.sound().unwrap_or_else(|| panic!("{name}: {:#?}", compiled.diagnostics));
    let (files, losses) = emit(model, backend::ALL);
    let files = files.iter().map(|f| (f.0.to_owned(), f.1.to_owned())).collect();
    let found = compiled.diagnostics.iter().chain(&losses);
    (files, found.map(|d| format!("{} {}", d.code.id(), d.message)).collect())
}

#[test]
fn both_formats_give_the_same_bytes() {
    let golden = golden_cases().into_iter().map(|case| (case.name, case.sources));
    let drives = profiles().into_iter().filter(|(name, _)| !name.starts_with("standard/"));
    for (name, sources) in golden.chain(drives) {
        let from_xml = built(xml_files(&sources), &name);
        let mut half = xml_files(&sources);
        half[0] = sources[0].clone();
        assert!(from_xml == built(sources, &name), "{name} differs");
        assert!(from_xml == built(half, &name), "{name} differs when half of it is XML");
    }
}
