//! Profile files in both formats, for tests.

#![allow(clippy::panic, clippy::missing_panics_doc, reason = "helpers of tests fail by panicking")]

use drivewright_codegen::convert::convert;
use drivewright_codegen::diag::{Diagnostic, Severity, Sink, render};
use drivewright_codegen::raw::{self, RawValue};
use drivewright_codegen::rows;
use drivewright_codegen::source::{Format, Source, SourceMap};

/// `text` of the format `from` in the format `to`, or the findings.
pub fn converted(text: &str, from: Format, to: Format) -> Result<String, (Vec<Diagnostic>, SourceMap)> {
    let mut sources = SourceMap::default();
    let file = sources.add(format!("case.{}", from.extension()), text);
    convert(file, &sources, rows::shape, to).map_err(|found| (found, sources))
}

fn sure(text: &str, from: Format, to: Format) -> String {
    converted(text, from, to).unwrap_or_else(|(found, sources)| {
        panic!("{}\n{text}", render::text(&found, &sources, render::Style::default()))
    })
}

/// A text of TOML that XML can hold, in XML.
pub fn to_xml(text: &str) -> String {
    sure(text, Format::Toml, Format::Xml)
}

/// A text of XML in TOML.
pub fn to_toml(text: &str) -> String {
    sure(text, Format::Xml, Format::Toml)
}

/// A file of TOML as a file of XML.
pub fn xml_file(source: &Source) -> Source {
    Source { path: source.path.replace(".toml", ".xml"), text: to_xml(&source.text) }
}

/// The raw tree of a text: each table with its rows, and of these keys, kinds and values in order.
pub fn tree(text: &str, format: Format) -> Vec<String> {
    let (mut sources, mut sink) = (SourceMap::default(), Sink::default());
    let file = sources.add(format!("case.{}", format.extension()), text);
    let tables = raw::read(file, &sources, rows::shape, &mut sink);
    assert_eq!(sink.count(Severity::Error), 0, "{:#?}\n{text}", sink.as_slice());
    let rows = tables.iter().map(|table| {
        let row = |row: &raw::RawRow| {
            let field = |f: &raw::RawField| format!("{} = {}", f.key.value, value(&f.value.value));
            row.fields.iter().map(field).collect::<Vec<_>>()
        };
        format!("{} {:#?}", table.name.value, table.rows.iter().map(row).collect::<Vec<_>>())
    });
    rows.collect()
}

fn value(of: &RawValue) -> String {
    match of {
        RawValue::List(items) => {
            format!("list {:?}", items.iter().map(|item| value(&item.value)).collect::<Vec<_>>())
        }
        one => format!("{} {one}", one.kind()),
    }
}

/// Tables in the order of names: TOML has blocks behind the others.
pub fn sorted(mut tree: Vec<String>) -> Vec<String> {
    tree.sort();
    tree
}
