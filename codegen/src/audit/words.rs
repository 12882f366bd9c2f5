//! Rows of facts, and texts compared: what the words of a manual mean.

use std::collections::BTreeMap;

use super::page::Line;
use crate::facts::{FactLine, Table};
use crate::rows::Rows;

/// The facts of one row.
#[derive(Clone, Debug)]
pub(super) struct Row<'f> {
    pub(super) table: Table,
    /// As `map.txt` names it: `object 607D:01`.
    pub(super) key: &'f str,
    pub(super) facts: Vec<&'f FactLine<'f>>,
}

impl<'f> Row<'f> {
    /// The value of a key.
    pub(super) fn value(&self, field: &str) -> Option<&'f str> {
        self.facts.iter().find(|f| f.field == field).map(|f| f.value.as_str())
    }

    /// The key without the name of its table: `607D:01`.
    pub(super) fn id(&self) -> &'f str {
        self.key.split_once(' ').map_or("", |(_, id)| id)
    }
}

/// What printed words mean.
pub(super) struct Words<'a> {
    /// Printed words by key.
    printed: BTreeMap<&'a str, Vec<(&'a str, &'a str)>>,
    /// Words that stand in front of their cell, by key.
    beside: BTreeMap<&'a str, Vec<&'a str>>,
}

impl<'a> Words<'a> {
    pub(super) fn new(rows: &'a Rows) -> Self {
        let mut words = Self { printed: BTreeMap::new(), beside: BTreeMap::new() };
        for row in &rows.printed {
            let pair = (row.word.value.0.as_str(), row.means.value.0.as_str());
            words.printed.entry(&row.field.value.0).or_default().push(pair);
        }
        for row in rows.columns.iter().filter(|c| c.beside.is_some_and(|b| b.value)) {
            words.beside.entry(&row.field.value.0).or_default().push(&row.header.value.0);
        }
        words
    }

    /// Whether `cell`, a value of `field`, means `value`: as printed, or by a word of the profile.
    pub(super) fn means(&self, field: &str, cell: &str, value: &str) -> bool {
        same(cell, value) || self.meanings(field, cell).any(|means| means == value)
    }

    /// What `cell` can mean.
    pub(super) fn meanings<'b>(&'b self, field: &str, cell: &'b str) -> impl Iterator<Item = &'a str> + 'b {
        let list = self.printed.get(field).map_or(&[][..], Vec::as_slice);
        list.iter().filter(move |(word, _)| same(word, cell)).map(|(_, means)| *means)
    }

    /// The printed words of `field` that mean `value`.
    pub(super) fn printed_for<'b>(
        &'b self,
        field: &str,
        value: &'b str,
    ) -> impl Iterator<Item = &'a str> + 'b {
        let list = self.printed.get(field).map_or(&[][..], Vec::as_slice);
        list.iter().filter(move |(_, means)| *means == value).map(|(word, _)| *word)
    }

    /// The cell behind a word that stands in front of it.
    pub(super) fn beside<'l>(&self, field: &str, line: &'l Line) -> Option<&'l str> {
        let words = self.beside.get(field)?;
        let at = line.cells.iter().position(|cell| words.iter().any(|word| same(word, cell)))?;
        line.cells.get(at + 1).map(String::as_str)
    }
}

/// Equal but for case and blanks.
pub(super) fn same(a: &str, b: &str) -> bool {
    letters(a) == letters(b)
}

/// Equal but for blanks, which extracts add and lose.
pub(super) fn same_letters(a: &str, b: &str) -> bool {
    a.split_whitespace().flat_map(str::chars).eq(b.split_whitespace().flat_map(str::chars))
}

/// A text without blanks, in lower case.
pub(super) fn letters(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).flat_map(char::to_lowercase).collect()
}

/// Whether `text` holds `word` as a word of its own, whatever its case.
pub(super) fn holds_word(text: &str, word: &str) -> bool {
    let (text, word) = (text.to_lowercase(), word.to_lowercase());
    let edge = |c: Option<char>| c.is_none_or(|c| !c.is_alphanumeric());
    text.match_indices(&word)
        .any(|(at, _)| edge(text[..at].chars().next_back()) && edge(text[at + word.len()..].chars().next()))
}

/// Whether `text` holds the number, in decimal or hexadecimal: not as a part of `0.5`, `P3.5` or `-5`.
pub(super) fn holds_number(text: &str, n: i128) -> bool {
    let hex = format!("{n:X}");
    let forms =
        [n.to_string(), format!("0x{hex}"), format!("{hex}h"), format!("0x{n:04X}"), format!("0x{n:02X}h")];
    let text = text.to_lowercase();
    forms.iter().map(|form| form.to_lowercase()).any(|form| {
        text.match_indices(&form).any(|(at, _)| stands_alone(&text[..at], &text[at + form.len()..]))
    })
}

/// Whether a number between two texts is a whole one. A dash behind a digit is that of a range.
fn stands_alone(before: &str, after: &str) -> bool {
    let mut back = before.chars().rev();
    let starts = match back.next() {
        Some('.') => false,
        Some('-') => back.next().is_some_and(char::is_alphanumeric),
        before => before.is_none_or(|c| !c.is_alphanumeric()),
    };
    let mut ahead = after.chars();
    let ends = match ahead.next() {
        Some('.') => !ahead.next().is_some_and(|c| c.is_ascii_digit()),
        after => after.is_none_or(|c| !c.is_alphanumeric()),
    };
    starts && ends
}

/// Whether `text` names the parameter: by itself, or in a range such as `P3.09~P3.24`.
pub(super) fn names_parameter(text: &str, parameter: &str) -> bool {
    if holds_word(text, parameter) {
        return true;
    }
    let Some((group, number)) = parameter.rsplit_once('.') else { return false };
    let Ok(number) = number.parse::<u32>() else { return false };
    text.split('~').zip(text.split('~').skip(1)).any(|(before, after)| {
        let end = |part: &str, last: bool| -> Option<u32> {
            let word =
                if last { part.split_whitespace().next_back()? } else { part.split_whitespace().next()? };
            let word = word.trim_matches(|c: char| !c.is_alphanumeric());
            word.strip_prefix(group)?.strip_prefix('.')?.parse().ok()
        };
        end(before, true).zip(end(after, false)).is_some_and(|(from, to)| (from..=to).contains(&number))
    })
}

#[cfg(test)]
mod tests {
    use super::holds_number;

    #[test]
    fn a_part_of_a_number_is_none() {
        for text in ["5", "set 5.", "3-5", "(5)", "0x5"] {
            assert!(holds_number(text, 5), "{text}");
        }
        for text in ["0.5", "P3.5", "-5", "5.0", "15", "5a"] {
            assert!(!holds_number(text, 5), "{text}");
        }
        assert!(holds_number("from -5 to 5", -5) && !holds_number("5", -5));
    }
}
