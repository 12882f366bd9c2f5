//! One tree for every input format: tables of rows of keys and values, each with its place.
//!
//! A reader ([`toml`], [`xml`]) makes it, [`crate::rows`] decodes it. Nothing here knows what a key means.

pub mod literal;
pub mod toml;
pub mod xml;

use std::fmt::{self, Write};
use std::ops::Range;

use crate::diag::{Code, Diagnostic, Sink, code};
use crate::limits;
use crate::source::{FileId, Format, SourceMap, Sp, Span};
use literal::Shapes;

/// Reads the tables of `file`, which is TOML unless its name says otherwise. `shapes` says what a key takes.
pub fn read(file: FileId, sources: &SourceMap, shapes: Shapes, sink: &mut Sink) -> Vec<RawTable> {
    match Format::of(sources.path(file)) {
        Some(Format::Xml) => xml::read(file, sources, shapes, sink),
        Some(Format::Toml) | None => toml::read(file, sources, sink),
    }
}

/// A comment of a file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Comment {
    /// What it says, without the signs around it.
    pub(crate) text: String,
    /// Where it stands, those signs included.
    pub(crate) span: Range<usize>,
    /// How deep it stands: 0 outside of everything, 1 between tables, 2 in a table.
    pub(crate) depth: usize,
}

/// More than a file, table or row may hold. What is in it is not looked at.
fn too_many(code: Code, span: Span, text: &str) -> Diagnostic {
    let (most, help) = match code {
        code::TOO_MANY_TABLES => (limits::TABLES, "put the rows of one kind into one table"),
        code::TOO_MANY_KEYS => (limits::KEYS, "write each fact as a row of its own"),
        _ => (limits::ROWS, "split the drive, or remove rows that repeat a fact"),
    };
    Diagnostic::new(code, span, text)
        .why(format!("it holds at most {most}, so that every finding is said in a moment"))
        .help(help)
}

/// A whole number that no reader can keep.
fn too_wide(span: Span) -> Diagnostic {
    Diagnostic::new(code::NUMBER_RANGE, span, "a number of more than 127 bits")
        .why("no object of a drive is wider than 64 bits")
        .help("correct the number")
}

/// A number that is not whole.
fn fraction(span: Span, text: &str) -> Diagnostic {
    Diagnostic::new(code::FLOAT, span, format!("`{text}` is a number with a fraction"))
        .why("profiles are exact: values are raw counts, and the unit carries the factor")
        .help("write the raw count; a range printed 0.1 to 6000.0 at 0.1 rpm is 1 to 60000")
}

/// What a value can be. There are no floating-point numbers: a profile is exact.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum RawValue {
    /// Text.
    Text(String),
    /// A whole number, in any notation.
    Int(i128),
    /// `true` or `false`.
    Bool(bool),
    /// A list.
    List(Vec<Sp<RawValue>>),
    /// Something that no field takes, with its name.
    Other(&'static str),
    /// Something that is wrong by itself; the reader has reported it.
    Reported,
}

impl RawValue {
    /// What it is, for messages.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Text(_) => "text",
            Self::Int(_) => "a whole number",
            Self::Bool(_) => "true or false",
            Self::List(_) => "a list",
            Self::Other(kind) => kind,
            Self::Reported => "a value that cannot be read",
        }
    }

    /// As written, for messages: a long value is cut, however long it is.
    pub fn brief(&self) -> String {
        let mut brief = Brief(String::new());
        if write!(brief, "{self}").is_err() {
            brief.0.push_str("...");
        }
        brief.0
    }
}

/// Takes what is written to it until it is full.
struct Brief(String);

impl Write for Brief {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for c in text.chars() {
            if self.0.len() >= limits::BRIEF_BYTES {
                return Err(fmt::Error);
            }
            self.0.push(c);
        }
        Ok(())
    }
}

impl fmt::Display for RawValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text(t) => write!(f, "{t:?}"),
            Self::Int(n) => write!(f, "{n}"),
            Self::Bool(b) => write!(f, "{b}"),
            Self::List(items) => {
                f.write_str("[")?;
                for (place, item) in items.iter().enumerate() {
                    let comma = if place == 0 { "" } else { ", " };
                    write!(f, "{comma}{}", item.value)?;
                }
                f.write_str("]")
            }
            Self::Other(_) | Self::Reported => f.write_str(self.kind()),
        }
    }
}

/// A key and its value.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RawField {
    /// The key.
    pub key: Sp<String>,
    /// The value.
    pub value: Sp<RawValue>,
}

/// A row: a fact with its keys, in the order written.
#[derive(Clone, Debug)]
pub struct RawRow {
    /// The whole row.
    pub span: Span,
    /// Its fields.
    pub fields: Vec<RawField>,
}

impl RawRow {
    /// The value of `key`.
    pub fn get(&self, key: &str) -> Option<&Sp<RawValue>> {
        self.fields.iter().find(|f| f.key.value == key).map(|f| &f.value)
    }

    /// Takes `key` out.
    pub fn unset(&mut self, key: &str) {
        self.fields.retain(|f| f.key.value != key);
    }

    /// Replaces or adds the value of `key`.
    pub fn set(&mut self, key: &str, value: Sp<RawValue>) {
        match self.fields.iter_mut().find(|f| f.key.value == key) {
            Some(field) => field.value = value,
            None => self.fields.push(RawField { key: Sp::new(key.to_owned(), value.span), value }),
        }
    }
}

/// A table: rows of one kind.
#[derive(Clone, Debug)]
pub struct RawTable {
    /// Its name.
    pub name: Sp<String>,
    /// Its rows, in the order written.
    pub rows: Vec<RawRow>,
}
