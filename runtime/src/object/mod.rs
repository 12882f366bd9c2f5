//! Typed handles: what a program names instead of an index, a width and an access right.
//!
//! A handle is plain data without identity of its own: it costs nothing until it is used.

mod convert;
mod error;

use core::fmt;
use core::marker::PhantomData;

use crate::access::{Access, AccessMarker, Readable, Writable};
use crate::address::Address;
use crate::data_type::DataType;
use crate::mapping::{Mapping, MappingMarker};
use crate::wire::{Wire, WireError};

pub use error::{ConvertError, EncodeError, RangeError};

/// An entry of the object dictionary.
///
/// `T` is its type on the wire, `A` its SDO access ([`access`](crate::access)), `M` the process data that may carry
/// it ([`mapping`](crate::mapping)), `Q` what it measures ([`quantity`](crate::quantity)).
///
/// ```
/// use drivewright_runtime::prelude::*;
///
/// pub const PROFILE_VELOCITY: Object<u32, Rw, RxTx, Velocity> =
///     Object::new(0x6081, 0).range(0, 60_000).scale(1, 10);
///
/// let mut out = [0; 4];
/// assert_eq!(PROFILE_VELOCITY.encode(30_000, &mut out), Ok(4));
/// assert_eq!(PROFILE_VELOCITY.decode(&out), Ok(30_000));
/// assert_eq!(PROFILE_VELOCITY.raw_from(Value::rpm(3_000)), Ok(30_000));
/// assert!(PROFILE_VELOCITY.check(60_001).is_err());
/// ```
pub struct Object<T, A, M, Q> {
    // Visible to `row`, which makes handles by one literal.
    pub(crate) address: Address,
    pub(crate) num: u32,
    pub(crate) den: u32,
    pub(crate) min: i64,
    pub(crate) max: i64,
    pub(crate) allowed: &'static [i64],
    pub(crate) types: Types<T, A, M, Q>,
}

/// A function pointer: `Send + Sync + Copy` whatever the markers are.
type Types<T, A, M, Q> = PhantomData<fn() -> (T, A, M, Q)>;

/// A type as an argument, for macros that know it by name.
#[doc(hidden)]
pub type Is<T> = PhantomData<fn() -> T>;

/// The type as an argument.
#[doc(hidden)]
pub const fn is<T>() -> Is<T> {
    PhantomData
}

/// What `min` holds where no lower limit is stated.
pub(crate) const NO_MIN: i64 = i64::MIN;
/// What `max` holds where no upper limit is stated.
pub(crate) const NO_MAX: i64 = i64::MAX;

impl<T, A, M, Q> Object<T, A, M, Q> {
    /// The entry at `index` and `sub`, without limits and with one count as one base unit.
    pub const fn new(index: u16, sub: u8) -> Self {
        Self {
            address: Address::new(index, sub),
            num: 1,
            den: 1,
            min: NO_MIN,
            max: NO_MAX,
            allowed: &[],
            types: PhantomData,
        }
    }

    /// With the lowest and highest raw value that the drive accepts, both included.
    ///
    /// `i64::MIN` and `i64::MAX` mean that no limit is stated. If `min` is above `max`, every value is refused.
    #[must_use]
    pub const fn range(mut self, min: i64, max: i64) -> Self {
        self.min = min;
        self.max = max;
        self
    }

    /// With the lowest raw value that the drive accepts, where no highest is stated.
    ///
    /// ```
    /// use drivewright_runtime::prelude::*;
    ///
    /// const DISPLAY: Object<i32, Rw, Unmapped, Raw> = Object::new(0x3001, 0x4D).at_least(0);
    ///
    /// assert!(DISPLAY.check(i32::MAX).is_ok() && DISPLAY.check(-1).is_err());
    /// ```
    #[must_use]
    pub const fn at_least(mut self, min: i64) -> Self {
        self.min = min;
        self
    }

    /// With the highest raw value that the drive accepts, where no lowest is stated.
    ///
    /// ```
    /// use drivewright_runtime::prelude::*;
    ///
    /// const SPEED: Object<u32, Rw, Unmapped, Raw> = Object::new(0x607F, 0).at_most(60_000);
    ///
    /// assert!(SPEED.check(0).is_ok() && SPEED.check(60_001).is_err());
    /// ```
    #[must_use]
    pub const fn at_most(mut self, max: i64) -> Self {
        self.max = max;
        self
    }

    /// With the only raw values that the drive accepts. An empty list means that none is stated.
    ///
    /// ```
    /// use drivewright_runtime::prelude::*;
    ///
    /// const BAUD_RATE: Object<u8, Rw, Unmapped, Raw> = Object::new(0x2000, 0).range(0, 8).allow(&[0, 1, 5]);
    ///
    /// assert!(BAUD_RATE.check(5).is_ok());
    /// assert_eq!(BAUD_RATE.check(2).unwrap_err().to_string(), "2 is not one of 0, 1, 5, the raw values of 2000:00");
    /// ```
    #[must_use]
    pub const fn allow(mut self, allowed: &'static [i64]) -> Self {
        self.allowed = allowed;
        self
    }

    /// With one count as `num / den` base units of `Q`. With a 0, every conversion fails with
    /// [`ConvertError::NoScale`].
    #[must_use]
    pub const fn scale(mut self, num: u32, den: u32) -> Self {
        self.num = num;
        self.den = den;
        self
    }

    /// Index and sub-index.
    pub const fn address(self) -> Address {
        self.address
    }

    /// Lowest raw value that the drive accepts; `None` where none is stated.
    pub const fn min(self) -> Option<i64> {
        if self.min == NO_MIN {
            None
        } else {
            Some(self.min)
        }
    }

    /// Highest raw value that the drive accepts; `None` where none is stated.
    pub const fn max(self) -> Option<i64> {
        if self.max == NO_MAX {
            None
        } else {
            Some(self.max)
        }
    }

    /// The only raw values that the drive accepts; empty where none is stated.
    pub const fn allowed(self) -> &'static [i64] {
        self.allowed
    }

    /// What one count is worth, in base units: numerator and denominator, as stated.
    pub const fn factor(self) -> (u32, u32) {
        (self.num, self.den)
    }

    /// Whether `raw` is within the stated limits and one of the listed values. The width of the type is not looked at.
    pub const fn accepts(self, raw: i128) -> bool {
        self.in_range(raw) && self.in_list(raw)
    }

    /// Whether `raw` is within the stated limits.
    #[doc(hidden)]
    pub const fn in_range(self, raw: i128) -> bool {
        (self.min == NO_MIN || raw >= self.min as i128) && (self.max == NO_MAX || raw <= self.max as i128)
    }

    /// Whether `raw` is one of the listed values, or none is listed.
    #[doc(hidden)]
    pub const fn in_list(self, raw: i128) -> bool {
        let mut left = self.allowed;
        while let [value, rest @ ..] = left {
            if *value as i128 == raw {
                return true;
            }
            left = rest;
        }
        self.allowed.is_empty()
    }

    /// That `raw` is within the stated limits and one of the listed values.
    #[inline]
    pub(crate) fn check_count(self, raw: i128) -> Result<(), RangeError> {
        if self.accepts(raw) {
            Ok(())
        } else {
            Err(RangeError::new(self.address, raw, (self.min, self.max), self.allowed))
        }
    }
}

impl<T: Wire, A, M, Q> Object<T, A, M, Q> {
    /// The data type.
    pub const fn data_type(self) -> DataType {
        T::DATA_TYPE
    }

    /// Whether `value` is within the stated limits and one of the listed values; texts, bytes and floating point have
    /// neither.
    ///
    /// # Errors
    /// [`RangeError`] with the value, the limits and the list.
    #[inline]
    pub fn check(self, value: T::View<'_>) -> Result<(), RangeError> {
        match T::whole(value) {
            Some(count) => self.check_count(count),
            None => Ok(()),
        }
    }

    /// Checks `value` and writes it to the start of `out`; returns how many bytes.
    ///
    /// # Errors
    /// [`EncodeError::Range`] for a value that the drive refuses, [`EncodeError::Wire`] when `out` is too short.
    #[inline]
    pub fn encode(self, value: T::View<'_>, out: &mut [u8]) -> Result<usize, EncodeError>
    where
        A: Writable,
    {
        self.check(value)?;
        Ok(T::encode(value, out)?)
    }

    /// Reads the value from all of `bytes`. What a drive reports is not checked against the limits: they say what it
    /// accepts.
    ///
    /// # Errors
    /// [`WireError`] when the length is not that of the type.
    #[inline]
    pub fn decode(self, bytes: &[u8]) -> Result<T::View<'_>, WireError>
    where
        A: Readable,
    {
        T::decode(bytes)
    }
}

impl<T, A: AccessMarker, M: MappingMarker, Q> Object<T, A, M, Q> {
    /// SDO access, as a value.
    pub const fn access(self) -> Access {
        A::ACCESS
    }

    /// Which process data may carry it, as a value.
    pub const fn mapping(self) -> Mapping {
        M::MAPPING
    }
}

// Derives would ask the same of the marker types.
impl<T, A, M, Q> Clone for Object<T, A, M, Q> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T, A, M, Q> Copy for Object<T, A, M, Q> {}

impl<T, A, M, Q> fmt::Debug for Object<T, A, M, Q> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Object({})", self.address)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prelude::*;

    const SPEED: Object<u16, Rw, Rx, Velocity> = Object::new(0x3000, 1).range(10, 6_000);

    #[test]
    fn limits_are_included() {
        for (value, ok) in [(9, false), (10, true), (6_000, true), (6_001, false), (u16::MAX, false)] {
            assert_eq!(SPEED.check(value).is_ok(), ok, "{value}");
        }
        let error = SPEED.check(9).unwrap_err();
        assert_eq!(
            (error.address, error.value, error.min, error.max),
            (Address::new(0x3000, 1), 9, 10, 6_000)
        );
    }

    #[test]
    fn a_refused_value_leaves_the_buffer_alone() {
        let mut out = [7; 2];
        assert!(matches!(SPEED.encode(9, &mut out), Err(EncodeError::Range(_))));
        assert_eq!(out, [7; 2]);
        assert_eq!(SPEED.encode(0x0102, &mut out[..1]), Err(WireError::Space { needed: 2, space: 1 }.into()));
        assert_eq!(SPEED.encode(0x0102, &mut out), Ok(2));
        assert_eq!(out, [2, 1]);
    }

    #[test]
    fn without_limits_the_type_is_the_limit() {
        const WIDE: Object<u64, Rw, Unmapped, Raw> = Object::new(0x3001, 0);
        const SIGNED: Object<i64, Rw, Unmapped, Raw> = Object::new(0x3001, 0);
        assert!(WIDE.check(0).is_ok());
        assert!(WIDE.check(u64::MAX).is_ok());
        assert_eq!((WIDE.min(), WIDE.max()), (None, None));
        assert!(WIDE.range(0, 5).check(u64::MAX).is_err());
        assert!(SIGNED.check(i64::MIN).is_ok());
        assert!(SIGNED.check(i64::MAX).is_ok());
    }

    #[test]
    fn only_listed_values_are_accepted() {
        const OPTION: Object<i16, Rw, RxTx, Raw> = Object::new(0x605A, 0).range(-1, 8).allow(&[-1, 0, 5, 9]);
        for value in -3..12 {
            assert_eq!(OPTION.accepts(value.into()), [-1, 0, 5].contains(&value), "{value}");
            assert_eq!(OPTION.encode(value, &mut [0; 2]).is_ok(), OPTION.check(value).is_ok());
        }
        assert!(!OPTION.accepts(i128::MAX) && !OPTION.accepts(1 << 64 | 5));
        let error = OPTION.check(2).unwrap_err();
        assert_eq!((error.value, error.allowed), (2, OPTION.allowed()));
        assert!(OPTION.allow(&[]).accepts(2), "no list");
    }

    #[test]
    fn an_empty_range_refuses_everything() {
        let none = SPEED.range(5, 4);
        assert!((0..10).all(|v| none.check(v).is_err()));
    }

    #[test]
    fn reports_are_not_checked_but_their_length_is() {
        assert_eq!(SPEED.decode(&[0xFF, 0xFF]), Ok(0xFFFF));
        assert_eq!(SPEED.decode(&[0; 4]), Err(WireError::Length { expected: 2, found: 4 }));
    }

    #[test]
    fn texts_have_no_range() {
        const NAME: Object<VisibleString, Const, Unmapped, Raw> = Object::new(0x1008, 0).range(1, 0);
        assert_eq!(NAME.decode(b"ELD2").unwrap().as_str(), Ok("ELD2"));
        assert!(NAME.check(Text::new("x")).is_ok());
    }

    #[test]
    fn a_handle_crosses_threads() {
        fn ok<T: Send + Sync + Copy + 'static>(_: T) {}
        ok(SPEED);
        ok(Object::<*const u8, (), (), ()>::new(0, 0));
        assert_eq!((SPEED.access(), SPEED.mapping()), (Access::Rw, Mapping::Rx));
        assert_eq!(SPEED.data_type(), DataType::UNSIGNED16);
    }
}
