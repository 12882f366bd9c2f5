//! A document as XML: a row a line, its keys as attributes. From the first key on that no attribute can hold, keys are
//! elements, so that their order stays.

use super::Refusals;
use super::document::{Document, Field, Notes, Row, Scalar, Table, Value};
use crate::emit::escape;
use crate::raw::RawValue;
use crate::raw::literal::{self, Literal, Shape, Shapes, Takes};
use crate::raw::xml::Kind;
use crate::source::Sp;

/// The text of `document`.
pub(super) fn write(document: &Document, shapes: Shapes, refused: &mut Refusals<'_>) -> String {
    let mut out = Writer { text: "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n".to_owned(), shapes, refused };
    out.comments(0, &document.head);
    out.line(0, "<profile>");
    for table in &document.tables {
        out.table(table);
    }
    out.comments(1, &document.tail);
    out.line(0, "</profile>");
    out.text
}

struct Writer<'a, 'r> {
    text: String,
    shapes: Shapes,
    refused: &'a mut Refusals<'r>,
}

impl Writer<'_, '_> {
    fn begin(&mut self, depth: usize) {
        self.text.extend(std::iter::repeat_n("  ", depth));
    }

    fn line(&mut self, depth: usize, text: &str) {
        self.begin(depth);
        self.text.extend([text, "\n"]);
    }

    fn comments(&mut self, depth: usize, comments: &[String]) {
        for comment in comments {
            self.begin(depth);
            self.comment(comment);
            self.text.push('\n');
        }
    }

    fn comment(&mut self, comment: &str) {
        if let Some(c) = comment.chars().find(|c| !escape::is_xml(*c)) {
            self.refused.comment(&format!("a comment holds {}", c.escape_unicode()));
        }
        self.text.extend(["<!--", &super::comment::to_xml(comment), " -->"]);
    }

    /// Ends a line with the comment that belongs there.
    fn end(&mut self, notes: &Notes) {
        if let Some(after) = &notes.after {
            self.text.push(' ');
            self.comment(after);
        }
        self.text.push('\n');
    }

    fn table(&mut self, table: &Table) {
        self.comments(1, &table.before);
        let name = self.name(&table.name);
        if let [row] = table.rows.as_slice()
            && table.is_single()
            && row.fields.first().is_some_and(|field| self.fits_attribute(table, field))
        {
            return self.row(1, &name, table, row);
        }
        self.line(1, &format!("<{name}>"));
        for row in &table.rows {
            self.row(2, "row", table, row);
        }
        self.comments(2, &table.tail);
        self.line(1, &format!("</{name}>"));
    }

    /// A row as an element `name`; the comments behind the last row of a table that is one stand in it.
    fn row(&mut self, depth: usize, name: &str, table: &Table, row: &Row) {
        self.comments(depth, &row.notes.before);
        let attributes = row.fields.iter().take_while(|field| self.fits_attribute(table, field)).count();
        let (attributes, elements) = row.fields.split_at(attributes);
        self.begin(depth);
        self.text.extend(["<", name]);
        for field in attributes {
            let key = self.name(&field.key);
            let Value::One(scalar) = &field.value else { continue };
            let text = self.value(scalar);
            self.text.extend([" ", &key, "=\"", &text, "\""]);
        }
        let tail = if name == "row" { &[][..] } else { &table.tail };
        if elements.is_empty() && tail.is_empty() {
            self.text.push_str("/>");
        } else {
            self.text.push_str(">\n");
            for field in elements {
                self.field(depth + 1, table, field);
            }
            self.comments(depth + 1, tail);
            self.begin(depth);
            self.text.extend(["</", name, ">"]);
        }
        self.end(&row.notes);
    }

    fn shape(&self, table: &Table, field: &Field) -> Shape {
        (self.shapes)(&table.name.value, &field.key.value)
    }

    fn fits_attribute(&self, table: &Table, field: &Field) -> bool {
        let shape = self.shape(table, field);
        let Value::One(scalar) = &field.value else { return false };
        field.notes.is_empty() && !shape.list && kind(scalar, shape.takes).is_none()
    }

    fn field(&mut self, depth: usize, table: &Table, field: &Field) {
        self.comments(depth, &field.notes.before);
        let (key, shape) = (self.name(&field.key), self.shape(table, field));
        self.begin(depth);
        match &field.value {
            Value::One(scalar) if shape.list => self.element(&key, scalar, None),
            Value::One(scalar) => self.element(&key, scalar, Some(shape.takes)),
            Value::List(items) if items.is_empty() => {
                let kind = if shape.list { "" } else { " kind=\"list\"" };
                self.text.extend(["<", &key, kind, "/>"]);
            }
            Value::List(items) => {
                self.text.extend(["<", &key, ">"]);
                self.items(depth, items, shape.takes);
                self.text.extend(["</", &key, ">"]);
            }
        }
        self.end(&field.notes);
    }

    /// The items of a list: in one line if no comment stands among them.
    fn items(&mut self, depth: usize, items: &[(Notes, Scalar)], takes: Takes) {
        let apart = items.iter().any(|(notes, _)| !notes.is_empty());
        if apart {
            self.text.push('\n');
        }
        for (notes, scalar) in items {
            self.comments(depth + 1, &notes.before);
            if apart {
                self.begin(depth + 1);
            }
            self.element("item", scalar, Some(takes));
            if apart {
                self.end(notes);
            }
        }
        if apart {
            self.begin(depth);
        }
    }

    /// An element with text, and its kind where that does not follow from what the key takes.
    fn element(&mut self, name: &str, scalar: &Scalar, takes: Option<Takes>) {
        let kind = match takes {
            Some(takes) => kind(scalar, takes),
            None => plain(scalar),
        };
        let kind = kind.map_or(String::new(), |kind| format!(" kind=\"{}\"", kind.word()));
        let text = self.value(scalar);
        self.text.extend(["<", name, &kind, ">", &text, "</", name, ">"]);
    }

    fn value(&mut self, scalar: &Scalar) -> String {
        if plain(scalar).is_none() {
            let what = format!("{} cannot be written in XML", scalar.value.value.kind());
            self.refused.value(scalar.value.span, &what);
        }
        if let Some(c) = scalar.text.chars().find(|c| !escape::is_xml(*c)) {
            self.refused
                .value(scalar.value.span, &format!("XML cannot hold the character {}", c.escape_unicode()));
        }
        escape::xml(&scalar.text)
    }

    fn name(&mut self, name: &Sp<String>) -> String {
        let begins = |c: char| c.is_ascii_alphabetic() || c == '_';
        let goes_on = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '.');
        if !name.value.starts_with(begins) || !name.value.chars().all(goes_on) || name.value == "xmlns" {
            self.refused.value(name.span, &format!("`{}` is no name in XML", name.value));
        }
        name.value.clone()
    }
}

/// The kind of a value that XML can hold.
fn plain(scalar: &Scalar) -> Option<Kind> {
    match &scalar.value.value {
        RawValue::Text(_) => Some(Kind::Text),
        RawValue::Int(_) => Some(Kind::Number),
        RawValue::Bool(_) => Some(Kind::Truth),
        _ => None,
    }
}

/// The kind of a value, where a key that `takes` something would be read as another one.
fn kind(scalar: &Scalar, takes: Takes) -> Option<Kind> {
    let same =
        matches!(literal::read(&scalar.text, takes), Literal::Value(value) if value == scalar.value.value);
    if same { None } else { plain(scalar) }
}
