//! A profile file from one format into the other. Facts, the order of rows and keys, numbers as written, and comments stay.
//!
//! Files are taken as they are read, not as they are decoded: a key that no table has goes over as well. Blank lines and
//! other spacing are not kept, and tables that TOML must write as blocks go behind the others.

mod comment;
mod document;
mod toml;
mod xml;

use crate::diag::{Diagnostic, Severity, Sink, code};
use crate::raw::{self, literal::Shapes};
use crate::source::{FileId, Format, SourceMap, Span};

/// The text of `file` in the format `to`, or why there is none. `shapes` says what a key takes.
pub fn convert(
    file: FileId,
    sources: &SourceMap,
    shapes: Shapes,
    to: Format,
) -> Result<String, Vec<Diagnostic>> {
    let mut sink = Sink::default();
    let text = sources.text(file);
    let from = Format::of(sources.path(file)).unwrap_or(Format::Toml);
    let tables = raw::read(file, sources, shapes, &mut sink);
    if sink.count(Severity::Error) > 0 {
        return Err(sink.into_sorted(sources));
    }
    let mut comments = match from {
        Format::Toml => raw::toml::comments(text),
        Format::Xml => raw::xml::comments(text),
    };
    if from == Format::Xml {
        for comment in &mut comments {
            comment.text = comment::from_xml(&comment.text);
        }
    }
    let document = document::build(text, from, &tables, &comments);
    let mut refused = Refusals { file, sink: &mut sink };
    let out = match to {
        Format::Toml => toml::write(&document, &mut refused),
        Format::Xml => xml::write(&document, shapes, &mut refused),
    };
    if sink.has_errors() { Err(sink.into_sorted(sources)) } else { Ok(out) }
}

/// What a format cannot say.
struct Refusals<'a> {
    file: FileId,
    sink: &'a mut Sink,
}

impl Refusals<'_> {
    fn value(&mut self, span: Span, what: &str) {
        self.sink.push(
            Diagnostic::new(code::INEXPRESSIBLE, span, what)
                .why("a fact must not change when its file is converted")
                .help("correct the value or name; no profile may hold it anyway"),
        );
    }

    fn comment(&mut self, what: &str) {
        self.sink.push(
            Diagnostic::new(code::INEXPRESSIBLE, Span::whole(self.file), what)
                .why("the other format allows no such character in a comment")
                .help("remove the character"),
        );
    }
}
