//! Citations: `6.2 T6-2 L1230, 4.3 L484`.

use super::kind::{Expected, FromRaw, Kind};
use super::value::Text;
use crate::diag::code;
use crate::model::{Cite, Place};
use crate::raw::RawValue;
use crate::source::Sp;

impl FromRaw for Cite {
    const KIND: Kind = Kind::Text(Some("L[0-9]+"));

    fn cite(value: &Sp<Self>) -> Option<&Sp<Cite>> {
        Some(value)
    }

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let Text(text) = Text::from_raw(raw)?;
        parse(&text).ok_or_else(|| Expected {
            code: code::BAD_CITATION,
            message: format!("`{text}` is no citation"),
            why: "a fact must be found again in the manual: each place needs at least one line of the text extract".into(),
            help: "write `6.2 T6-2 L1230`: section, table, line; several places with commas between".into(),
        })
    }
}

/// Reads a citation: each place ends with at least one line.
pub fn parse(text: &str) -> Option<Cite> {
    let places: Option<Vec<Place>> = text.split(',').map(|p| place(p.trim())).collect();
    places.map(|places| Cite { places })
}

fn place(text: &str) -> Option<Place> {
    let mut place = Place { manual: None, section: None, table: None, lines: Vec::new() };
    for token in text.split_whitespace() {
        if let Some(line) = numbered(token, 'L') {
            place.lines.push(line.parse().ok().filter(|n| *n > 0)?);
        } else if let Some(table) = numbered(token, 'T') {
            place.table.replace(table.to_owned()).is_none().then_some(())?;
        } else if numbered(token, 'm').is_some_and(|n| n.bytes().all(|b| b.is_ascii_digit())) {
            place.manual.replace(token.to_owned()).is_none().then_some(())?;
        } else {
            place.section.replace(token.to_owned()).is_none().then_some(())?;
        }
    }
    (!place.lines.is_empty()).then_some(place)
}

/// What follows `letter` where a digit follows it at once.
fn numbered(token: &str, letter: char) -> Option<&str> {
    token.strip_prefix(letter).filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_and_writes_back() {
        for text in ["6.2 T6-2 L1230", "3.4 L205 L211", "m2 App.II L5762, 4.3 L484"] {
            assert_eq!(parse(text).unwrap().to_string(), text);
        }
        for bad in ["", "6.2", "L0", "6.2 4.3 L1", "L1, ", "Lx L"] {
            assert_eq!(parse(bad), None, "{bad}");
        }
    }
}
