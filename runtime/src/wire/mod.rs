//! Values on the wire: little endian, exact lengths, no allocation.
//!
//! [`Wire`] is what a typed handle needs: a type code, a width and a codec. [`Fixed`] adds that the length never
//! varies, [`Count`] that the value is a whole number, so that it has a range and a scale.

mod int;
mod odd;
mod text;

use core::fmt;

use crate::data_type::DataType;

pub use odd::{I24, I40, I48, I56, U24, U40, U48, U56};
pub use text::{Domain, NotText, OctetString, Text, TimeDifference, TimeOfDay, UnicodeString, VisibleString};

/// A type of value that an object of the dictionary can hold.
///
/// Integers, `f32`, `f64`, every `wire_enum!` and every `bit_field!` are seen as themselves. The zero-sized
/// [`VisibleString`], [`OctetString`], [`UnicodeString`] and [`Domain`] are seen as borrowed bytes.
///
/// ```
/// use drivewright_runtime::{Wire, WireError};
///
/// let mut out = [0; 4];
/// assert_eq!(i16::encode(-2, &mut out), Ok(2));
/// assert_eq!(out, [0xFE, 0xFF, 0, 0]);
/// assert_eq!(i16::decode(&out[..2]), Ok(-2));
/// assert_eq!(i16::decode(&out), Err(WireError::Length { expected: 2, found: 4 }));
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no data type of CiA 301",
    label = "not a value that an object can hold",
    note = "use an integer of 8 to 64 bits, `bool`, `f32`, `f64`, a string marker, or a type made by `wire_enum!` or `bit_field!`"
)]
pub trait Wire: 'static {
    /// The value as a program sees it: the type itself, or borrowed bytes where the length varies.
    type View<'a>: Copy;
    /// The code in CiA 301.
    const DATA_TYPE: DataType;
    /// Width in a PDO in bits; 0 where the length varies.
    const BITS: u16 = Self::DATA_TYPE.bits();

    /// Writes the value to the start of `out`; returns how many bytes.
    ///
    /// # Errors
    /// [`WireError::Space`] when `out` is too short.
    fn encode(view: Self::View<'_>, out: &mut [u8]) -> Result<usize, WireError>;

    /// Reads the value from all of `bytes`.
    ///
    /// # Errors
    /// [`WireError::Length`] unless the length is exactly that of the type, [`WireError::NotBoolean`] for a
    /// `bool` other than 0 and 1.
    fn decode(bytes: &[u8]) -> Result<Self::View<'_>, WireError>;

    /// The value as a whole number; `None` for texts, bytes and floating point.
    fn whole(view: Self::View<'_>) -> Option<i128> {
        let _ = view;
        None
    }
}

/// A type whose length never varies.
pub trait Fixed: for<'a> Wire<View<'a> = Self> + Copy {
    /// An array of as many bytes as the value takes.
    type Bytes: AsRef<[u8]> + for<'a> TryFrom<&'a [u8]> + Default;

    /// The value, little endian.
    fn to_bytes(self) -> Self::Bytes;

    /// The value of these bytes. A `bool` is true unless the byte is 0; [`Wire::decode`] is stricter.
    fn from_bytes(bytes: Self::Bytes) -> Self;
}

/// A whole number: an integer, a `bool`, a `wire_enum!` or a `bit_field!`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no whole number, so it has neither counts nor a scale",
    label = "this object holds text, bytes or floating point",
    note = "read or write its value directly with `decode` and `encode`"
)]
pub trait Count: Fixed {
    /// The value as a number.
    fn to_count(self) -> i128;

    /// The value that is this number; `None` if the type cannot hold it.
    fn from_count(count: i128) -> Option<Self>;
}

/// Why bytes are no value, or a value does not go into bytes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum WireError {
    /// As many bytes as `found` are no value of a type that takes `expected`.
    Length {
        /// Bytes that the type takes.
        expected: usize,
        /// Bytes that were given.
        found: usize,
    },
    /// The buffer has `space` bytes and the value needs more.
    Space {
        /// Bytes that the value takes.
        needed: usize,
        /// Bytes that the buffer has.
        space: usize,
    },
    /// A BOOLEAN that is neither 0 nor 1.
    NotBoolean {
        /// The byte.
        found: u8,
    },
    /// The type does not hold whole numbers.
    NotInteger {
        /// The type.
        data_type: DataType,
    },
    /// The number is outside the range of the type.
    DoesNotFit {
        /// The type.
        data_type: DataType,
    },
}

impl fmt::Display for WireError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { expected, found } => write!(f, "{found} bytes where the type takes {expected}"),
            Self::Space { needed, space } => {
                write!(f, "the value takes {needed} bytes and the buffer has {space}")
            }
            Self::NotBoolean { found } => write!(f, "a BOOLEAN is 0 or 1, not {found}"),
            Self::NotInteger { data_type } => write!(f, "{data_type} does not hold whole numbers"),
            Self::DoesNotFit { data_type } => write!(f, "the number is outside the range of {data_type}"),
        }
    }
}

impl core::error::Error for WireError {}

/// Copies `bytes` to the start of `out`; returns how many there are.
#[doc(hidden)]
#[inline]
pub fn put(out: &mut [u8], bytes: &[u8]) -> Result<usize, WireError> {
    let space = out.len();
    let place = out.get_mut(..bytes.len()).ok_or(WireError::Space { needed: bytes.len(), space })?;
    place.copy_from_slice(bytes);
    Ok(bytes.len())
}

/// That there are `expected` bytes.
#[inline]
pub(crate) fn expect_len(bytes: &[u8], expected: usize) -> Result<(), WireError> {
    if bytes.len() == expected {
        Ok(())
    } else {
        Err(WireError::Length { expected, found: bytes.len() })
    }
}

/// All of `bytes` as an array.
#[doc(hidden)]
#[inline]
pub fn exactly<const N: usize>(bytes: &[u8]) -> Result<&[u8; N], WireError> {
    bytes.try_into().map_err(|_| WireError::Length { expected: N, found: bytes.len() })
}

/// `decode` of every fixed type that has no forbidden bit pattern.
#[inline]
pub(crate) fn decode_fixed<T: Fixed>(bytes: &[u8]) -> Result<T, WireError> {
    match T::Bytes::try_from(bytes) {
        Ok(array) => Ok(T::from_bytes(array)),
        Err(_) => Err(WireError::Length { expected: T::DATA_TYPE.bytes(), found: bytes.len() }),
    }
}
