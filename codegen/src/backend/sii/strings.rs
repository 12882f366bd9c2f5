//! The table of strings: each text once, numbered from 1.

use super::loss::Loss;
use crate::backend::unique::capped;
use crate::emit::escape;

/// The length of a string is a byte.
const LONGEST: usize = 255;
/// So is the number of strings, and a reference to one.
const MOST: usize = 255;

/// Each text once.
#[derive(Default)]
pub(super) struct Strings(Vec<String>);

impl Strings {
    /// The number of a text, 0 for none, and what of it is lost.
    pub(super) fn number(&mut self, text: &str) -> (u8, Option<Loss>) {
        let written = capped(&escape::sii(text), LONGEST);
        let changed = (written != text).then_some(Loss::TextChanged);
        if written.is_empty() {
            return (0, changed);
        }
        let at = self.0.iter().position(|other| *other == written).unwrap_or(self.0.len());
        if at == MOST {
            return (0, Some(Loss::TooManyTexts));
        }
        if at == self.0.len() {
            self.0.push(written);
        }
        (u8::try_from(at + 1).unwrap_or(0), changed)
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(String::as_str)
    }

    /// How many there are.
    pub(super) fn count(&self) -> u8 {
        u8::try_from(self.0.len()).unwrap_or(u8::MAX)
    }

    /// A text by its number.
    pub(super) fn get(&self, number: u8) -> Option<&str> {
        self.0.get(usize::from(number).checked_sub(1)?).map(String::as_str)
    }
}
