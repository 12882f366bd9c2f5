//! Values in a format without types of its own: what a text means for a key that takes numbers, words or anything.
//!
//! Whole numbers have the notations of TOML, so that a file may be converted and a number still reads as printed.

use super::RawValue;

/// What a key takes, as far as reading its value depends on it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Takes {
    /// Text, whatever it looks like.
    Text,
    /// A whole number.
    Number,
    /// `true` or `false`.
    Truth,
    /// Any of them: what it looks like.
    Any,
}

/// What a key takes, and whether in a list.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Shape {
    /// The value, or each value of the list.
    pub takes: Takes,
    /// Whether the key takes a list.
    pub list: bool,
}

/// Says what a key of a table takes; of keys that it does not know, anything.
pub type Shapes = fn(table: &str, key: &str) -> Shape;

/// What a text is.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Literal {
    /// A value.
    Value(RawValue),
    /// A number with a fraction or an exponent.
    Fraction,
    /// A whole number of more than 127 bits.
    TooWide,
}

/// Reads the value of a key that `takes` something. What does not fit is text: the decoder of rows refuses it.
pub fn read(text: &str, takes: Takes) -> Literal {
    let truth = || matches!(text, "true" | "false").then(|| RawValue::Bool(text == "true"));
    let read = match takes {
        Takes::Text => None,
        Takes::Truth => truth().map(Literal::Value),
        Takes::Number => number(text),
        Takes::Any => truth().map(Literal::Value).or_else(|| number(text)),
    };
    read.unwrap_or_else(|| Literal::Value(RawValue::Text(text.to_owned())))
}

/// A number, if `text` is one.
fn number(text: &str) -> Option<Literal> {
    if is_fraction(text) {
        return Some(Literal::Fraction);
    }
    is_whole(text).then(|| whole(text).map_or(Literal::TooWide, |n| Literal::Value(RawValue::Int(n))))
}

/// The whole number that `text` is, in a notation of TOML: `16`, `-16`, `1_000`, `0x10`, `0o20`, `0b1_0000`.
pub fn whole(text: &str) -> Option<i128> {
    if !is_whole(text) {
        return None;
    }
    let digits = text.replace('_', "");
    match (digits.get(..2), digits.get(2..)) {
        (Some("0x"), Some(rest)) => i128::from_str_radix(rest, 16).ok(),
        (Some("0o"), Some(rest)) => i128::from_str_radix(rest, 8).ok(),
        (Some("0b"), Some(rest)) => i128::from_str_radix(rest, 2).ok(),
        _ => digits.parse().ok(),
    }
}

/// Whether `text` is a whole number of any width.
fn is_whole(text: &str) -> bool {
    let of = |rest: &str, digit: fn(&u8) -> bool| {
        rest.split('_').all(|part| !part.is_empty() && part.as_bytes().iter().all(digit))
    };
    match text.as_bytes() {
        [b'0', b'x', ..] => of(&text[2..], u8::is_ascii_hexdigit),
        [b'0', b'o', ..] => of(&text[2..], |b| (b'0'..=b'7').contains(b)),
        [b'0', b'b', ..] => of(&text[2..], |b| matches!(b, b'0' | b'1')),
        _ => {
            let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
            of(digits, u8::is_ascii_digit) && (digits == "0" || !digits.starts_with('0'))
        }
    }
}

/// Whether `text` is a number with a fraction or an exponent.
fn is_fraction(text: &str) -> bool {
    let digits = |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
    let text = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (mantissa, exponent) = text.split_once(['e', 'E']).map_or((text, None), |(m, e)| (m, Some(e)));
    let exponent_is = exponent.is_none_or(|e| digits(e.strip_prefix(['+', '-']).unwrap_or(e)));
    let parts = mantissa.split_once('.');
    let mantissa_is = parts.map_or_else(|| digits(mantissa), |(whole, rest)| digits(whole) && digits(rest));
    mantissa_is && exponent_is && (parts.is_some() || exponent.is_some())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_are_those_of_toml() {
        for (text, wanted) in [
            ("0", Some(0)),
            ("-0", Some(0)),
            ("+16", Some(16)),
            ("-2000000000", Some(-2_000_000_000)),
            ("1_000", Some(1_000)),
            ("0x0_fF", Some(255)),
            ("0o17", Some(15)),
            ("0b1_0", Some(2)),
            ("", None),
            ("-", None),
            ("007", None),
            ("-0x1", None),
            ("0X1", None),
            ("1__0", None),
            ("_1", None),
            ("1_", None),
            ("0x", None),
            ("0x+1", None),
            ("1 ", None),
            ("1.0", None),
        ] {
            assert_eq!(whole(text), wanted, "{text}");
            let toml = toml::from_str::<toml::Table>(&format!("a = {}", text.replace(' ', ""))).ok();
            let toml = toml.and_then(|t| t["a"].as_integer());
            assert_eq!(toml.map(i128::from), whole(text.trim()), "TOML reads {text} in another way");
        }
    }

    #[test]
    fn a_text_is_what_the_key_takes() {
        let kind = |text: &str, takes| match read(text, takes) {
            Literal::Value(value) => value.kind(),
            Literal::Fraction => "a fraction",
            Literal::TooWide => "too wide",
        };
        assert_eq!(kind("0x10", Takes::Text), "text");
        assert_eq!(kind("0x10", Takes::Any), "a whole number");
        assert_eq!(kind("true", Takes::Number), "text");
        assert_eq!(kind("true", Takes::Any), "true or false");
        assert_eq!(kind("1.0", Takes::Text), "text");
        assert_eq!(kind("1.0", Takes::Any), "a fraction");
        assert_eq!(kind("-1e3", Takes::Number), "a fraction");
        assert_eq!(kind("1e", Takes::Any), "text");
        assert_eq!(kind("2S0.75E", Takes::Any), "text");
        assert_eq!(kind(&"9".repeat(40), Takes::Number), "too wide");
        assert_eq!(kind("1", Takes::Truth), "text");
    }
}
