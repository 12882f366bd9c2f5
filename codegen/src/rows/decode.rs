//! Decoding of one row: unknown keys, missing keys, values of the wrong kind. Everything wrong in a row is said at once.

use super::kind::{FromRaw, Kind, suggest};
use crate::diag::{Diagnostic, Sink, code};
use crate::raw::{RawRow, RawValue};
use crate::source::Sp;

/// A key of a table.
#[derive(Clone, Copy, Debug)]
pub struct FieldInfo {
    /// The key.
    pub key: &'static str,
    /// What it means.
    pub doc: &'static str,
    /// Whether each row must have it.
    pub required: bool,
    /// What it takes.
    pub kind: Kind,
}

/// A table.
#[derive(Clone, Copy, Debug)]
pub struct TableInfo {
    /// Its name.
    pub name: &'static str,
    /// What a row of it states.
    pub doc: &'static str,
    /// Its keys.
    pub fields: &'static [FieldInfo],
}

/// Decodes the fields of a row.
pub struct Decoder<'a> {
    raw: &'a RawRow,
    table: TableInfo,
    sink: &'a mut Sink,
    bad: bool,
}

impl<'a> Decoder<'a> {
    /// Starts with `raw`; keys that the table does not have are reported here.
    pub fn new(raw: &'a RawRow, table: TableInfo, sink: &'a mut Sink) -> Self {
        let mut decoder = Self { raw, table, sink, bad: false };
        for field in &raw.fields {
            if !table.fields.iter().any(|f| f.key == field.key.value) {
                decoder.unknown_key(&field.key);
            }
        }
        decoder
    }

    fn unknown_key(&mut self, key: &Sp<String>) {
        self.bad = true;
        let keys: Vec<&str> = self.table.fields.iter().map(|f| f.key).collect();
        let text = || format!("`{}` has no key `{}`", self.table.name, key.value);
        self.sink.report(code::UNKNOWN_KEY, || {
            Diagnostic::new(code::UNKNOWN_KEY, key.span, text())
                .why("a key that is not known would be lost")
                .help(suggest(&key.value, &keys))
        });
    }

    /// The value of a key that the row may have.
    pub fn optional<T: FromRaw>(&mut self, key: &str) -> Option<Sp<T>> {
        let raw = self.raw.get(key)?;
        if raw.value == RawValue::Reported {
            self.bad = true;
            return None;
        }
        match T::from_raw(&raw.value) {
            Ok(value) => Some(Sp::new(value, raw.span)),
            Err(expected) => {
                self.bad = true;
                self.sink.push(
                    Diagnostic::new(expected.code, raw.span, format!("`{key}`: {}", expected.message))
                        .why(expected.why)
                        .help(expected.help),
                );
                None
            }
        }
    }

    /// The value of a key that the row must have.
    pub fn required<T: FromRaw>(&mut self, key: &str) -> Option<Sp<T>> {
        if self.raw.get(key).is_none() {
            self.missing(key);
        }
        self.optional(key)
    }

    fn missing(&mut self, key: &str) {
        self.bad = true;
        let doc = self.table.fields.iter().find(|f| f.key == key).map_or("", |f| f.doc.trim());
        self.sink.push(
            Diagnostic::new(
                code::MISSING_KEY,
                self.raw.span,
                format!("a row of `{}` lacks `{key}`", self.table.name),
            )
            .why(format!("every row states it, since nothing is guessed. `{key}`: {doc}"))
            .help(format!("add `{key} = ...`")),
        );
    }

    /// Whether all of the row was right.
    pub fn finish(self) -> bool {
        !self.bad
    }
}
