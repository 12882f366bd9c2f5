//! A file with everything that a conversion keeps: facts, numbers as written, and comments with the place they belong to.
//!
//! Made of the raw tree, the comments and the text, for both formats alike. A comment belongs to what follows it, one at
//! the end of a line to what stands before it there.

use crate::raw::{Comment, RawField, RawRow, RawTable, RawValue, literal};
use crate::source::{Format, Sp, Span};

/// A file.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub(super) struct Document {
    /// Comments of the file as a whole.
    pub(super) head: Vec<String>,
    pub(super) tables: Vec<Table>,
    /// Comments behind the last table.
    pub(super) tail: Vec<String>,
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Table {
    pub(super) before: Vec<String>,
    pub(super) name: Sp<String>,
    pub(super) rows: Vec<Row>,
    /// Comments behind its last row.
    pub(super) tail: Vec<String>,
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Row {
    pub(super) notes: Notes,
    pub(super) fields: Vec<Field>,
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Field {
    pub(super) notes: Notes,
    pub(super) key: Sp<String>,
    pub(super) value: Value,
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Value {
    One(Scalar),
    List(Vec<(Notes, Scalar)>),
}

/// A value without parts.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Scalar {
    pub(super) value: Sp<RawValue>,
    /// Its text: what a text says, a number in its notation.
    pub(super) text: String,
}

/// Comments before and behind something.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub(super) struct Notes {
    pub(super) before: Vec<String>,
    pub(super) after: Option<String>,
}

impl Notes {
    pub(super) fn is_empty(&self) -> bool {
        self.before.is_empty() && self.after.is_none()
    }

    /// Adds the comment at the end of the line.
    fn trail(&mut self, lines: &[String]) {
        let text = lines.iter().map(|line| line.trim()).collect::<Vec<_>>().join(" ");
        let after = self.after.get_or_insert_default();
        after.truncate(after.trim_end().len());
        after.extend([" ", &text]);
        after.truncate(after.trim_end().len());
    }
}

/// The tables and comments of `text` as one document.
pub(super) fn build(text: &str, format: Format, tables: &[RawTable], comments: &[Comment]) -> Document {
    let mut builder = Builder { text, format, comments, document: Document::default(), last: None, end: 0 };
    for (start, table, row) in visits(tables) {
        match row {
            None => builder.table(start, &tables[table].name),
            Some(row) => builder.row(start, table, row),
        }
    }
    builder.rest();
    builder.document
}

/// Every table and row with its start, in the order of places: rows of two tables may take turns.
fn visits(tables: &[RawTable]) -> Vec<(u32, usize, Option<&RawRow>)> {
    let mut visits = Vec::new();
    for (at, table) in tables.iter().enumerate() {
        let rows = || table.rows.iter().map(|row| (row.span.start, at, Some(row)));
        let start = rows().map(|row| row.0).chain([table.name.span.start]).min().unwrap_or(0);
        visits.push((start, at, None));
        visits.extend(rows());
    }
    visits.sort_by_key(|(start, at, row)| (*start, *at, row.is_some()));
    visits
}

struct Builder<'a> {
    text: &'a str,
    format: Format,
    /// Those that have no place yet.
    comments: &'a [Comment],
    document: Document,
    /// The table whose row was the last one.
    last: Option<usize>,
    /// Where the last value ended.
    end: usize,
}

impl Builder<'_> {
    /// The comments before byte `start`, those that end a line apart.
    fn before(&mut self, start: u32) -> (Vec<Comment>, Vec<Comment>) {
        let count = self.comments.partition_point(|c| c.span.start < start as usize);
        let (taken, rest) = self.comments.split_at(count);
        self.comments = rest;
        taken.iter().cloned().partition(|comment| self.ends_line(comment))
    }

    /// Whether something else stands before a comment in its line.
    fn ends_line(&self, comment: &Comment) -> bool {
        let before = self.text.get(..comment.span.start).unwrap_or_default().trim_end_matches([' ', '\t']);
        !(before.is_empty() || before.ends_with(['\n', '\u{FEFF}']) || before.ends_with("-->"))
    }

    fn table(&mut self, start: u32, name: &Sp<String>) {
        let (trailing, own) = self.before(start);
        let first = self.document.tables.is_empty();
        let own = [self.behind_table(trailing), own].concat();
        let (inside, before): (Vec<_>, Vec<_>) =
            own.into_iter().partition(|comment| !first && comment.depth > 1);
        if let Some(table) = self.document.tables.last_mut() {
            table.tail.extend(lines(&inside));
        }
        let heads = if first { self.heads(&before, start as usize) } else { 0 };
        self.document.head.extend(lines(&before[..heads]));
        let before = lines(&before[heads..]);
        self.document.tables.push(Table { before, name: name.clone(), rows: Vec::new(), tail: Vec::new() });
        self.last = None;
    }

    /// How many of the comments before the first table are of the file: those outside of everything, and in TOML those in
    /// front of the last blank line.
    fn heads(&self, before: &[Comment], start: usize) -> usize {
        let ends = before.iter().skip(1).map(|comment| comment.span.start).chain([start]);
        let ends: Vec<usize> = ends.collect();
        let apart = before.iter().zip(ends).rposition(|(comment, end)| {
            let gap = self.text.get(comment.span.end..end).unwrap_or_default();
            match self.format {
                Format::Xml => comment.depth == 0,
                Format::Toml => comment.depth == 1 && gap.matches('\n').count() > 1,
            }
        });
        apart.map_or(0, |at| at + 1)
    }

    /// Gives comments at the end of a line to the last row. Where that row's table has ended in between, gives them back.
    fn behind_table(&mut self, trailing: Vec<Comment>) -> Vec<Comment> {
        let Some(last) = self.last else { return trailing };
        let Some(table) = self.document.tables.get_mut(last) else { return trailing };
        let (end, single) = (self.end, table.is_single());
        let ended = |c: &Comment| {
            let gap = self.text.get(end..c.span.start).unwrap_or_default();
            c.depth == 0 || c.depth == 1 && !single && (gap.contains(']') || gap.contains("</"))
        };
        let (ended, of_row): (Vec<_>, Vec<_>) = trailing.into_iter().partition(ended);
        if let (Some(row), false) = (table.rows.last_mut(), of_row.is_empty()) {
            row.notes.trail(&lines(&of_row));
        }
        ended
    }

    fn row(&mut self, start: u32, table: usize, row: &RawRow) {
        let (trailing, own) = self.before(start);
        let mut before = Vec::new();
        match self.last.and_then(|last| self.document.tables.get_mut(last)?.rows.last_mut()) {
            Some(row) if !trailing.is_empty() => row.notes.trail(&lines(&trailing)),
            _ => before = lines(&trailing),
        }
        before.extend(lines(&own));
        let mut fields: Vec<Field> = Vec::new();
        for field in &row.fields {
            let notes = self.notes(field.key.span, fields.last_mut().map(|last| &mut last.notes));
            let value = self.value(field);
            fields.push(Field { notes, key: field.key.clone(), value });
        }
        if let Some(table) = self.document.tables.get_mut(table) {
            table.rows.push(Row { notes: Notes { before, after: None }, fields });
        }
        self.last = Some(table);
    }

    /// The comments before something at `span`; those at the end of a line go to what came last, if there is any.
    fn notes(&mut self, span: Span, last: Option<&mut Notes>) -> Notes {
        let (trailing, own) = self.before(span.start);
        let mut before = Vec::new();
        match last {
            Some(notes) if !trailing.is_empty() => notes.trail(&lines(&trailing)),
            _ => before = lines(&trailing),
        }
        before.extend(lines(&own));
        Notes { before, after: None }
    }

    fn value(&mut self, field: &RawField) -> Value {
        let value = match &field.value.value {
            RawValue::List(items) => {
                let mut list: Vec<(Notes, Scalar)> = Vec::new();
                for item in items {
                    let notes = self.notes(item.span, list.last_mut().map(|last| &mut last.0));
                    list.push((notes, self.scalar(item)));
                }
                if let Some((notes, _)) = list.last_mut() {
                    self.behind_item(field.value.span.range().end, notes);
                }
                Value::List(list)
            }
            _ => Value::One(self.scalar(&field.value)),
        };
        self.end = field.value.span.range().end;
        value
    }

    /// Gives the last item of a list that ends before byte `end` the comments behind it in its line.
    fn behind_item(&mut self, end: usize, notes: &mut Notes) {
        while let Some((first, rest)) = self.comments.split_first()
            && first.span.start < end
            && self.ends_line(first)
        {
            notes.trail(&lines(std::slice::from_ref(first)));
            self.comments = rest;
        }
    }

    fn scalar(&self, value: &Sp<RawValue>) -> Scalar {
        let text = match &value.value {
            RawValue::Text(text) => text.clone(),
            RawValue::Int(n) => {
                let written = self.text.get(value.span.range()).unwrap_or_default();
                if literal::whole(written) == Some(*n) { written.to_owned() } else { n.to_string() }
            }
            other => other.to_string(),
        };
        Scalar { value: value.clone(), text }
    }

    /// What stands behind everything.
    fn rest(&mut self) {
        let (trailing, own) = self.before(u32::MAX);
        let own = [self.behind_table(trailing), own].concat();
        let (inside, behind): (Vec<_>, Vec<_>) = own.into_iter().partition(|comment| comment.depth > 1);
        match self.document.tables.last_mut() {
            Some(table) => table.tail.extend(lines(&inside)),
            None => self.document.head = lines(&inside),
        }
        self.document.tail.extend(lines(&behind));
    }
}

impl Table {
    /// Whether the table is written as its only row.
    pub(super) fn is_single(&self) -> bool {
        self.name.value == "drive" && self.rows.len() <= 1
    }
}

/// What comments say, line by line.
fn lines(comments: &[Comment]) -> Vec<String> {
    let mut out = Vec::new();
    for comment in comments {
        let mut parts = comment.text.trim_end().split('\n').map(str::trim_end);
        out.extend(parts.next().map(str::to_owned));
        out.extend(parts.map(|line| format!(" {}", line.trim_start()).trim_end().to_owned()));
    }
    out
}
