//! The raw tree as it grows, tag by tag: which element may stand where.

use std::ops::Range;

use quick_xml::events::{BytesDecl, BytesStart};

use super::Report;
use super::tag::{parts, place};
use super::text::is_blank;
use super::value::{Row, Value};
use crate::diag::{Code, code};
use crate::limits;
use crate::raw::literal::Shapes;
use crate::raw::{RawTable, too_many};
use crate::source::Sp;

/// What an open element is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Level {
    Profile,
    Table,
    /// A row, or a table that is its only row.
    Row,
    Key,
    Item,
}

/// An element that is open.
pub(super) struct Open {
    level: Level,
    pub(super) name: Range<usize>,
    /// Its start tag.
    pub(super) tag: Range<usize>,
}

/// What has been read so far.
pub(super) struct Tree<'a, 'r, 's> {
    pub(super) source: &'a str,
    pub(super) shapes: Shapes,
    pub(super) report: &'r mut Report<'s>,
    /// From the outside to the inside; never more than there are levels.
    open: Vec<Open>,
    /// How many elements are open below one that is not read.
    skipped: usize,
    rooted: bool,
    pub(super) tables: Vec<RawTable>,
    pub(super) row: Option<Row>,
    /// A key, and in it an item.
    pub(super) values: Vec<Value>,
    /// Whether the file has too many tables, the last table too many rows.
    full: [bool; 2],
}

impl<'a, 'r, 's> Tree<'a, 'r, 's> {
    pub(super) fn new(source: &'a str, shapes: Shapes, report: &'r mut Report<'s>) -> Self {
        let (open, tables, values) = (Vec::new(), Vec::new(), Vec::new());
        Self {
            source,
            shapes,
            report,
            open,
            skipped: 0,
            rooted: false,
            tables,
            row: None,
            values,
            full: [false; 2],
        }
    }

    /// The tables, in the order written.
    pub(super) fn finish(self) -> Vec<RawTable> {
        if let Some(open) = self.open.last() {
            let message = format!("`<{}>` does not end", &self.source[open.name.clone()]);
            self.report.not_xml(open.tag.clone(), &message);
        }
        if !self.rooted {
            let help = "put the tables into `<profile>...</profile>`";
            self.report.push(code::MISPLACED, 0..0, "the file has no element `<profile>`", help);
        }
        if self.full[0] { Vec::new() } else { self.tables }
    }

    /// What is no XML at `range`. The row around it cannot be trusted.
    pub(super) fn wrong(&mut self, range: Range<usize>, message: &str) {
        self.report.not_xml(range, message);
        self.row.iter_mut().for_each(|row| row.broken = true);
    }

    /// What has no place in a profile, or not that one. The value around it is not read.
    pub(super) fn refuse(&mut self, code: Code, range: Range<usize>, message: &str, help: &str) {
        self.report.push(code, range, message, help);
        self.values.iter_mut().for_each(|value| value.broken = true);
    }

    fn name(&self, open: &Open) -> &'a str {
        &self.source[open.name.clone()]
    }

    pub(super) fn declaration(&mut self, declaration: &BytesDecl<'_>, range: Range<usize>) {
        if !declaration.version().is_ok_and(|v| v == "1.0") {
            self.wrong(range.clone(), "the declaration does not say `version=\"1.0\"`");
        }
        match declaration.encoding() {
            Some(Ok(name)) if !name.eq_ignore_ascii_case("utf-8") => {
                let message = format!("the declaration names the encoding `{name}`");
                let help = "save the file as UTF-8, and write `encoding=\"UTF-8\"` or leave it out";
                self.refuse(code::ENCODING, range, &message, help);
            }
            Some(Err(error)) => self.wrong(range, &error.to_string()),
            _ => {}
        }
    }

    /// A comment may stand everywhere but in a text; whether a value is one shows when it ends.
    pub(super) fn comment(&mut self, range: Range<usize>) {
        let inner = &self.source[range.clone()];
        let inner = inner.strip_prefix("<!--").and_then(|rest| rest.strip_suffix("-->")).unwrap_or_default();
        if inner.contains("--") || inner.ends_with('-') {
            self.wrong(range, "a comment holds `--` before its end");
        } else if let Some(value) = self.values.last_mut().filter(|_| self.skipped == 0) {
            value.comment.get_or_insert(range);
        }
    }

    pub(super) fn text(&mut self, range: Range<usize>) {
        let text = &self.source[range.clone()];
        let (begun, ended) = (text.trim_start_matches(is_blank), text.trim_end_matches(is_blank));
        if self.skipped > 0 || begun.is_empty() || self.values.last().is_some_and(Value::is_text) {
            return;
        }
        let help = if self.values.is_empty() {
            "write each fact as an attribute of a row, or remove the text"
        } else {
            "write each value of the list as `<item>...</item>`"
        };
        let range = range.end - begun.len()..range.start + ended.len();
        self.refuse(code::MISPLACED, range, "text stands where none belongs", help);
    }

    /// An element begins.
    pub(super) fn open(&mut self, tag: &BytesStart<'_>, range: Range<usize>) {
        let name = place(self.source, tag.name().into_inner());
        let level = match self.open.last().map(|open| open.level) {
            None => Level::Profile,
            Some(Level::Profile) => Level::Table,
            Some(Level::Table) => Level::Row,
            Some(Level::Row) => Level::Key,
            Some(Level::Key | Level::Item) => Level::Item,
        };
        let mut open = Open { level, name, tag: range };
        if self.skipped > 0 || self.full[0] || self.has_prefix(&open) || !self.enter(&mut open, tag) {
            self.skipped += 1;
        } else {
            self.open.push(open);
        }
    }

    /// Names with a prefix are those of another vocabulary.
    fn has_prefix(&mut self, open: &Open) -> bool {
        let name = self.name(open);
        if name.contains(':') {
            let message = format!("the element `{name}` has a prefix");
            self.refuse(code::NAMESPACE, open.name.clone(), &message, "remove it");
        }
        name.contains(':')
    }

    /// Begins what an element stands for; `false` when it is not read.
    fn enter(&mut self, open: &mut Open, tag: &BytesStart<'_>) -> bool {
        match open.level {
            Level::Profile => self.profile(open, tag),
            Level::Table => self.table(open, tag),
            Level::Row => self.row(open, tag),
            Level::Key => self.key(open, tag),
            Level::Item => self.item(open, tag),
        }
    }

    fn profile(&mut self, open: &Open, tag: &BytesStart<'_>) -> bool {
        let name = self.name(open);
        if std::mem::replace(&mut self.rooted, true) {
            self.wrong(open.name.clone(), "a second element stands at the top of the file");
            return false;
        }
        if name != "profile" {
            let message = format!("the file holds `<{name}>`, not `<profile>`");
            self.refuse(
                code::MISPLACED,
                open.name.clone(),
                &message,
                "put the tables into `<profile>...</profile>`",
            );
            return false;
        }
        self.only(tag, "", |_, _| {});
        true
    }

    fn table(&mut self, open: &mut Open, tag: &BytesStart<'_>) -> bool {
        let name = self.name(open);
        if self.tables.len() >= limits::TABLES {
            self.full[0] = true;
            let text = format!("the file has more than {} tables", limits::TABLES);
            self.report.add(too_many(code::TOO_MANY_TABLES, self.report.span(0..0), &text));
            return false;
        }
        if self.tables.iter().any(|table| table.name.value == name) {
            let message = format!("a second table `{name}`");
            self.refuse(code::MISPLACED, open.name.clone(), &message, "move its rows into the first one");
            return false;
        }
        self.full[1] = false;
        let name = Sp::new(name.to_owned(), self.report.span(open.name.clone()));
        self.tables.push(RawTable { name, rows: Vec::new() });
        if tag.attributes_raw().trim_matches(is_blank).is_empty() {
            return true;
        }
        open.level = Level::Row;
        self.begin_row(open, tag)
    }

    fn row(&mut self, open: &Open, tag: &BytesStart<'_>) -> bool {
        let name = self.name(open);
        if name != "row" {
            let message = format!("`<{name}>` stands in a table");
            let help = "a table holds rows: write `<row ... />`; or give the table attributes, and it is its only row";
            self.refuse(code::MISPLACED, open.name.clone(), &message, help);
        }
        name == "row" && !self.is_full() && self.begin_row(open, tag)
    }

    /// Whether the last table can hold no further row.
    fn is_full(&mut self) -> bool {
        let Some(table) = self.tables.last_mut().filter(|table| table.rows.len() >= limits::ROWS) else {
            return self.full[1];
        };
        table.rows.clear();
        let text = format!("table `{}` has more than {} rows", table.name.value, limits::ROWS);
        self.full[1] = true;
        self.report.add(too_many(code::TOO_MANY_ROWS, table.name.span, &text));
        true
    }

    fn begin_row(&mut self, open: &Open, tag: &BytesStart<'_>) -> bool {
        self.row = Some(Row::new(open.tag.start));
        for part in parts(tag, self.source) {
            let Some((name, value)) = self.attribute(part) else { continue };
            if !self.add_attribute(name, value) {
                self.row = None;
                return false;
            }
        }
        true
    }

    /// An element ends, at an end tag.
    pub(super) fn end(&mut self, name: &str, range: Range<usize>) {
        if self.skipped > 0 {
            self.skipped -= 1;
            return;
        }
        let found = self.open.iter().rposition(|open| self.name(open) == name);
        if found.is_none_or(|at| at + 1 < self.open.len()) {
            let message = match self.open.last() {
                Some(open) => format!("`</{name}>` stands where `</{}>` belongs", self.name(open)),
                None => format!("`</{name}>` ends nothing"),
            };
            self.wrong(range.clone(), &message);
        }
        // What stands between the two does not end of itself.
        let Some(found) = found else { return };
        while self.open.len() > found {
            self.close(range.clone());
        }
    }

    /// The innermost element ends, with an end tag at `range`.
    pub(super) fn close(&mut self, range: Range<usize>) {
        if self.skipped > 0 {
            self.skipped -= 1;
            return;
        }
        let Some(open) = self.open.pop() else { return };
        match open.level {
            Level::Profile | Level::Table => {}
            Level::Row => self.end_row(range.end),
            Level::Key => self.end_key(open.tag.end..range.start),
            Level::Item => self.end_item(open.tag.end..range.start),
        }
    }
}
