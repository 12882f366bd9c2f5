//! What a key takes: its kind, how it is read, and what to say when it is something else.

use crate::diag::{Code, code};
use crate::limits;
use crate::model::Cite;
use crate::raw::RawValue;
use crate::raw::literal::{Shape, Takes};
use crate::source::Sp;

/// What a key takes, for messages and the schema.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// Text, of a pattern where one is given.
    Text(Option<&'static str>),
    /// One of some words.
    Words(fn() -> Vec<&'static str>),
    /// `true` or `false`.
    Bool,
    /// A whole number from, to.
    Int(i128, i128),
    /// A whole number, text, or true/false.
    Scalar,
    /// A list.
    List(&'static Kind),
}

impl Kind {
    /// The same for readers of formats without types of their own.
    pub fn shape(&self) -> Shape {
        let takes = match self {
            Self::Text(_) | Self::Words(_) => Takes::Text,
            Self::Bool => Takes::Truth,
            Self::Int(..) => Takes::Number,
            Self::Scalar => Takes::Any,
            Self::List(item) => return Shape { list: true, ..item.shape() },
        };
        Shape { takes, list: false }
    }
}

/// A value that a key takes.
pub trait FromRaw: Sized {
    /// What it is, for messages and the schema.
    const KIND: Kind;
    /// Reads it.
    fn from_raw(raw: &RawValue) -> Result<Self, Expected>;
    /// The value, if it is a citation.
    fn cite(_value: &Sp<Self>) -> Option<&Sp<Cite>> {
        None
    }
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

/// `did you mean` for a word, else the whole list.
pub(crate) fn suggest(word: &str, known: &[&str]) -> String {
    let near = known.iter().filter(|k| k.len().abs_diff(word.len()) <= 2);
    let ranked = near.map(|k| (distance(word, k), letters(word) != letters(k), *k));
    match ranked.filter(|(d, _, k)| *d <= 2 && *d < k.len()).min() {
        Some((_, _, k)) => format!("did you mean `{k}`?"),
        _ if known.len() > limits::SUGGESTIONS => {
            format!("known: {}, ...", known[..limits::SUGGESTIONS].join(", "))
        }
        _ => format!("known: {}", known.join(", ")),
    }
}

/// The letters of a word in alphabetical order: of two words as near, the one with two letters swapped is meant.
fn letters(word: &str) -> Vec<char> {
    let mut letters: Vec<char> = word.chars().collect();
    letters.sort_unstable();
    letters
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
        assert_eq!(suggest("rmp", &["m", "rev", "rpm"]), "did you mean `rpm`?");
        assert_eq!(suggest("zzzz", &["name", "type"]), "known: name, type");
    }
}
