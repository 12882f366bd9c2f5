//! Breaks JSON text into lines that a person can read and compare: a fact is one line, and so is every list or object
//! without another one in it.

use crate::emit::escape::{json_char, json_plain};

/// The compact JSON `text` in lines, with a line feed at its end. Hidden characters become escapes.
pub(super) fn lines(text: &str) -> String {
    let mut printer = Printer { out: String::with_capacity(text.len() * 2), open: Vec::new() };
    let mut in_string = false;
    let mut escaped = false;
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let mut length = c.len_utf8();
        if !in_string {
            in_string = c == '"';
            printer.mark(c, rest);
        } else if let same @ 1.. = if escaped { 0 } else { json_plain(rest.as_bytes()) } {
            printer.out.push_str(&rest[..same]);
            length = same;
        } else {
            json_char(&mut printer.out, c);
            in_string = escaped || c != '"';
            escaped = c == '\\' && !escaped;
        }
        rest = &rest[length..];
    }
    printer.out.push('\n');
    printer.out
}

struct Printer {
    out: String,
    /// For each open list or object, whether it stands in one line.
    open: Vec<bool>,
}

impl Printer {
    /// A character outside strings; `rest` begins with it.
    fn mark(&mut self, c: char, rest: &str) {
        match c {
            '{' | '[' => self.begin(c, rest),
            '}' | ']' => self.end(c),
            ',' if self.in_one_line() => self.out.push_str(", "),
            ',' => {
                self.out.push(',');
                self.new_line();
            }
            ':' => self.out.push_str(": "),
            c => self.out.push(c),
        }
    }

    fn begin(&mut self, c: char, rest: &str) {
        self.out.push(c);
        self.open.push(self.in_one_line() || one_line(rest));
        if !self.in_one_line() {
            self.new_line();
        } else if rest.starts_with("{\"") {
            self.out.push(' ');
        }
    }

    fn end(&mut self, c: char) {
        let one_line = self.open.pop().unwrap_or(true);
        if !one_line {
            self.new_line();
        } else if c == '}' && !self.out.ends_with('{') {
            self.out.push(' ');
        }
        self.out.push(c);
    }

    fn in_one_line(&self) -> bool {
        self.open.last().is_some_and(|one_line| *one_line)
    }

    fn new_line(&mut self) {
        self.out.push('\n');
        self.out.extend(std::iter::repeat_n("  ", self.open.len()));
    }
}

/// Whether the list or object at the start of `text` is a fact or has no other list or object in it.
fn one_line(text: &str) -> bool {
    text.starts_with("{\"value\":") || is_flat(text)
}

fn is_flat(text: &str) -> bool {
    let (mut in_string, mut escaped) = (false, false);
    let mut rest = text.as_bytes().get(1..).unwrap_or_default();
    while let [b, after @ ..] = rest {
        if in_string
            && !escaped
            && let same @ 1.. = json_plain(rest)
        {
            rest = &rest[same..];
            continue;
        }
        match b {
            b'{' | b'[' if !in_string => return false,
            b'}' | b']' if !in_string => return true,
            b'"' if !escaped => in_string = !in_string,
            _ => {}
        }
        escaped = *b == b'\\' && !escaped;
        rest = after;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn facts_and_flat_things_are_lines() {
        let text = r#"{"a":[],"b":{"value":{"text":"x,{"},"class":"stated"},"c":[{"d":[1,2]}],"e":{}}"#;
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
        assert_eq!(lines(text), wanted);
    }

    #[test]
    fn the_text_stays_the_same_json() {
        let value =
            serde_json::json!({ "a\"b\\": ["\\", "\"", "\u{202E}\u{85}\n", {"x": ["{", "]"]}], "n": -5 });
        let out = lines(&value.to_string());
        assert_eq!(serde_json::from_str::<serde_json::Value>(&out).unwrap(), value);
        assert!(out.contains("\\u202e\\u0085"), "{out}");
    }
}
