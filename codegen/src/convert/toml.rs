//! A document as TOML: a row a line. The drive, and tables with comments between the keys of a row, are blocks below the
//! others, since no list of rows can follow a block.

use super::Refusals;
use super::document::{Document, Field, Notes, Row, Scalar, Table, Value};
use crate::emit::escape;
use crate::raw::RawValue;

/// The text of `document`.
pub(super) fn write(document: &Document, refused: &mut Refusals<'_>) -> String {
    let mut out = Writer { text: String::new(), refused };
    out.comments(0, &document.head);
    let (blocks, lists): (Vec<&Table>, Vec<&Table>) =
        document.tables.iter().partition(|table| is_block(table));
    if !document.head.is_empty() && !document.tables.is_empty() {
        out.text.push('\n');
    }
    for table in &lists {
        out.list(table);
    }
    for table in &blocks {
        out.blocks(table);
    }
    if !blocks.is_empty() && !document.tail.is_empty() {
        out.text.push('\n');
    }
    out.comments(0, &document.tail);
    out.text
}

/// Whether a table is written as `[table]` or `[[table]]`.
fn is_block(table: &Table) -> bool {
    let noted = |row: &Row| row.fields.iter().any(|field| !field.notes.is_empty());
    table.is_single() && !table.rows.is_empty() || table.rows.iter().any(noted)
}

struct Writer<'a, 'r> {
    text: String,
    refused: &'a mut Refusals<'r>,
}

impl Writer<'_, '_> {
    fn begin(&mut self, depth: usize) {
        self.text.extend(std::iter::repeat_n("  ", depth));
    }

    fn comments(&mut self, depth: usize, comments: &[String]) {
        for comment in comments {
            self.begin(depth);
            self.comment(comment);
            self.text.push('\n');
        }
    }

    fn comment(&mut self, comment: &str) {
        if let Some(c) = comment.chars().find(|c| c.is_ascii_control() && *c != '\t') {
            self.refused.comment(&format!("a comment holds {}", c.escape_unicode()));
        }
        self.text.extend(["#", comment]);
    }

    /// Ends a line with the comment that belongs there.
    fn end(&mut self, notes: &Notes) {
        if let Some(after) = &notes.after {
            self.text.push(' ');
            self.comment(after);
        }
        self.text.push('\n');
    }

    fn list(&mut self, table: &Table) {
        self.comments(0, &table.before);
        self.key(&table.name.value);
        if table.rows.is_empty() && table.tail.is_empty() {
            return self.text.push_str(" = []\n");
        }
        self.text.push_str(" = [\n");
        for row in &table.rows {
            self.comments(1, &row.notes.before);
            self.text.push_str("  { ");
            for (at, field) in row.fields.iter().enumerate() {
                self.text.push_str(if at == 0 { "" } else { ", " });
                self.field(1, field);
            }
            self.text.push_str(if row.fields.is_empty() { "}," } else { " }," });
            self.end(&row.notes);
        }
        self.comments(1, &table.tail);
        self.text.push_str("]\n");
    }

    fn blocks(&mut self, table: &Table) {
        for (at, row) in table.rows.iter().enumerate() {
            if !self.text.is_empty() && !self.text.ends_with("\n\n") {
                self.text.push('\n');
            }
            self.comments(0, if at == 0 { &table.before } else { &[] });
            self.comments(0, &row.notes.before);
            let (open, close) = if table.is_single() { ("[", "]\n") } else { ("[[", "]]\n") };
            self.text.push_str(open);
            self.key(&table.name.value);
            self.text.push_str(close);
            for (at, field) in row.fields.iter().enumerate() {
                self.comments(0, &field.notes.before);
                self.field(0, field);
                let last = at + 1 == row.fields.len();
                let after = field.notes.after.iter().chain(row.notes.after.iter().filter(|_| last));
                let after = after.map(String::as_str).collect::<Vec<_>>();
                self.end(&Notes { before: Vec::new(), after: (!after.is_empty()).then(|| after.join("")) });
            }
        }
        self.comments(0, &table.tail);
    }

    fn key(&mut self, key: &str) {
        let bare = |b: u8| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'-');
        if !key.is_empty() && key.bytes().all(bare) {
            self.text.push_str(key);
        } else {
            self.text.extend(["\"", &escape::toml_str(key), "\""]);
        }
    }

    fn field(&mut self, depth: usize, field: &Field) {
        self.key(&field.key.value);
        self.text.push_str(" = ");
        match &field.value {
            Value::One(scalar) => self.scalar(scalar),
            Value::List(items) => self.items(depth, items),
        }
    }

    /// A list: in one line if no comment stands in it.
    fn items(&mut self, depth: usize, items: &[(Notes, Scalar)]) {
        let apart = items.iter().any(|(notes, _)| !notes.is_empty());
        self.text.push_str(if apart { "[\n" } else { "[" });
        for (at, (notes, scalar)) in items.iter().enumerate() {
            self.comments(depth + 1, &notes.before);
            match (apart, at) {
                (true, _) => self.begin(depth + 1),
                (false, 0) => {}
                (false, _) => self.text.push(' '),
            }
            self.scalar(scalar);
            if apart || at + 1 < items.len() {
                self.text.push(',');
            }
            if apart {
                self.end(notes);
            }
        }
        self.begin(if apart { depth } else { 0 });
        self.text.push(']');
    }

    fn scalar(&mut self, scalar: &Scalar) {
        match &scalar.value.value {
            RawValue::Text(text) => self.text.extend(["\"", &escape::toml_str(text), "\""]),
            RawValue::Int(_) | RawValue::Bool(_) => self.text.push_str(&scalar.text),
            other => self.refused.value(scalar.value.span, &format!("{} cannot be converted", other.kind())),
        }
    }
}
