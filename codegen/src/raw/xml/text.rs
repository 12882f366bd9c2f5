//! Characters and references of XML. Nothing is looked up: there are the five names of XML itself and numbers.

use std::ops::Range;

use crate::diag::{Code, code};
use crate::emit::escape::is_xml;

/// What is wrong in a text, and where: bytes of that text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Wrong {
    pub(super) code: Code,
    pub(super) range: Range<usize>,
    pub(super) message: String,
}

fn wrong(code: Code, range: Range<usize>, message: impl Into<String>) -> Wrong {
    Wrong { code, range, message: message.into() }
}

/// Where a text stands: what may be in it, and what becomes of line breaks.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Where {
    /// Between the quotes of an attribute: a line break or tab is a blank.
    Attribute,
    /// Between tags.
    Element,
}

/// The text that `raw` says, references replaced. Takes the time of its length: no reference says more than one character.
pub(super) fn unescape(raw: &str, place: Where) -> Result<String, Wrong> {
    let forbidden = match place {
        Where::Attribute => "<",
        Where::Element => "]]>",
    };
    if let Some(at) = raw.find(forbidden) {
        let message = format!("`{forbidden}` stands in a text");
        return Err(wrong(code::NOT_XML, at..at + forbidden.len(), message));
    }
    let mut out = String::with_capacity(raw.len());
    let (mut rest, mut from) = (raw, 0);
    while let Some(at) = rest.find('&') {
        breaks(&rest[..at], place, &mut out);
        let (name, length) = name(&rest[at..]);
        let range = from + at..from + at + length;
        out.push(reference(name.ok_or_else(|| unclosed(range.clone()))?, range)?);
        from += at + length;
        rest = &rest[at + length..];
    }
    breaks(rest, place, &mut out);
    Ok(out)
}

fn unclosed(range: Range<usize>) -> Wrong {
    wrong(code::NOT_XML, range, "a `&` that begins no reference")
}

/// Line breaks as XML reads them.
fn breaks(part: &str, place: Where, out: &mut String) {
    if !part.contains(['\r', '\n', '\t']) {
        return out.push_str(part);
    }
    let part = part.replace("\r\n", "\n").replace('\r', "\n");
    match place {
        Where::Element => out.push_str(&part),
        Where::Attribute => out.push_str(&part.replace(['\n', '\t'], " ")),
    }
}

/// The name between `&` and `;`, and how many bytes belong to the reference.
fn name(text: &str) -> (Option<&str>, usize) {
    let rest = &text[1..];
    let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && !"#_:.-".contains(c)).unwrap_or(rest.len());
    if end > 0 && rest[end..].starts_with(';') { (Some(&rest[..end]), end + 2) } else { (None, 1) }
}

/// The character that a reference names.
fn reference(name: &str, range: Range<usize>) -> Result<char, Wrong> {
    match name {
        "amp" => Ok('&'),
        "lt" => Ok('<'),
        "gt" => Ok('>'),
        "quot" => Ok('"'),
        "apos" => Ok('\''),
        _ => match name.strip_prefix('#') {
            Some(digits) => number(digits).ok_or_else(|| {
                wrong(code::ENTITY, range, format!("`&{name};` is no character that XML may hold"))
            }),
            None => {
                Err(wrong(code::ENTITY, range, format!("the entity `&{name};` is not one of XML itself")))
            }
        },
    }
}

fn number(digits: &str) -> Option<char> {
    let (digits, radix) = digits.strip_prefix('x').map_or((digits, 10), |hex| (hex, 16));
    let plain = !digits.is_empty() && digits.chars().all(|c| c.is_digit(radix));
    let number = u32::from_str_radix(digits, radix).ok().filter(|_| plain)?;
    char::from_u32(number).filter(|c| is_xml(*c))
}

/// Whether XML counts a character as a blank.
pub(super) fn is_blank(c: char) -> bool {
    matches!(c, ' ' | '\t' | '\n' | '\r')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(raw: &str) -> Result<String, (&'static str, Range<usize>)> {
        unescape(raw, Where::Element).map_err(|w| (w.code.id(), w.range))
    }

    #[test]
    fn references() {
        assert_eq!(
            said("a &lt;b&gt; &amp;&quot;&apos; &#65;&#x42;&#x1F600;"),
            Ok("a <b> &\"' AB\u{1F600}".into())
        );
        assert_eq!(said("&amp;lt;"), Ok("&lt;".into()), "what a reference says is not read again");
        assert_eq!(said("µ &nbsp;"), Err(("E0123", 3..9)));
        for no_char in
            ["&#0;", "&#x1;", "&#xD800;", "&#x110000;", "&#xFFFF;", "&#99999999999;", "&#;", "&#x;"]
        {
            assert_eq!(said(no_char), Err(("E0123", 0..no_char.len())), "{no_char}");
        }
        for no_reference in ["&", "&;", "&#+65;", "& a;", "&lt", "&&amp;"] {
            assert_eq!(said(no_reference), Err(("E0121", 0..1)), "{no_reference}");
        }
        assert_eq!(said("a]]>"), Err(("E0121", 1..4)));
    }

    #[test]
    fn line_breaks() {
        assert_eq!(said("a\r\nb\rc\td"), Ok("a\nb\nc\td".into()));
        assert_eq!(unescape("a\r\nb\tc&#10;d", Where::Attribute).ok(), Some("a b c\nd".into()));
        assert!(unescape("a<b", Where::Attribute).is_err());
    }
}
