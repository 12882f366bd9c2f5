//! Types whose length varies, seen as borrowed bytes, and the two times, seen as six bytes.

use core::fmt;

use super::{decode_fixed, put, Fixed, Wire, WireError};
use crate::data_type::DataType;

/// The bytes of a `VISIBLE_STRING`, borrowed. Drives pad with NUL and use characters outside ASCII.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Text<'a>(pub &'a [u8]);

/// The bytes are not UTF-8, so not ASCII either.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct NotText {
    /// How many bytes from the start are text.
    pub valid_up_to: usize,
}

impl fmt::Display for NotText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "byte {} of the string is no text", self.valid_up_to)
    }
}

impl core::error::Error for NotText {}

impl<'a> Text<'a> {
    /// The bytes of `text`, without a terminator.
    pub const fn new(text: &'a str) -> Self {
        Self(text.as_bytes())
    }

    /// The bytes up to the first NUL, which some drives pad with.
    pub fn bytes(self) -> &'a [u8] {
        self.0.split(|b| *b == 0).next().unwrap_or(self.0)
    }

    /// [`bytes`](Self::bytes) as text.
    ///
    /// # Errors
    /// [`NotText`] with the place of the first byte that is not UTF-8.
    pub fn as_str(self) -> Result<&'a str, NotText> {
        core::str::from_utf8(self.bytes()).map_err(|e| NotText { valid_up_to: e.valid_up_to() })
    }
}

impl fmt::Debug for Text<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{}\"", self.0.escape_ascii())
    }
}

type Bytes<'a> = &'a [u8];

macro_rules! variable {
    ($($(#[$doc:meta])* $name:ident = $code:ident, $view:ident, |$in:ident| $to:expr, |$out:ident| $from:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub struct $name;

        impl Wire for $name {
            type View<'a> = $view<'a>;
            const DATA_TYPE: DataType = DataType::$code;

            fn encode($in: $view<'_>, out: &mut [u8]) -> Result<usize, WireError> {
                put(out, $to)
            }

            fn decode($out: &[u8]) -> Result<$view<'_>, WireError> {
                Ok($from)
            }
        }
    )*};
}

variable! {
    /// `VISIBLE_STRING`, seen as [`Text`].
    VisibleString = VISIBLE_STRING, Text, |view| view.0, |bytes| Text(bytes);
    /// `OCTET_STRING`, seen as bytes.
    OctetString = OCTET_STRING, Bytes, |view| view, |bytes| bytes;
    /// `UNICODE_STRING`, seen as bytes: 16-bit characters, little endian.
    UnicodeString = UNICODE_STRING, Bytes, |view| view, |bytes| bytes;
    /// `DOMAIN`, seen as bytes.
    Domain = DOMAIN, Bytes, |view| view, |bytes| bytes;
}

macro_rules! times {
    ($($(#[$doc:meta])* $name:ident = $code:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $name {
            ms: u32,
            days: u16,
        }

        impl $name {
            /// Milliseconds and days; `None` when the milliseconds need more than 28 bits.
            pub const fn new(ms: u32, days: u16) -> Option<Self> {
                if ms > MS {
                    None
                } else {
                    Some(Self { ms, days })
                }
            }

            /// Milliseconds, 0 to 2^28 - 1: after midnight, or of the last day of the difference.
            pub const fn ms(self) -> u32 {
                self.ms
            }

            /// Days: since 1984-01-01, or of the difference.
            pub const fn days(self) -> u16 {
                self.days
            }
        }

        impl Wire for $name {
            type View<'a> = Self;
            const DATA_TYPE: DataType = DataType::$code;

            fn encode(view: Self, out: &mut [u8]) -> Result<usize, WireError> {
                put(out, &view.to_bytes())
            }

            fn decode(bytes: &[u8]) -> Result<Self, WireError> {
                decode_fixed(bytes)
            }
        }

        impl Fixed for $name {
            type Bytes = [u8; 6];

            fn to_bytes(self) -> [u8; 6] {
                let [a, b, c, d] = self.ms.to_le_bytes();
                let [e, f] = self.days.to_le_bytes();
                [a, b, c, d, e, f]
            }

            fn from_bytes([a, b, c, d, e, f]: [u8; 6]) -> Self {
                Self { ms: u32::from_le_bytes([a, b, c, d]) & MS, days: u16::from_le_bytes([e, f]) }
            }
        }
    )*};
}

/// The milliseconds take 28 bits; the four above them are reserved.
const MS: u32 = (1 << 28) - 1;

times! {
    /// `TIME_OF_DAY`: a point in time.
    TimeOfDay = TIME_OF_DAY;
    /// `TIME_DIFFERENCE`: a span of time.
    TimeDifference = TIME_DIFFERENCE;
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::format;

    #[test]
    fn strings_are_borrowed_and_lose_their_padding() {
        let wire = *b"ELD2\0\0";
        let text = VisibleString::decode(&wire).unwrap();
        assert_eq!((text.as_str(), text.0.len()), (Ok("ELD2"), 6));
        let mut out = [0; 6];
        assert_eq!(VisibleString::encode(Text::new("save"), &mut out), Ok(4));
        assert_eq!(&out, b"save\0\0");
        assert_eq!(VisibleString::decode(&[]).unwrap().as_str(), Ok(""));
    }

    #[test]
    fn other_bytes_are_no_text() {
        let text = Text(b"K\xFCbler");
        assert_eq!(text.as_str(), Err(NotText { valid_up_to: 1 }));
        assert_eq!(format!("{text:?}"), "\"K\\xfcbler\"");
    }

    #[test]
    fn strings_need_space() {
        let result = OctetString::encode(&[1, 2, 3], &mut [0; 2]);
        assert_eq!(result, Err(WireError::Space { needed: 3, space: 2 }));
        assert_eq!(Domain::decode(&[1, 2]), Ok(&[1, 2][..]));
    }

    #[test]
    fn times_take_six_bytes() {
        let time = TimeOfDay::new(86_399_999, 15_000).unwrap();
        assert_eq!(TimeOfDay::decode(&time.to_bytes()), Ok(time));
        let most = TimeOfDay::from_bytes([0xFF; 6]);
        assert_eq!((most.ms(), most.days()), (MS, u16::MAX));
        assert_eq!(TimeDifference::new(MS + 1, 0), None);
    }
}
