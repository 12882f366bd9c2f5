//! JSON text in lines that a person can read and compare: a fact is one line, and so is every list or object without
//! another one in it.

use std::fmt::{Display, Write};

use super::value::{Integer, Known, Word, Words};
use crate::emit::escape::json_str;

/// What can be written as JSON.
pub(super) trait Json {
    /// Whether it is a list or an object.
    const NESTED: bool;

    /// Writes it.
    fn write(&self, out: &mut Writer);
}

/// The text of a document, with a line feed at its end.
pub(super) fn text(document: &impl Json) -> String {
    let mut out = Writer { text: String::new(), line: "\n".to_owned(), in_one_line: false, first: true };
    document.write(&mut out);
    out.text + "\n"
}

/// Text that is being written.
pub(super) struct Writer {
    text: String,
    /// What begins a line: the line feed and the indentation.
    line: String,
    /// Whether the open list or object stands in one line.
    in_one_line: bool,
    /// Whether nothing is written in it yet.
    first: bool,
}

impl Writer {
    /// An object with the `fields` that [`Self::field`] writes; one that stands in one line makes all in it do so.
    pub(super) fn object(&mut self, in_one_line: bool, fields: impl FnOnce(&mut Self)) {
        self.nest(["{", " }"], in_one_line, fields);
    }

    /// A field of the open object; `key` comes quoted and with its colon.
    pub(super) fn field(&mut self, key: &'static str, value: &(impl Json + ?Sized)) {
        let first = self.first;
        self.separate();
        if first && self.in_one_line {
            self.text.push(' ');
        }
        self.text.push_str(key);
        value.write(self);
    }

    fn list<T: Json>(&mut self, items: &[T]) {
        self.nest(["[", "]"], !T::NESTED || items.is_empty(), |out| {
            for item in items {
                out.separate();
                item.write(out);
            }
        });
    }

    fn nest(&mut self, [begin, end]: [&str; 2], in_one_line: bool, content: impl FnOnce(&mut Self)) {
        let outer = self.in_one_line;
        self.text.push_str(begin);
        self.in_one_line |= in_one_line;
        self.first = true;
        self.line.push_str("  ");
        content(self);
        self.line.truncate(self.line.len() - 2);
        if !self.in_one_line {
            self.text.push_str(&self.line);
        }
        self.text.push_str(if self.in_one_line && !self.first { end } else { end.trim_start() });
        self.in_one_line = outer;
        self.first = false;
    }

    /// Begins what comes next in the open list or object.
    fn separate(&mut self) {
        match (self.in_one_line, self.first) {
            (true, true) => {}
            (true, false) => self.text.push_str(", "),
            (false, first) => {
                self.text.push_str(if first { "" } else { "," });
                self.text.push_str(&self.line);
            }
        }
        self.first = false;
    }

    fn number(&mut self, n: impl Display) {
        // Writing to a String cannot fail.
        let _ = write!(self.text, "{n}");
    }

    fn quoted(&mut self, text: &str) {
        self.text.push('"');
        json_str(&mut self.text, text);
        self.text.push('"');
    }
}

impl<T: Json> Json for Vec<T> {
    const NESTED: bool = true;

    fn write(&self, out: &mut Writer) {
        out.list(self);
    }
}

impl<T: Json> Json for Known<'_, T> {
    const NESTED: bool = true;

    fn write(&self, out: &mut Writer) {
        out.object(true, |out| {
            out.field("\"value\": ", &self.value);
            out.field("\"class\": ", self.class);
            if let Some((key, text)) = self.detail {
                out.field(key, text);
            }
            if let Some(cite) = &self.cite {
                out.field("\"cite\": ", cite);
            }
            if let Some(erratum) = self.erratum {
                out.field("\"erratum\": ", erratum);
            }
        });
    }
}

impl<T: Words> Json for Word<T> {
    const NESTED: bool = false;

    fn write(&self, out: &mut Writer) {
        out.quoted(self.0.text());
    }
}

/// Other values that are neither a list nor an object.
macro_rules! plain {
    ($($ty:ty: |$value:ident, $out:ident| $write:expr;)+) => {$(
        impl Json for $ty {
            const NESTED: bool = false;

            fn write(&self, $out: &mut Writer) {
                let $value = self;
                $write;
            }
        }
    )+};
}

plain! {
    str: |text, out| out.quoted(text);
    &str: |text, out| out.quoted(text);
    String: |text, out| out.quoted(text);
    bool: |yes, out| out.text.push_str(if *yes { "true" } else { "false" });
    i8: |n, out| out.number(n);
    u8: |n, out| out.number(n);
    u16: |n, out| out.number(n);
    u32: |n, out| out.number(n);
    Integer: |n, out| match n.exact() {
        Some(n) => out.number(n),
        None => out.quoted(&n.0.to_string()),
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Writes a field under its key.
    type Field<'a> = (&'static str, &'a dyn Fn(&mut Writer, &'static str));

    struct Fields<'a>(bool, &'a [Field<'a>]);

    impl Json for Fields<'_> {
        const NESTED: bool = true;

        fn write(&self, out: &mut Writer) {
            out.object(self.0, |out| self.1.iter().for_each(|(key, field)| field(out, key)));
        }
    }

    fn known<T>(value: T) -> Known<'static, T> {
        Known { value, class: "stated", detail: None, cite: None, erratum: None }
    }

    #[test]
    fn facts_and_flat_things_are_lines() {
        let flat = Fields(true, &[("\"text\": ", &|out, key| out.field(key, "x,{"))]);
        let fact = known(flat);
        let list = vec![Fields(false, &[("\"d\": ", &|out, key| out.field(key, &vec![1_u8, 2]))])];
        let document = Fields(
            false,
            &[
                ("\"a\": ", &|out, key| out.field(key, &Vec::<Known<'_, u8>>::new())),
                ("\"b\": ", &|out, key| out.field(key, &fact)),
                ("\"c\": ", &|out, key| out.field(key, &list)),
                ("\"e\": ", &|out, key| out.field(key, &Fields(true, &[]))),
            ],
        );
        let wanted = r#"{
  "a": [],
  "b": { "value": { "text": "x,{" }, "class": "stated" },
  "c": [
    {
      "d": [1, 2]
    }
  ],
  "e": {}
}
"#;
        assert_eq!(text(&document), wanted);
    }

    #[test]
    fn readers_read_the_same_text() {
        let texts = ["a\"b\\", "\\", "\"", "\u{202E}\u{85}\n\t\r\u{8}\u{C}\0\u{7F}", "{[]},: µ\u{110BD}"];
        let out = text(&texts.map(str::to_owned).to_vec());
        assert_eq!(serde_json::from_str::<Vec<String>>(&out).unwrap(), texts);
        assert!(out.contains(r"\u202e\u0085\n\t\r\b\f\u0000\u007f"), "{out}");
        assert_eq!(out.lines().count(), 1);
    }
}
