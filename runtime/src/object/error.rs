//! Why a handle refuses a value.

use core::fmt;

use crate::address::Address;
use crate::wire::WireError;

/// A raw value that the manual excludes: outside its limits, or none of those that it lists. The drive would refuse it with abort 0609 0030, 0609 0031
/// or 0609 0032, or clip it without a word.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct RangeError {
    /// The object.
    pub address: Address,
    /// The raw value; one beyond 64 bits shows as the nearest `i64`.
    pub value: i64,
    /// Lowest raw value; `i64::MIN` where none is stated.
    pub min: i64,
    /// Highest raw value; `i64::MAX` where none is stated.
    pub max: i64,
    /// The only raw values; empty where none are listed.
    pub allowed: &'static [i64],
}

impl RangeError {
    #[cold]
    pub(crate) fn new(address: Address, value: i128, range: (i64, i64), allowed: &'static [i64]) -> Self {
        let nearest = if value < 0 { i64::MIN } else { i64::MAX };
        let value = i64::try_from(value).unwrap_or(nearest);
        Self { address, value, min: range.0, max: range.1, allowed }
    }
}

impl fmt::Display for RangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { address, value, min, max, allowed } = self;
        let [first, others @ ..] = allowed else {
            return write!(f, "{value} is outside {min} to {max}, the raw range of {address}");
        };
        write!(f, "{value} is not one of {first}")?;
        others.iter().try_for_each(|other| write!(f, ", {other}"))?;
        write!(f, ", the raw values of {address}")
    }
}

impl core::error::Error for RangeError {}

/// Why a value cannot be written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum EncodeError {
    /// The value is outside the stated limits, or not listed.
    Range(RangeError),
    /// The value does not go into the bytes.
    Wire(WireError),
}

impl fmt::Display for EncodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Range(error) => error.fmt(f),
            Self::Wire(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for EncodeError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Range(error) => Some(error),
            Self::Wire(error) => Some(error),
        }
    }
}

impl From<RangeError> for EncodeError {
    fn from(error: RangeError) -> Self {
        Self::Range(error)
    }
}

impl From<WireError> for EncodeError {
    fn from(error: WireError) -> Self {
        Self::Wire(error)
    }
}

/// Why a physical value has no raw value, or the other way round.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ConvertError {
    /// The value lies between two counts; the rounding conversion takes the nearest.
    NotExact {
        /// The object.
        address: Address,
    },
    /// The count is outside the stated limits, not listed, or outside the type.
    OutOfRange(RangeError),
    /// The result takes more than 64 bits above or 32 bits below the line.
    TooLarge {
        /// The object.
        address: Address,
    },
    /// The handle's scale, or its product with that of the drive, is no factor above zero of 64 bits.
    NoScale {
        /// The object.
        address: Address,
    },
}

impl fmt::Display for ConvertError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotExact { address } => write!(f, "the value lies between two counts of {address}"),
            Self::OutOfRange(error) => error.fmt(f),
            Self::TooLarge { address } => write!(f, "the value is too large or too fine for {address}"),
            Self::NoScale { address } => write!(f, "{address} has no usable scale"),
        }
    }
}

impl core::error::Error for ConvertError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::OutOfRange(error) => Some(error),
            _ => None,
        }
    }
}

impl From<RangeError> for ConvertError {
    fn from(error: RangeError) -> Self {
        Self::OutOfRange(error)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::error::Error;
    use std::string::ToString;

    #[test]
    fn errors_say_what_was_wrong_and_carry_their_source() {
        let range = RangeError::new(Address::new(0x6081, 0), 70_000, (0, 60_000), &[]);
        assert_eq!(range.to_string(), "70000 is outside 0 to 60000, the raw range of 6081:00");
        assert_eq!(EncodeError::from(range).source().unwrap().to_string(), range.to_string());
        assert!(ConvertError::from(range).source().is_some());
        let of = |value| RangeError::new(Address::new(0, 0), value, (0, 1), &[7]);
        assert_eq!((of(u64::MAX.into()).value, of(i128::MIN).value), (i64::MAX, i64::MIN));
        assert_eq!(of(8).to_string(), "8 is not one of 7, the raw values of 0000:00");
    }
}
