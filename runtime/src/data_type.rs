//! The data types of CiA 301, and a codec for callers that know the type only at run time.

use core::fmt;

use crate::wire::{expect_len, put, WireError};

/// The code of a basic data type in CiA 301. Open: a drive may state a code that is not listed here.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(transparent)]
pub struct DataType(pub u8);

/// One row a type: constant, code, width in bits (0: variable), first letter of the kind.
macro_rules! data_types {
    ($($name:ident = $code:literal, $bits:literal, $kind:ident;)*) => {
        impl DataType {
            $(
                #[doc = concat!("`", stringify!($name), "`, code ", stringify!($code), ".")]
                pub const $name: Self = Self($code);
            )*

            /// The name in CiA 301; `None` for a code that is not listed here.
            pub const fn name(self) -> Option<&'static str> {
                match self.0 {
                    $($code => Some(stringify!($name)),)*
                    _ => None,
                }
            }

            /// Width in a PDO in bits: 1 for BOOLEAN, 0 where the length varies or the code is unknown.
            pub const fn bits(self) -> u16 {
                match self.0 {
                    $($code => $bits,)*
                    _ => 0,
                }
            }

            const fn kind(self) -> Kind {
                match self.0 {
                    $($code => Kind::$kind,)*
                    _ => Kind::Other,
                }
            }
        }

        #[cfg(test)]
        const ALL: &[DataType] = &[$(DataType($code)),*];
    };
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Signed,
    Unsigned,
    Other,
}

data_types! {
    BOOLEAN = 0x01, 1, Unsigned;
    INTEGER8 = 0x02, 8, Signed;
    INTEGER16 = 0x03, 16, Signed;
    INTEGER32 = 0x04, 32, Signed;
    UNSIGNED8 = 0x05, 8, Unsigned;
    UNSIGNED16 = 0x06, 16, Unsigned;
    UNSIGNED32 = 0x07, 32, Unsigned;
    REAL32 = 0x08, 32, Other;
    VISIBLE_STRING = 0x09, 0, Other;
    OCTET_STRING = 0x0A, 0, Other;
    UNICODE_STRING = 0x0B, 0, Other;
    TIME_OF_DAY = 0x0C, 48, Other;
    TIME_DIFFERENCE = 0x0D, 48, Other;
    DOMAIN = 0x0F, 0, Other;
    INTEGER24 = 0x10, 24, Signed;
    REAL64 = 0x11, 64, Other;
    INTEGER40 = 0x12, 40, Signed;
    INTEGER48 = 0x13, 48, Signed;
    INTEGER56 = 0x14, 56, Signed;
    INTEGER64 = 0x15, 64, Signed;
    UNSIGNED24 = 0x16, 24, Unsigned;
    UNSIGNED40 = 0x18, 40, Unsigned;
    UNSIGNED48 = 0x19, 48, Unsigned;
    UNSIGNED56 = 0x1A, 56, Unsigned;
    UNSIGNED64 = 0x1B, 64, Unsigned;
}

impl DataType {
    /// Length over SDO in bytes: a BOOLEAN takes one; 0 where the length varies.
    pub const fn bytes(self) -> usize {
        self.bits().div_ceil(8) as usize
    }

    /// Whether values are whole numbers; a BOOLEAN counts as 0 or 1.
    pub const fn is_integer(self) -> bool {
        !matches!(self.kind(), Kind::Other)
    }

    /// Whether values are two's complement.
    pub const fn is_signed(self) -> bool {
        matches!(self.kind(), Kind::Signed)
    }

    /// Lowest and highest value of an integer type.
    ///
    /// ```
    /// # use drivewright_runtime::DataType;
    /// assert_eq!(DataType::INTEGER16.range(), Some((-32_768, 32_767)));
    /// assert_eq!(DataType::BOOLEAN.range(), Some((0, 1)));
    /// assert_eq!(DataType::REAL32.range(), None);
    /// ```
    pub const fn range(self) -> Option<(i128, i128)> {
        // Ones above the bits of the value. A subtraction would do as well, but the optimizer is to see that none overflows.
        let bits = self.bits() as u32;
        match self.kind() {
            Kind::Signed => {
                let min = -1 << bits.saturating_sub(1);
                Some((min, !min))
            }
            Kind::Unsigned => Some((0, !(-1 << bits))),
            Kind::Other => None,
        }
    }

    /// The integer that `bytes` hold, little endian.
    ///
    /// # Errors
    /// [`WireError::NotInteger`] for another kind of type, [`WireError::Length`] unless there are exactly
    /// [`bytes`](Self::bytes), [`WireError::NotBoolean`] for a BOOLEAN other than 0 and 1.
    pub fn decode_int(self, bytes: &[u8]) -> Result<i128, WireError> {
        let (_, max) = self.range().ok_or(WireError::NotInteger { data_type: self })?;
        expect_len(bytes, self.bytes())?;
        let raw = bytes.iter().rev().fold(0_i128, |sum, b| sum << 8 | i128::from(*b));
        match self {
            Self::BOOLEAN if raw > 1 => Err(WireError::NotBoolean { found: bytes[0] }),
            _ if raw > max => Ok(raw - (1 << self.bits())),
            _ => Ok(raw),
        }
    }

    /// Writes `value` to the start of `out`, little endian; returns how many bytes.
    ///
    /// # Errors
    /// [`WireError::NotInteger`] for another kind of type, [`WireError::DoesNotFit`] outside
    /// [`range`](Self::range), [`WireError::Space`] when `out` is too short.
    pub fn encode_int(self, value: i128, out: &mut [u8]) -> Result<usize, WireError> {
        let (min, max) = self.range().ok_or(WireError::NotInteger { data_type: self })?;
        if value < min || value > max {
            return Err(WireError::DoesNotFit { data_type: self });
        }
        put(out, &value.to_le_bytes()[..self.bytes()])
    }
}

impl fmt::Display for DataType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.name() {
            Some(name) => f.write_str(name),
            None => write!(f, "data type {:02X}h", self.0),
        }
    }
}

impl fmt::Debug for DataType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::string::ToString;

    #[test]
    fn integers_round_trip_at_their_edges() {
        for ty in ALL.iter().filter(|t| t.is_integer()) {
            let (min, max) = ty.range().unwrap();
            for value in [min, min + 1, 0, 1, max - 1, max].into_iter().filter(|v| (min..=max).contains(v)) {
                let mut out = [0xAA; 9];
                let len = ty.encode_int(value, &mut out).unwrap();
                assert_eq!((len, out[len]), (ty.bytes(), 0xAA), "{ty} writes its own bytes only");
                assert_eq!(ty.decode_int(&out[..len]), Ok(value), "{ty}");
            }
        }
    }

    #[test]
    fn one_beyond_the_edge_does_not_fit() {
        for ty in ALL.iter().filter(|t| t.is_integer()) {
            let (min, max) = ty.range().unwrap();
            for value in [min - 1, max + 1, i128::MIN, i128::MAX] {
                let result = ty.encode_int(value, &mut [0; 16]);
                assert_eq!(result, Err(WireError::DoesNotFit { data_type: *ty }));
            }
        }
    }

    #[test]
    fn lengths_are_exact() {
        for ty in ALL.iter().filter(|t| t.is_integer()) {
            let n = ty.bytes();
            let long = [0; 9];
            assert_eq!(ty.decode_int(&long[..=n]), Err(WireError::Length { expected: n, found: n + 1 }));
            assert_eq!(ty.decode_int(&long[..n - 1]), Err(WireError::Length { expected: n, found: n - 1 }));
            assert!(ty.encode_int(0, &mut [0; 8][..n - 1]).is_err());
        }
    }

    #[test]
    fn others_are_no_integers() {
        for ty in ALL.iter().copied().chain([DataType(0), DataType(0xFF)]).filter(|t| !t.is_integer()) {
            assert_eq!(ty.decode_int(&[0; 4]), Err(WireError::NotInteger { data_type: ty }));
            assert_eq!(ty.encode_int(0, &mut [0; 4]), Err(WireError::NotInteger { data_type: ty }));
        }
        assert_eq!(DataType::BOOLEAN.decode_int(&[2]), Err(WireError::NotBoolean { found: 2 }));
    }

    #[test]
    fn unknown_codes_show_as_numbers() {
        assert_eq!(DataType(0x17).to_string(), "data type 17h");
        assert_eq!(DataType::UNSIGNED24.to_string(), "UNSIGNED24");
        assert_eq!(DataType(0x40).bits(), 0);
    }
}
