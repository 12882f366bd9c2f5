//! XML as events. Names of elements and attributes are our own; every text goes through one escaping function.

use quick_xml::Writer;
use quick_xml::events::attributes::{Attr, Attribute};
use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, BytesText, Event};

use crate::emit::escape;

/// Attributes of an element, in order.
pub(super) type Attributes<'a> = &'a [(&'a str, &'a str)];

/// An XML document in the making.
pub(super) struct Xml(Writer<Vec<u8>>);

impl Xml {
    /// A document with its declaration.
    pub(super) fn new() -> Self {
        let mut xml = Self(Writer::new_with_indent(Vec::new(), b' ', 1));
        xml.event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)));
        xml
    }

    /// A comment of several lines.
    pub(super) fn comment(&mut self, lines: &[String]) {
        let lines: Vec<String> = lines.iter().map(|line| escape::xml_comment(line)).collect();
        let text = format!("\n{}\n", lines.join("\n"));
        self.event(Event::Comment(BytesText::from_escaped(text)));
    }

    /// An element with what `inside` writes in it.
    pub(super) fn element(&mut self, name: &str, attributes: Attributes<'_>, inside: impl FnOnce(&mut Self)) {
        self.event(Event::Start(start(name, attributes)));
        inside(self);
        self.event(Event::End(BytesEnd::new(name)));
    }

    /// An element that holds only other elements.
    pub(super) fn group(&mut self, name: &str, inside: impl FnOnce(&mut Self)) {
        self.element(name, &[], inside);
    }

    /// An element that holds a text.
    pub(super) fn text(&mut self, name: &str, text: impl ToString) {
        self.text_with(name, &[], text);
    }

    /// An element with attributes that holds a text.
    #[allow(clippy::needless_pass_by_value, reason = "callers hand over numbers and texts alike")]
    pub(super) fn text_with(&mut self, name: &str, attributes: Attributes<'_>, text: impl ToString) {
        let text = escape::xml(&escape::one_line(&text.to_string()));
        self.element(name, attributes, |xml| xml.event(Event::Text(BytesText::from_escaped(text))));
    }

    /// An element that holds a text in English.
    pub(super) fn english(&mut self, name: &str, text: impl ToString) {
        self.text_with(name, &[("LcId", "1033")], text);
    }

    /// An element that holds nothing.
    pub(super) fn empty(&mut self, name: &str, attributes: Attributes<'_>) {
        self.event(Event::Empty(start(name, attributes)));
    }

    /// The bytes of the document.
    pub(super) fn finish(self) -> Vec<u8> {
        let mut bytes = self.0.into_inner();
        bytes.push(b'\n');
        bytes
    }

    fn event(&mut self, event: Event<'_>) {
        // Writing to memory cannot fail.
        let _ = self.0.write_event(event);
    }
}

fn start<'a>(name: &'a str, attributes: Attributes<'_>) -> BytesStart<'a> {
    let mut start = BytesStart::new(name);
    for (key, value) in attributes {
        start.push_attribute(Attribute::from(Attr::DoubleQ(
            *key,
            escape::xml(&escape::one_line(value)).as_str(),
        )));
    }
    start
}

/// A number as an ESI writes it: `#x607A`.
pub(super) fn hex(number: impl Into<u32>, digits: usize) -> String {
    format!("#x{:0digits$X}", number.into())
}

/// A truth value as an ESI writes it.
pub(super) fn flag(value: bool) -> &'static str {
    if value { "1" } else { "0" }
}
