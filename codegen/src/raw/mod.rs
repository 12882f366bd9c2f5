//! One tree for every input format: tables of rows of keys and values, each with its place.
//!
//! A reader ([`toml`]) makes it, [`crate::rows`] decodes it. Nothing here knows what a key means.

pub mod toml;

use std::fmt::{self, Write};

use crate::limits;
use crate::source::{Sp, Span};

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
