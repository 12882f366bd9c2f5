//! Attributes of one tag, each with its place.

use std::ops::Range;

use quick_xml::events::BytesStart;
use quick_xml::events::attributes::AttrError;

/// An attribute, or what is wrong with one: places in the text.
pub(super) enum Part {
    Attribute { name: Range<usize>, value: Range<usize> },
    Wrong(Range<usize>, &'static str),
}

/// The attributes of a tag of `text`. What cannot be read does not hide the rest.
pub(super) fn parts(tag: &BytesStart<'_>, text: &str) -> impl Iterator<Item = Part> {
    let start = place(text, tag).start;
    let mut end = place(text, tag.name().into_inner()).end;
    let mut attributes = tag.attributes();
    attributes.with_checks(false);
    attributes.map(move |found| match found {
        Err(error) => wrong(&error, start, text),
        Ok(attribute) => {
            let (name, value) = (place(text, attribute.key.into_inner()), place(text, &attribute.value));
            let apart = end < name.start;
            // The quote behind the value belongs to it.
            end = value.end + 1;
            if apart {
                Part::Attribute { name, value }
            } else {
                Part::Wrong(name, "a blank is missing before the attribute")
            }
        }
    })
}

/// Where `part`, which is a slice of `text`, stands in it.
pub(super) fn place(text: &str, part: &str) -> Range<usize> {
    let start = (part.as_ptr() as usize).saturating_sub(text.as_ptr() as usize).min(text.len());
    start..(start + part.len()).min(text.len())
}

fn wrong(error: &AttrError, start: usize, text: &str) -> Part {
    let (at, why) = match error {
        AttrError::ExpectedEq(at) => (*at, "an attribute has no `=`"),
        AttrError::ExpectedValue(at) => (*at, "an attribute has no value"),
        AttrError::UnquotedValue(at) => (*at, "the value of an attribute has no quotes"),
        AttrError::ExpectedQuote(at, _) => (*at, "the value of an attribute does not end"),
        AttrError::Duplicated(at, _) => (*at, "an attribute is there twice"),
    };
    let at = (start + at).min(text.len());
    let length = text.get(at..).and_then(|rest| rest.chars().next()).map_or(0, char::len_utf8);
    Part::Wrong(at..at + length, why)
}
