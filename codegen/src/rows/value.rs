//! The kinds of values that keys take.

use super::kind::{Expected, FromRaw, Kind, suggest};
use crate::diag::code;
use crate::emit::escape::is_hidden;
use crate::limits;
use crate::model::{Unit, UnitError, Value};
use crate::name::Name;
use crate::raw::RawValue;

/// Text that a person reads: not empty, no hidden characters, of bounded length.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Text(pub String);

impl FromRaw for Text {
    const KIND: Kind = Kind::Text(None);

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        checked_text(raw, limits::TEXT_BYTES).map(|t| Self(t.to_owned()))
    }
}

pub(super) fn checked_text(raw: &RawValue, most: usize) -> Result<&str, Expected> {
    let RawValue::Text(text) = raw else { return Err(Expected::kind(raw, "text in quotes")) };
    if let Some(c) = text.chars().find(|c| is_hidden(*c)) {
        return Err(Expected {
            code: code::HIDDEN_CHARACTER,
            message: format!("the text holds {}", c.escape_unicode()),
            why: "control, bidirectional and zero-width characters can make a text read as what it is not"
                .into(),
            help: "remove the character; one row is one line of text".into(),
        });
    }
    if text.len() > most {
        return Err(Expected {
            code: code::TOO_LONG,
            message: format!("the text has {} bytes", text.len()),
            why: format!("a text here has at most {most} bytes, so that every output format can hold it"),
            help: "say it shorter".into(),
        });
    }
    if text.trim().is_empty() {
        return Err(bad(
            "the text is empty",
            "silence is stated by leaving the key out",
            "write a text, or remove the key",
        ));
    }
    Ok(text)
}

pub(super) fn bad(message: impl Into<String>, why: &str, help: impl Into<String>) -> Expected {
    Expected { code: code::BAD_VALUE, message: message.into(), why: why.into(), help: help.into() }
}

impl FromRaw for Name {
    const KIND: Kind = Kind::Text(None);

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let text = checked_text(raw, limits::NAME_BYTES)?;
        Self::new(text).ok_or_else(|| Expected {
            code: code::NAME_EMPTY,
            message: format!("`{text}` has no ASCII letter or digit"),
            why: "names of generated code are made of them".into(),
            help: "write an English name".into(),
        })
    }
}

/// A name as printed, in any script. What code is called after it needs words, or `rename`.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Printed(pub Name);

impl FromRaw for Printed {
    const KIND: Kind = Kind::Text(None);

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        checked_text(raw, limits::NAME_BYTES).map(|text| Self(Name::printed(text)))
    }
}

/// A short id: lower-case letters, digits and `-`, starting with a letter.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Ident(pub String);

impl FromRaw for Ident {
    const KIND: Kind = Kind::Text(Some("^[a-z][a-z0-9-]{0,63}$"));

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let text = checked_text(raw, 64)?;
        let ok = text.starts_with(|c: char| c.is_ascii_lowercase())
            && text.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-');
        ok.then(|| Self(text.to_owned())).ok_or_else(|| {
            let bad = bad(
                format!("`{text}` is no id"),
                "ids become folder and crate names",
                "use lower-case letters, digits and `-`, and start with a letter",
            );
            Expected { code: code::BAD_ID, ..bad }
        })
    }
}

/// A date, `2026-11-24`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Date(pub String);

impl FromRaw for Date {
    const KIND: Kind = Kind::Text(Some("^[0-9]{4}-[0-9]{2}-[0-9]{2}$"));

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let text = checked_text(raw, 10)?;
        let part = |range: std::ops::Range<usize>| text.get(range).and_then(|p| p.parse::<u8>().ok());
        let shape = text.len() == 10
            && text
                .bytes()
                .enumerate()
                .all(|(i, b)| if i == 4 || i == 7 { b == b'-' } else { b.is_ascii_digit() });
        let real = matches!(part(5..7), Some(1..=12)) && matches!(part(8..10), Some(1..=31));
        (shape && real).then(|| Self(text.to_owned())).ok_or_else(|| {
            bad(
                format!("`{text}` is no date"),
                "files carry this date, never the clock's",
                "write it as 2026-11-24",
            )
        })
    }
}

/// A crate version, `0.1.0`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Version(pub String);

impl FromRaw for Version {
    const KIND: Kind = Kind::Text(Some("^[0-9]+\\.[0-9]+\\.[0-9]+$"));

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let text = checked_text(raw, 32)?;
        let parts: Vec<&str> = text.split('.').collect();
        let number = |p: &&str| !p.is_empty() && p.len() <= 9 && p.bytes().all(|b| b.is_ascii_digit());
        let ok = parts.len() == 3 && parts.iter().all(|p| number(p) && (*p == "0" || !p.starts_with('0')));
        ok.then(|| Self(text.to_owned())).ok_or_else(|| {
            bad(format!("`{text}` is no version"), "cargo wants three numbers", "write it as 0.1.0")
        })
    }
}

/// A SHA-256 in lower-case hexadecimal.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Sha256(pub String);

impl FromRaw for Sha256 {
    const KIND: Kind = Kind::Text(Some("^[0-9a-f]{64}$"));

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let text = checked_text(raw, 64)?;
        let hex = |b: u8| b.is_ascii_digit() || (b'a'..=b'f').contains(&b);
        (text.len() == 64 && text.bytes().all(hex)).then(|| Self(text.to_owned())).ok_or_else(|| {
            bad(
                format!("`{text}` is no SHA-256"),
                "the hash ties citations to one text",
                "write its 64 digits in lower case",
            )
        })
    }
}

macro_rules! integers {
    ($($ty:ty)*) => {$(
        impl FromRaw for $ty {
            const KIND: Kind = Kind::Int(<$ty>::MIN as i128, <$ty>::MAX as i128);

            fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
                let RawValue::Int(n) = raw else { return Err(Expected::kind(raw, "a whole number")) };
                <$ty>::try_from(*n).map_err(|_| Expected {
                    code: code::NUMBER_RANGE,
                    message: format!("{n} does not fit"),
                    why: format!("the value goes from {} to {}", <$ty>::MIN, <$ty>::MAX),
                    help: "correct the number".into(),
                })
            }
        }
    )*};
}

integers!(u8 u16 u32 i8 i32);

macro_rules! bounded {
    ($($(#[$doc:meta])* $name:ident $range:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
        pub struct $name(pub u8);

        impl FromRaw for $name {
            const KIND: Kind = Kind::Int(*$range.start() as i128, *$range.end() as i128);

            fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
                let RawValue::Int(n) = raw else { return Err(Expected::kind(raw, "a whole number")) };
                u8::try_from(*n).ok().filter(|n| $range.contains(n)).map(Self).ok_or_else(|| Expected {
                    code: code::NUMBER_RANGE,
                    message: format!("{n} does not fit"),
                    why: format!("the value goes from {} to {}", $range.start(), $range.end()),
                    help: "correct the number".into(),
                })
            }
        }
    )*};
}

bounded! {
    /// A bit of an object, from 0.
    Bit 0..=limits::OBJECT_BITS - 1;
    /// How many bits belong together.
    Width 1..=limits::OBJECT_BITS;
}

impl FromRaw for bool {
    const KIND: Kind = Kind::Bool;

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let RawValue::Bool(value) = raw else { return Err(Expected::kind(raw, "true or false")) };
        Ok(*value)
    }
}

/// A raw count of an object: what 64 bits, signed or not, can hold.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Count(pub i128);

impl FromRaw for Count {
    const KIND: Kind = Kind::Int(i64::MIN as i128, u64::MAX as i128);

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let RawValue::Int(n) = raw else { return Err(Expected::kind(raw, "a whole number")) };
        if (i128::from(i64::MIN)..=i128::from(u64::MAX)).contains(n) {
            return Ok(Self(*n));
        }
        Err(Expected {
            code: code::NUMBER_RANGE,
            message: format!("{n} does not fit"),
            why: "no object of a drive is wider than 64 bits".into(),
            help: "correct the number".into(),
        })
    }
}

impl FromRaw for Value {
    const KIND: Kind = Kind::Scalar;

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        match raw {
            RawValue::Int(_) => Count::from_raw(raw).map(|c| Self::Int(c.0)),
            RawValue::Bool(b) => Ok(Self::Int(i128::from(*b))),
            RawValue::Text(_) => checked_text(raw, limits::TEXT_BYTES).map(|t| Self::Text(t.to_owned())),
            _ => Err(Expected::kind(raw, "a whole number, text, or true/false")),
        }
    }
}

/// Any value that a row can hold: what errata compare and set.
impl FromRaw for RawValue {
    const KIND: Kind = Kind::Scalar;

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        match raw {
            Self::Other(_) | Self::Reported => Err(Expected::kind(raw, "a value")),
            _ => Ok(raw.clone()),
        }
    }
}

impl<T: FromRaw> FromRaw for Vec<T> {
    const KIND: Kind = Kind::List(&T::KIND);

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let RawValue::List(items) = raw else { return Err(Expected::kind(raw, "a list in square brackets")) };
        if items.len() > limits::LIST_VALUES {
            return Err(Expected {
                code: code::TOO_LONG,
                message: format!("the list has {} values", items.len()),
                why: format!("a list holds at most {}", limits::LIST_VALUES),
                help: "shorten it".into(),
            });
        }
        items.iter().map(|item| T::from_raw(&item.value)).collect()
    }
}

/// Words of which there is one number.
impl<const N: usize> FromRaw for [u16; N] {
    const KIND: Kind = Kind::List(&u16::KIND);

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let list = Vec::<u16>::from_raw(raw)?;
        let found = list.len();
        Self::try_from(list).map_err(|_| {
            bad(
                format!("the list has {found} numbers, not {N}"),
                "each of them has its own place in the device",
                format!("write all {N}; one that is not printed makes the whole list unknown"),
            )
        })
    }
}

/// Ports of a slave controller, a letter each.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Physics(pub String);

impl FromRaw for Physics {
    const KIND: Kind = Kind::Text(Some("^[YKH ]{1,4}$"));

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let text = checked_text(raw, 64)?;
        let ok = text.len() <= 4 && text.bytes().all(|b| b"YKH ".contains(&b));
        ok.then(|| Self(text.to_owned())).ok_or_else(|| {
            bad(
                format!("`{text}` are no ports"),
                "a slave controller has up to four",
                "write a letter a port, from port 0: `Y` for 100BASE-TX, `K` for E-bus, `H` for fast hot connect, a blank for none",
            )
        })
    }
}

impl FromRaw for Unit {
    const KIND: Kind = Kind::Text(None);

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let text = checked_text(raw, 64)?;
        Self::parse(text).map_err(|error| Expected {
            code: code::BAD_UNIT,
            message: error.to_string(),
            why: "the unit of one count becomes an exact factor of a typed quantity".into(),
            help: match &error {
                UnitError::Symbol(symbol) => suggest(symbol, &Self::symbols().collect::<Vec<_>>()),
                UnitError::Factor(_) => "write `factor symbol`, such as `0.1 rpm`".into(),
            },
        })
    }
}

/// A field and a reason: `type: width from the range`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Reason {
    /// The key.
    pub field: String,
    /// The rule or reason.
    pub text: String,
}

impl FromRaw for Reason {
    const KIND: Kind = Kind::Text(Some("^[a-z0-9_]+: .+$"));

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let text = checked_text(raw, limits::TEXT_BYTES)?;
        match text.split_once(": ") {
            Some((field, reason)) if !reason.trim().is_empty() => {
                Ok(Self { field: field.trim().to_owned(), text: reason.trim().to_owned() })
            }
            _ => Err(bad(
                format!("`{text}` names no field"),
                "each reason belongs to one key of the row",
                "write `type: the reason`",
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_and_versions() {
        let date = |t: &str| Date::from_raw(&RawValue::Text(t.into())).is_ok();
        assert!(date("2026-11-24") && !date("2026-13-01") && !date("24.11.2026") && !date("2026-1é-1"));
        let version = |t: &str| Version::from_raw(&RawValue::Text(t.into())).is_ok();
        assert!(version("0.1.0") && !version("1.0") && !version("01.0.0") && !version("1.0.0-rc"));
    }
}
