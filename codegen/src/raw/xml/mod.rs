//! XML to the raw tree. With its parts, the only module that knows the `quick-xml` crate.
//!
//! ```xml
//! <profile>
//!   <drive format="1" id="x1"><bases><item>cia301</item></bases></drive>
//!   <objects>
//!     <row at="2000:00" name="Speed" max="0x10"/>
//!   </objects>
//! </profile>
//! ```
//!
//! A table is an element, a row of it is `<row>`; a table with attributes is its only row. A key is an attribute or an
//! element in the row, a list holds `<item>`. What a value is follows from what the key takes, or from `kind`.
//!
//! Reading never fails, as in [`super::toml`]. Elements go five deep, so there is no recursion; whatever stands below one
//! that does not belong there is counted and not looked at. No entity is expanded and no other file is opened.

mod tag;
mod text;
mod tree;
mod value;

use std::ops::Range;

use quick_xml::events::Event;
use quick_xml::reader::Reader;

use super::literal::Shapes;
use super::{Comment, RawTable};
use crate::diag::{Code, Diagnostic, Sink, code};
use crate::emit::escape::is_xml;
use crate::source::{FileId, SourceMap, Span};
use tree::Tree;

pub(crate) use value::Kind;

/// Reads the tables of `file`. Of each key, `shapes` says what it takes.
pub fn read(file: FileId, sources: &SourceMap, shapes: Shapes, sink: &mut Sink) -> Vec<RawTable> {
    let text = sources.text(file);
    let mut report = Report { file, sink };
    characters(text, &mut report);
    let mut tree = Tree::new(text, shapes, &mut report);
    let mut declared = false;
    events(text, |event, range| match event {
        Ok(Event::Start(tag)) => tree.open(&tag, range),
        Ok(Event::Empty(tag)) => {
            let end = range.end;
            tree.open(&tag, range);
            tree.close(end..end);
        }
        Ok(Event::End(tag)) => tree.end(tag.name().into_inner(), range),
        Ok(Event::Text(_) | Event::GeneralRef(_)) => tree.text(range),
        Ok(Event::CData(_)) => {
            let help = "write the text itself, with `&lt;` and `&amp;`";
            tree.refuse(code::MISPLACED, range, "a CDATA section", help);
        }
        Ok(Event::Comment(_)) => tree.comment(range),
        Ok(Event::Decl(declaration)) => {
            // Anywhere else it is no declaration.
            if std::mem::replace(&mut declared, true) || !text[..range.start].trim_matches(BOM).is_empty() {
                tree.wrong(range, "an XML declaration that is not at the start of the file");
            } else {
                tree.declaration(&declaration, range);
            }
        }
        Ok(Event::PI(_)) => tree.refuse(code::INSTRUCTION, range, "a processing instruction", "remove it"),
        Ok(Event::DocType(_)) => {
            let help = "remove `<!DOCTYPE ...>`; `drivewright schema --format xsd` prints the schema";
            tree.refuse(code::DOCTYPE, range, "a document type is declared", help);
        }
        Ok(Event::Eof) => {}
        Err(error) => tree.wrong(range, &error),
    });
    tree.finish()
}

/// The comments of a text that [`read`] finds no fault with, in order.
pub(crate) fn comments(text: &str) -> Vec<Comment> {
    let (mut depth, mut found) = (0_usize, Vec::new());
    events(text, |event, range| match event {
        Ok(Event::Start(_)) => depth += 1,
        Ok(Event::End(_)) => depth = depth.saturating_sub(1),
        Ok(Event::Comment(inner)) => {
            found.push(Comment { text: inner.to_string(), span: range, depth });
        }
        _ => {}
    });
    found
}

const BOM: char = '\u{FEFF}';

/// Hands each event to `take`, with its place. Ends where the text ends or can be followed no further.
fn events<'a>(text: &'a str, mut take: impl FnMut(Result<Event<'a>, String>, Range<usize>)) {
    // A second mark is reported, and would be skipped without being counted.
    let base = text.len() - text.trim_start_matches(BOM).len();
    let mut reader = Reader::from_str(text.get(base..).unwrap_or_default());
    let config = reader.config_mut();
    (config.check_end_names, config.allow_unmatched_ends, config.allow_dangling_amp) = (false, true, true);
    let at = |position: u64| base + usize::try_from(position).unwrap_or(usize::MAX).min(text.len() - base);
    loop {
        let start = at(reader.buffer_position());
        match reader.read_event() {
            Ok(Event::Eof) => return,
            Ok(event) => take(Ok(event), start..at(reader.buffer_position())),
            Err(error) => {
                let end = at(reader.buffer_position());
                let marked = at(reader.error_position()).min(end);
                let first = text.get(marked..end).and_then(|rest| rest.lines().next()).unwrap_or_default();
                take(Err(error.to_string()), marked..marked + first.len());
                if end == start || end == text.len() {
                    return;
                }
            }
        }
    }
}

/// A file with one forbidden character may have a million: the first one is enough.
fn characters(text: &str, report: &mut Report<'_>) {
    let from = text.len() - text.strip_prefix(BOM).unwrap_or(text).len();
    let strange = |(at, c): &(usize, char)| !is_xml(*c) || (*at == from && *c == BOM);
    if let Some((at, c)) = text.char_indices().skip_while(|(at, _)| *at < from).find(strange) {
        let message = format!("the character {} stands in the file", c.escape_unicode());
        report.not_xml(at..at + c.len_utf8(), &message);
    }
}

/// Where findings go.
struct Report<'a> {
    file: FileId,
    sink: &'a mut Sink,
}

impl Report<'_> {
    fn span(&self, range: Range<usize>) -> Span {
        Span::new(self.file, range)
    }

    fn not_xml(&mut self, range: Range<usize>, message: &str) {
        let span = self.span(range);
        self.sink.report(code::NOT_XML, || {
            Diagnostic::new(code::NOT_XML, span, message)
                .why("the file must be well-formed XML 1.0 before any of it can be trusted")
                .help("correct the text at the marked place; the row that holds it was left out of this run")
        });
    }

    fn add(&mut self, finding: Diagnostic) {
        self.sink.push(finding);
    }

    /// A finding whose reason goes with its code.
    fn push(&mut self, code: Code, range: Range<usize>, message: &str, help: &str) {
        let why = match code {
            code::DOCTYPE => {
                "a document type can hold entities that grow without bound, and name other files"
            }
            code::ENTITY => {
                "other entities would have to be looked up somewhere, and a profile is what its files hold"
            }
            code::NAMESPACE => "a profile is one flat file: nothing is included, and no schema is fetched",
            code::INSTRUCTION => "it speaks to one program, and a profile means the same to all",
            code::TOO_DEEP => "a table holds rows, a row holds values, and a value is at most a list",
            code::ENCODING => "only in UTF-8 does each byte mean the same to every reader",
            _ => "what stands there would be lost, or read as something else",
        };
        let span = self.span(range);
        self.sink.report(code, || Diagnostic::new(code, span, message).why(why).help(help));
    }
}
