//! TOML to the raw tree. The only module that knows the `toml` crate.
//!
//! Reading never fails: every syntax error of a file is reported, rows that hold one are left out, and the others go on.

use std::ops::Range;

use ::toml::Spanned;
use ::toml::de::{DeArray, DeInteger, DeTable, DeValue};
use toml_parser::lexer::TokenKind;

use super::{Comment, RawField, RawRow, RawTable, RawValue, fraction, too_many, too_wide};
use crate::diag::{Code, Diagnostic, Sink, code};
use crate::limits;
use crate::source::{FileId, SourceMap, Sp, Span};

/// Reads the tables of `file`.
pub fn read(file: FileId, sources: &SourceMap, sink: &mut Sink) -> Vec<RawTable> {
    let (root, errors) = DeTable::parse_recoverable(sources.text(file));
    let mut reader = Reader { file, sink, broken: Vec::new() };
    for error in errors {
        let span = error.span().unwrap_or(0..0);
        reader.broken.push(span.clone());
        reader.sink.push(syntax(Span::new(file, span), error.message()));
    }
    reader.broken.sort_by_key(|b| (b.end, b.start));
    reader.tables(root.get_ref())
}

/// The comments of a text that [`read`] finds no fault with, in order.
pub(crate) fn comments(text: &str) -> Vec<Comment> {
    let (mut depth, mut found) = (1_usize, Vec::new());
    for token in toml_parser::Source::new(text).lex() {
        let span = token.span().start()..token.span().end();
        match token.kind() {
            TokenKind::LeftSquareBracket | TokenKind::LeftCurlyBracket => depth += 1,
            TokenKind::RightSquareBracket | TokenKind::RightCurlyBracket => depth = depth.saturating_sub(1),
            TokenKind::Comment => {
                let inner = text.get(span.clone()).and_then(|t| t.strip_prefix('#')).unwrap_or_default();
                found.push(Comment { text: inner.to_owned(), span, depth });
            }
            _ => {}
        }
    }
    found
}

/// What the parser says. It goes down a fixed number of levels and names no kind of error but in words.
fn syntax(span: Span, message: &str) -> Diagnostic {
    if message.contains("recurs") {
        return Diagnostic::new(code::TOO_DEEP, span, "values are nested too deep")
            .why("a table holds rows, a row holds values, and a value is at most a list")
            .help("write each fact as a row of its own");
    }
    Diagnostic::new(code::SYNTAX, span, message)
        .why("the file must be TOML 1.0 before any of it can be trusted")
        .help("correct the text at the marked place; the row that holds it was left out of this run")
}

struct Reader<'a> {
    file: FileId,
    sink: &'a mut Sink,
    broken: Vec<Range<usize>>,
}

impl Reader<'_> {
    fn span(&self, range: Range<usize>) -> Span {
        Span::new(self.file, range)
    }

    fn tables(&mut self, root: &DeTable<'_>) -> Vec<RawTable> {
        let mut tables = Vec::new();
        if root.len() > limits::TABLES {
            self.too_many(code::TOO_MANY_TABLES, 0..0, &format!("the file has {} tables", root.len()));
            return tables;
        }
        for (key, value) in in_order(root) {
            let name = Sp::new(key.get_ref().to_string(), self.span(key.span()));
            let rows = match value.get_ref() {
                DeValue::Table(fields) => self.row(fields, value.span()).into_iter().collect(),
                DeValue::Array(items) => self.rows(items, &name),
                other => {
                    self.not_a_table(&name, other.type_str());
                    continue;
                }
            };
            tables.push(RawTable { name, rows });
        }
        tables
    }

    fn not_a_table(&mut self, name: &Sp<String>, kind: &str) {
        if self.is_broken(&name.span.range()) {
            return;
        }
        let text = format!("`{}` is a single value ({kind}), not a table", name.value);
        self.sink.push(
            Diagnostic::new(code::WRONG_KIND, name.span, text)
                .why("at the top of a profile file stand tables: one list of rows each")
                .help(format!("write `{} = [ {{ ... }}, ]`, or move the key into a row", name.value)),
        );
    }

    fn rows(&mut self, items: &DeArray<'_>, name: &Sp<String>) -> Vec<RawRow> {
        let mut rows = Vec::with_capacity(items.len());
        if items.len() > limits::ROWS {
            let text = format!("table `{}` has {} rows", name.value, items.len());
            self.too_many(code::TOO_MANY_ROWS, name.span.range(), &text);
            return rows;
        }
        for item in items {
            match item.get_ref() {
                DeValue::Table(fields) => rows.extend(self.row(fields, item.span())),
                other => self.not_a_row(name, item.span(), other.type_str()),
            }
        }
        rows
    }

    fn too_many(&mut self, code: Code, span: Range<usize>, text: &str) {
        self.sink.push(too_many(code, self.span(span), text));
    }

    fn not_a_row(&mut self, name: &Sp<String>, span: Range<usize>, kind: &str) {
        if self.is_broken(&span) {
            return;
        }
        let text = format!("a row of `{}` is a single value ({kind})", name.value);
        self.sink.push(
            Diagnostic::new(code::WRONG_KIND, self.span(span), text)
                .why("each row is one fact with named values")
                .help("write `{ key = value, ... }`"),
        );
    }

    fn row(&mut self, fields: &DeTable<'_>, span: Range<usize>) -> Option<RawRow> {
        if fields.len() > limits::KEYS {
            self.too_many(code::TOO_MANY_KEYS, span, &format!("a row has {} keys", fields.len()));
            return None;
        }
        let fields: Vec<RawField> = in_order(fields).map(|(key, value)| self.field(key, value)).collect();
        // The span of a `[table]` is its header alone: widen it to what it holds.
        let end = fields.iter().map(|f| f.value.span.end as usize).max().unwrap_or(span.end).max(span.end);
        if self.is_broken(&(span.start..end)) {
            return None;
        }
        Some(RawRow { span: self.span(span), fields })
    }

    fn field(&mut self, key: &Spanned<std::borrow::Cow<'_, str>>, value: &Spanned<DeValue<'_>>) -> RawField {
        RawField {
            key: Sp::new(key.get_ref().to_string(), self.span(key.span())),
            value: Sp::new(self.value(value, true), self.span(value.span())),
        }
    }

    /// Lists hold plain values only, so this goes down one level and no further.
    fn value(&mut self, value: &Spanned<DeValue<'_>>, lists: bool) -> RawValue {
        match value.get_ref() {
            DeValue::String(text) => RawValue::Text(text.to_string()),
            DeValue::Integer(number) => self.integer(number, value.span()),
            DeValue::Boolean(b) => RawValue::Bool(*b),
            DeValue::Float(number) => {
                self.sink.push(fraction(self.span(value.span()), number.as_str()));
                RawValue::Reported
            }
            DeValue::Datetime(_) => RawValue::Other("a date without quotes"),
            DeValue::Table(_) => RawValue::Other("a table"),
            DeValue::Array(_) if !lists => RawValue::Other("a list in a list"),
            DeValue::Array(items) => RawValue::List(
                items.iter().map(|i| Sp::new(self.value(i, false), self.span(i.span()))).collect(),
            ),
        }
    }

    fn integer(&mut self, number: &DeInteger<'_>, span: Range<usize>) -> RawValue {
        if let Ok(n) = i128::from_str_radix(number.as_str(), number.radix()) {
            return RawValue::Int(n);
        }
        self.sink.push(too_wide(self.span(span)));
        RawValue::Reported
    }

    /// Whether a syntax error lies in `span` or touches it.
    fn is_broken(&self, span: &Range<usize>) -> bool {
        let next = self.broken.partition_point(|b| b.end < span.start);
        self.broken.get(next).is_some_and(|b| b.start <= span.end)
    }
}

/// The entries of a table in the order written.
fn in_order<'a, 'i>(
    table: &'a DeTable<'i>,
) -> impl Iterator<Item = (&'a Spanned<std::borrow::Cow<'i, str>>, &'a Spanned<DeValue<'i>>)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries.into_iter()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> (Vec<RawTable>, Sink) {
        let (mut sources, mut sink) = (SourceMap::default(), Sink::default());
        let file = sources.add("a.toml", text);
        (read(file, &sources, &mut sink), sink)
    }

    #[test]
    fn rows_keep_order_and_places() {
        let (tables, sink) = parse("objects = [\n  { z = 1, a = 0x10 },\n]\n");
        assert!(!sink.has_errors());
        let row = &tables[0].rows[0];
        assert_eq!(row.fields.iter().map(|f| f.key.value.as_str()).collect::<Vec<_>>(), ["z", "a"]);
        assert_eq!(row.get("a").unwrap().value, RawValue::Int(16));
        assert_eq!(row.span.range(), 14..33);
    }

    #[test]
    fn a_broken_row_does_not_hide_the_next() {
        let (tables, sink) = parse("objects = [\n  { at = = 1 },\n  { at = 2 },\n]\n");
        assert!(sink.has_errors());
        assert_eq!(tables[0].rows.len(), 1);
        assert_eq!(tables[0].rows[0].get("at").unwrap().value, RawValue::Int(2));
    }

    #[test]
    fn fractions_and_huge_numbers_are_refused() {
        let (_, sink) = parse("[drive]\nx = 0.1\ny = 0xFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFF\n");
        let codes: Vec<_> = sink.as_slice().iter().map(|d| d.code).collect();
        assert_eq!(codes, [code::FLOAT, code::NUMBER_RANGE]);
    }

    #[test]
    fn deep_nesting_is_an_error_and_no_overflow() {
        let (_, sink) = parse(&format!("a = {}1{}", "[".repeat(100_000), "]".repeat(100_000)));
        assert!(sink.has_errors());
    }
}
