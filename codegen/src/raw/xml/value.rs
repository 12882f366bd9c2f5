//! Rows and values: the keys of a row as attributes and elements, and what their texts are.

use std::ops::Range;

use quick_xml::events::BytesStart;

use super::tag::{Part, parts};
use super::text::{Where, is_blank, unescape};
use super::tree::{Open, Tree};
use crate::diag::{Diagnostic, code};
use crate::limits;
use crate::raw::literal::{self, Literal, Shape, Takes};
use crate::raw::{RawField, RawRow, RawValue, fraction, too_many, too_wide};
use crate::source::Sp;

/// The row that is being read.
pub(super) struct Row {
    /// Where its start tag begins.
    start: usize,
    fields: Vec<RawField>,
    /// Whether something in it cannot be read: it is left out then.
    pub(super) broken: bool,
    /// Whether it has more keys than a row may have.
    full: bool,
}

impl Row {
    pub(super) fn new(start: usize) -> Self {
        Self { start, fields: Vec::new(), broken: false, full: false }
    }
}

/// The value that is being read: that of a key, or of an item of a list.
pub(super) struct Value {
    shape: Shape,
    /// What the attribute `kind` says that it is.
    kind: Option<Kind>,
    items: Option<Vec<Sp<RawValue>>>,
    /// The first comment in it.
    pub(super) comment: Option<Range<usize>>,
    /// Whether it has been reported.
    pub(super) broken: bool,
}

impl Value {
    /// Whether it can be text: a list has begun with its first item, or is known to be one.
    pub(super) fn is_text(&self) -> bool {
        self.items.is_none() && !self.is_list()
    }

    fn is_list(&self) -> bool {
        self.kind.map_or(self.shape.list, |kind| kind == Kind::List)
    }
}

/// What a value is where that does not follow from its key.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Kind {
    Text,
    Number,
    Truth,
    List,
}

impl Kind {
    pub(crate) const ALL: [Self; 4] = [Self::Text, Self::Number, Self::Truth, Self::List];

    /// The word of the attribute `kind`.
    pub(crate) const fn word(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Number => "number",
            Self::Truth => "bool",
            Self::List => "list",
        }
    }

    fn takes(self) -> Takes {
        match self {
            Self::Text => Takes::Text,
            Self::Number => Takes::Number,
            Self::Truth => Takes::Truth,
            Self::List => Takes::Any,
        }
    }

    fn holds(self, value: &RawValue) -> bool {
        match self {
            Self::Text => matches!(value, RawValue::Text(_)),
            Self::Number => matches!(value, RawValue::Int(_)),
            Self::Truth => matches!(value, RawValue::Bool(_)),
            Self::List => matches!(value, RawValue::List(_)),
        }
    }
}

impl Tree<'_, '_, '_> {
    /// Name and value of an attribute; what is wrong with it is reported.
    pub(super) fn attribute(&mut self, part: Part) -> Option<(Range<usize>, Range<usize>)> {
        let (name, value) = match part {
            Part::Attribute { name, value } => (name, value),
            Part::Wrong(range, message) => {
                self.wrong(range, message);
                return None;
            }
        };
        let text = &self.source[name.clone()];
        if text == "xmlns" || text.contains(':') {
            let message = format!("the attribute `{text}` belongs to a namespace");
            let help =
                "remove it; an editor can be told to use what `drivewright schema --format xsd` prints";
            self.refuse(code::NAMESPACE, name, &message, help);
            return None;
        }
        Some((name, value))
    }

    /// Hands the attribute `wanted` of a tag to `take`; there is no other.
    pub(super) fn only(
        &mut self,
        tag: &BytesStart<'_>,
        wanted: &str,
        mut take: impl FnMut(&mut Self, Range<usize>),
    ) {
        // The first ones are enough.
        for part in parts(tag, self.source).take(limits::KEYS) {
            let Some((name, value)) = self.attribute(part) else { continue };
            let text = &self.source[name.clone()];
            if text == wanted {
                take(self, value);
                continue;
            }
            let message = format!("`<{}>` has an attribute `{text}`", tag.name().into_inner());
            let help =
                "attributes are keys of a row, and `kind` of a value: move it into a row, or remove it";
            self.refuse(code::MISPLACED, name, &message, help);
        }
    }

    /// Adds a key to the row without its value; `false` when the row is not read any further.
    fn add_key(&mut self, name: Range<usize>) -> bool {
        let Some(row) = self.row.as_mut() else { return false };
        let key = &self.source[name.clone()];
        let span = self.report.span(name.clone());
        if row.full {
            return false;
        }
        if row.fields.len() >= limits::KEYS {
            (row.broken, row.full) = (true, true);
            let text = format!("a row has more than {} keys", limits::KEYS);
            self.report.add(too_many(code::TOO_MANY_KEYS, span, &text));
            return false;
        }
        let twice = row.fields.iter().any(|field| field.key.value == key);
        row.fields
            .push(RawField { key: Sp::new(key.to_owned(), span), value: Sp::new(RawValue::Reported, span) });
        if twice {
            self.wrong(name, &format!("the key `{key}` is there twice"));
        }
        true
    }

    /// Gives the key that was added last its value.
    fn set(&mut self, value: RawValue, range: Range<usize>) {
        let value = Sp::new(value, self.report.span(range));
        if let Some(field) = self.row.as_mut().and_then(|row| row.fields.last_mut()) {
            field.value = value;
        }
    }

    /// What the key that was added last takes.
    fn shape(&self) -> Shape {
        let table = self.tables.last().map_or("", |table| table.name.value.as_str());
        let key = self.row.as_ref().and_then(|row| row.fields.last()).map_or("", |f| f.key.value.as_str());
        (self.shapes)(table, key)
    }

    /// Adds a key that is an attribute; `false` when the row is not read any further.
    pub(super) fn add_attribute(&mut self, name: Range<usize>, value: Range<usize>) -> bool {
        if !self.add_key(name.clone()) {
            return false;
        }
        let shape = self.shape();
        let read = if shape.list {
            let key = &self.source[name];
            let message = format!("`{key}` takes a list, which no attribute can hold");
            let help = format!("write `<{key}><item>...</item></{key}>` in the row");
            self.refuse(code::MISPLACED, value.clone(), &message, &help);
            RawValue::Reported
        } else {
            self.read(value.clone(), Where::Attribute, shape.takes, None)
        };
        self.set(read, value);
        true
    }

    /// A key begins that is an element.
    pub(super) fn key(&mut self, open: &Open, tag: &BytesStart<'_>) -> bool {
        if !self.add_key(open.name.clone()) {
            return false;
        }
        let shape = self.shape();
        self.begin_value(shape, tag);
        true
    }

    /// An item of a list begins.
    pub(super) fn item(&mut self, open: &Open, tag: &BytesStart<'_>) -> bool {
        let name = &self.source[open.name.clone()];
        if self.values.len() > 1 {
            let help = "write each fact as a row of its own";
            self.refuse(code::TOO_DEEP, open.name.clone(), "elements are nested too deep", help);
            return false;
        }
        let Some(Value { shape, items, .. }) = self.values.last_mut().filter(|_| name == "item") else {
            let message = format!("`<{name}>` stands in a value");
            let help = "a value is text, or a list of `<item>...</item>`";
            self.refuse(code::MISPLACED, open.name.clone(), &message, help);
            return false;
        };
        items.get_or_insert_default();
        let shape = Shape { list: false, ..*shape };
        self.begin_value(shape, tag);
        true
    }

    fn begin_value(&mut self, shape: Shape, tag: &BytesStart<'_>) {
        self.values.push(Value { shape, kind: None, items: None, comment: None, broken: false });
        self.only(tag, "kind", |tree, range| {
            let word = &tree.source[range.clone()];
            let kind = Kind::ALL.into_iter().find(|kind| kind.word() == word);
            if kind.is_none() {
                let message = format!("`{word}` is no kind of value");
                tree.refuse(code::MISPLACED, range, &message, "write `text`, `number`, `bool` or `list`");
            }
            tree.values.iter_mut().last().into_iter().for_each(|value| value.kind = kind);
        });
    }

    pub(super) fn end_key(&mut self, content: Range<usize>) {
        let Some(value) = self.values.pop() else { return };
        let read = self.value(value, content.clone());
        self.set(read, content);
    }

    pub(super) fn end_item(&mut self, content: Range<usize>) {
        let Some(value) = self.values.pop() else { return };
        let read = match self.value(value, content.clone()) {
            RawValue::List(_) => RawValue::Other("a list in a list"),
            one => one,
        };
        let item = Sp::new(read, self.report.span(content));
        self.values
            .iter_mut()
            .filter_map(|list| list.items.as_mut())
            .for_each(|items| items.push(item.clone()));
    }

    /// The value of an element with that content.
    fn value(&mut self, value: Value, content: Range<usize>) -> RawValue {
        let is_list = value.is_list();
        let text = &self.source[content.clone()];
        match value {
            Value { broken: true, .. } => RawValue::Reported,
            Value { items: Some(items), .. } => {
                // What is known to be a list has had its text looked at.
                let first = text.trim_start_matches(is_blank);
                let start = content.end - first.len();
                if !is_list && !first.starts_with('<') {
                    let end = start + first.find('<').unwrap_or(first.len());
                    let help = "write each value of the list as `<item>...</item>`";
                    self.refuse(code::MISPLACED, start..end, "text stands where none belongs", help);
                    return RawValue::Reported;
                }
                RawValue::List(items)
            }
            _ if is_list => RawValue::List(Vec::new()),
            Value { comment: Some(range), .. } => {
                self.refuse(
                    code::MISPLACED,
                    range,
                    "a comment stands in a value",
                    "move it before the element",
                );
                RawValue::Reported
            }
            Value { shape, kind, .. } => self.read(content, Where::Element, shape.takes, kind),
        }
    }

    /// Reads a text. What cannot be read is reported.
    fn read(&mut self, range: Range<usize>, place: Where, takes: Takes, kind: Option<Kind>) -> RawValue {
        let text = match unescape(&self.source[range.clone()], place) {
            Ok(text) => text,
            Err(wrong) => {
                let at = range.start + wrong.range.start..range.start + wrong.range.end;
                if wrong.code == code::NOT_XML {
                    self.wrong(at, &wrong.message);
                } else {
                    let help = "write the character itself, or its number as in `&#xB5;`";
                    self.report.push(wrong.code, at, &wrong.message, help);
                }
                return RawValue::Reported;
            }
        };
        let span = self.report.span(range);
        match literal::read(&text, kind.map_or(takes, Kind::takes)) {
            Literal::Fraction => self.report.add(fraction(span, &text)),
            Literal::TooWide => self.report.add(too_wide(span)),
            Literal::Value(value) => {
                let Some(kind) = kind.filter(|kind| !kind.holds(&value)) else { return value };
                let message = format!("{} is not of the kind `{}`", value.brief(), kind.word());
                self.report.add(
                    Diagnostic::new(code::BAD_VALUE, span, message)
                        .why("`kind` says what the text is")
                        .help("correct the text or `kind`"),
                );
            }
        }
        RawValue::Reported
    }

    /// The row ends before byte `end`.
    pub(super) fn end_row(&mut self, end: usize) {
        let Some(row) = self.row.take().filter(|row| !row.broken) else { return };
        let span = self.report.span(row.start..end);
        if let Some(table) = self.tables.last_mut() {
            table.rows.push(RawRow { span, fields: row.fields });
        }
    }
}
