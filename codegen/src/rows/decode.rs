//! Decoding of one row: unknown keys, missing keys, values of the wrong kind. Everything wrong in a row is said at once.

use super::value::FromRaw;
use crate::diag::{Code, Diagnostic, Sink, code};
use crate::limits;
use crate::raw::{RawRow, RawValue};
use crate::source::Sp;

/// What a key takes, for messages and the schema.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// Text, of a pattern where one is given.
    Text(Option<&'static str>),
    /// One of some words.
    Words(fn() -> Vec<&'static str>),
    /// A whole number from, to.
    Int(i128, i128),
    /// A whole number, text, or true/false.
    Scalar,
    /// A list.
    List(&'static Kind),
}

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

/// Why a value was refused.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Expected {
    /// The code to report.
    pub code: Code,
    /// What is wrong, with the value in it.
    pub message: String,
    /// Why it is wrong.
    pub why: String,
    /// What to do.
    pub help: String,
}

impl Expected {
    /// A value of another kind than `wanted`.
    pub fn kind(found: &RawValue, wanted: &str) -> Self {
        Self {
            code: code::WRONG_KIND,
            message: format!("expected {wanted}, found {}", found.kind()),
            why: "a value of another kind would have to be guessed at".into(),
            help: format!("write {wanted}"),
        }
    }
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
        self.sink.push(
            Diagnostic::new(
                code::UNKNOWN_KEY,
                key.span,
                format!("`{}` has no key `{}`", self.table.name, key.value),
            )
            .why("a key that is not known would be lost")
            .help(suggest(&key.value, &keys)),
        );
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
            .why(format!("`{key}`: {doc}"))
            .help(format!("add `{key} = ...`")),
        );
    }

    /// Whether all of the row was right.
    pub fn finish(self) -> bool {
        !self.bad
    }
}

/// `did you mean` for a word, else the whole list.
pub(crate) fn suggest(word: &str, known: &[&str]) -> String {
    let near =
        known.iter().filter(|k| k.len().abs_diff(word.len()) <= 2).map(|k| (distance(word, k), *k)).min();
    match near {
        Some((d, k)) if d <= 2 && d < k.len() => format!("did you mean `{k}`?"),
        _ if known.len() > limits::SUGGESTIONS => {
            format!("known: {}, ...", known[..limits::SUGGESTIONS].join(", "))
        }
        _ => format!("known: {}", known.join(", ")),
    }
}

/// Edits between two short words; long ones count as far apart, so that a hostile key costs nothing.
fn distance(a: &str, b: &str) -> usize {
    if a.len() > 64 {
        return usize::MAX;
    }
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let change = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = change.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn suggestions() {
        assert_eq!(suggest("nmae", &["name", "type"]), "did you mean `name`?");
        assert_eq!(suggest("zzzz", &["name", "type"]), "known: name, type");
    }
}
