//! The text extract of a manual as lines and cells. A line with tabs is a row of a printed table; the headings above it, or
//! the profile's word on lines that are out of place, say what its cells hold.

use std::collections::BTreeMap;

use crate::rows::Rows;

/// A manual's text, read as tables where it has any.
pub(super) struct Page {
    lines: Vec<Line>,
}

/// A line of the text.
#[derive(Clone, Default, Debug)]
pub(super) struct Line {
    /// The text without marks of its format.
    pub(super) text: String,
    /// Its cells, where it has tabs.
    pub(super) cells: Vec<String>,
    /// What the cells hold; empty for a table without known headings.
    fields: Vec<String>,
    /// The last index printed in a table of objects up to here.
    index: Option<u16>,
    /// Whether it is a heading.
    pub(super) heading: bool,
    /// The title of the section that it stands in.
    pub(super) section: String,
}

impl Line {
    /// The cell of `field`, if the line has one.
    pub(super) fn cell(&self, field: &str) -> Option<&str> {
        let place = self.fields.iter().position(|f| f == field)?;
        self.cells.get(place).map(String::as_str).filter(|cell| !cell.is_empty())
    }

    /// The index that the row belongs to: its own or that of a row above.
    pub(super) fn index(&self) -> Option<u16> {
        self.cell("name").and(self.index)
    }

    /// The title that the line is, without its number.
    pub(super) fn title(&self) -> Option<&str> {
        let title = title(&self.text)?;
        Some(title.trim_start_matches(|c: char| c.is_ascii_digit() || matches!(c, '.' | ')')).trim_start())
    }

    /// Whether the line is a row of a printed table with content.
    pub(super) fn is_row(&self) -> bool {
        !self.heading && self.cells.iter().filter(|c| !c.is_empty()).count() > 1
    }
}

impl Page {
    /// Reads `text` with the headings and corrections of the profile.
    pub(super) fn new(text: &str, rows: &Rows) -> Self {
        let headings: BTreeMap<&str, &str> = rows
            .columns
            .iter()
            .filter(|c| c.beside.is_none_or(|b| !b.value))
            .map(|c| (c.header.value.0.as_str(), c.field.value.0.as_str()))
            .collect();
        let mut shifted: BTreeMap<usize, Vec<String>> = BTreeMap::new();
        for row in &rows.shifted {
            let fields: Vec<String> = row.fields.value.iter().map(|f| f.0.clone()).collect();
            shifted.extend(row.lines.value.iter().map(|line| (*line as usize, fields.clone())));
        }
        let mut reader =
            Reader { headings, shifted, fields: Vec::new(), index: None, section: String::new() };
        let lines = text.lines().enumerate().map(|(n, text)| reader.line(n + 1, text)).collect();
        Self { lines }
    }

    /// Line `number`, from 1.
    pub(super) fn line(&self, number: u32) -> Option<&Line> {
        self.lines.get((number as usize).checked_sub(1)?)
    }

    /// Every line with its number.
    pub(super) fn lines(&self) -> impl Iterator<Item = (u32, &Line)> {
        (1..).zip(&self.lines)
    }
}

/// Reads line by line; headings hold until a line without cells.
struct Reader<'a> {
    headings: BTreeMap<&'a str, &'a str>,
    shifted: BTreeMap<usize, Vec<String>>,
    fields: Vec<String>,
    index: Option<u16>,
    section: String,
}

impl Reader<'_> {
    fn line(&mut self, number: usize, text: &str) -> Line {
        let text = plain(text);
        if !text.contains('\t') {
            self.fields.clear();
            if let Some(title) = title(&text) {
                title.clone_into(&mut self.section);
            }
            return Line { text, section: self.section.clone(), ..Line::default() };
        }
        let cells: Vec<String> = text.split('\t').map(|cell| cell.trim().to_owned()).collect();
        if let Some(fields) = self.heading(&cells) {
            self.fields.clone_from(&fields);
            return Line { text, cells, heading: true, section: self.section.clone(), ..Line::default() };
        }
        let corrected = self.shifted.get(&number).cloned();
        let mut line =
            Line { text, cells, fields: corrected.unwrap_or_else(|| self.fields.clone()), ..Line::default() };
        if let Some(index) = line.cell("index").and_then(|cell| u16::from_str_radix(cell, 16).ok()) {
            self.index = Some(index);
        }
        line.index = self.index;
        line.section.clone_from(&self.section);
        line
    }

    /// The fields of a row whose cells are all headings, two or more of them known.
    fn heading(&self, cells: &[String]) -> Option<Vec<String>> {
        let field = |cell: &String| self.headings.get(cell.as_str()).map(|f| (*f).to_owned());
        let known = cells.iter().filter_map(field).count();
        let other = cells.iter().filter(|c| !c.is_empty() && field(c).is_none()).count();
        (known >= 2 && other == 0).then(|| cells.iter().map(|c| field(c).unwrap_or_default()).collect())
    }
}

/// The title of a section: behind `#`, or behind a number and a parenthesis.
fn title(text: &str) -> Option<&str> {
    let marked = text.strip_prefix('#').map(|rest| rest.trim_start_matches('#').trim());
    let digits = text.find(|c: char| !c.is_ascii_digit()).filter(|n| *n > 0);
    marked.or_else(|| digits.filter(|n| text[*n..].starts_with(") ")).map(|_| text))
}

/// The text without the marks that an extract keeps of the original's format.
fn plain(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find('<') {
        let (before, tag) = rest.split_at(start);
        out.push_str(before);
        // Marks are words; everything else is text with a `<`.
        let mark = |end: &usize| tag[1..*end].chars().all(|c| c.is_ascii_alphabetic() || c == '/');
        rest = if let Some(end) = tag.find('>').filter(mark) {
            &tag[end + 1..]
        } else {
            out.push('<');
            &tag[1..]
        };
    }
    out.push_str(rest);
    out.replace("**", "").replace('\\', "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_of_the_format_go() {
        assert_eq!(plain("<b>Item</b>\ta < b > c\t**x**\t\\*P1"), "Item\ta < b > c\tx\t*P1");
    }
}
