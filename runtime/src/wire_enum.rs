//! Named values of a number. Open: a drive may report a number that the manual does not name, and it must show as
//! what it is.

use core::fmt;

use crate::data_type::DataType;
use crate::wire::{Count, Fixed, Wire, WireError};

/// A number with a name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct EnumValue<'m> {
    // Public for `wire_enum!`: a literal compiles in half the time of a call, and drives have thousands of them.
    #[doc(hidden)]
    pub value: i64,
    #[doc(hidden)]
    pub name: &'m str,
}

impl<'m> EnumValue<'m> {
    /// A number with its name, in words.
    pub const fn new(value: i64, name: &'m str) -> Self {
        Self { value, name }
    }

    /// The number.
    pub const fn value(&self) -> i64 {
        self.value
    }

    /// The name, in words.
    pub const fn name(&self) -> &'m str {
        self.name
    }
}

/// A table of named numbers.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct EnumDesc<'m> {
    #[doc(hidden)]
    pub name: &'m str,
    #[doc(hidden)]
    pub values: &'m [EnumValue<'m>],
}

impl<'m> EnumDesc<'m> {
    /// A table and its name, in words.
    pub const fn new(name: &'m str, values: &'m [EnumValue<'m>]) -> Self {
        Self { name, values }
    }

    /// Its name, in words.
    pub const fn name(&self) -> &'m str {
        self.name
    }

    /// The numbers, in the order of the profile.
    pub const fn values(&self) -> &'m [EnumValue<'m>] {
        self.values
    }

    /// The name of `value`; `None` if the table does not name it.
    pub fn name_of(&self, value: i128) -> Option<&'m str> {
        self.values.iter().find(|v| i128::from(v.value) == value).map(|v| v.name)
    }
}

/// A number under a name of its own: what `wire_enum!` and `bit_field!` make. On the wire it is its number.
pub trait Newtype: Copy + 'static {
    /// The number.
    type Repr: Count;

    /// The value of any number.
    fn from_repr(repr: Self::Repr) -> Self;

    /// The number.
    fn repr(self) -> Self::Repr;
}

impl<N: Newtype> Wire for N {
    type View<'a> = N;
    const DATA_TYPE: DataType = N::Repr::DATA_TYPE;

    #[inline]
    fn encode(view: N, out: &mut [u8]) -> Result<usize, WireError> {
        N::Repr::encode(view.repr(), out)
    }

    #[inline]
    fn decode(bytes: &[u8]) -> Result<N, WireError> {
        N::Repr::decode(bytes).map(N::from_repr)
    }

    #[inline]
    fn whole(view: N) -> Option<i128> {
        Some(view.to_count())
    }
}

impl<N: Newtype> Fixed for N {
    type Bytes = <N::Repr as Fixed>::Bytes;

    #[inline]
    fn to_bytes(self) -> Self::Bytes {
        self.repr().to_bytes()
    }

    #[inline]
    fn from_bytes(bytes: Self::Bytes) -> Self {
        N::from_repr(N::Repr::from_bytes(bytes))
    }
}

impl<N: Newtype> Count for N {
    #[inline]
    fn to_count(self) -> i128 {
        self.repr().to_count()
    }

    #[inline]
    fn from_count(count: i128) -> Option<Self> {
        N::Repr::from_count(count).map(N::from_repr)
    }
}

/// `Debug` of every `wire_enum!`: the name where there is one, otherwise type and number.
#[doc(hidden)]
pub fn debug(f: &mut fmt::Formatter<'_>, table: EnumDesc<'_>, value: i128) -> fmt::Result {
    match table.name_of(value) {
        Some(name) => write!(f, "{name} ({value})"),
        None => write!(f, "{} {value}", table.name),
    }
}

/// An open type for a number whose values have names: a newtype with one constant a value.
///
/// The name in words after `=>` is what [`name`](EnumDesc::name_of) and `Debug` show. Numbers up to `i64` are named;
/// the representation is an integer primitive.
///
/// ```
/// use drivewright_runtime::prelude::*;
///
/// wire_enum! {
///     /// Mode of operation.
///     pub struct ModeOfOperation(i8) = "mode of operation" {
///         /// Moves to a target position.
///         PROFILE_POSITION = 1 => "profile position",
///         /// Turns with a target velocity.
///         PROFILE_VELOCITY = 3 => "profile velocity",
///     }
/// }
///
/// const MODE: Object<ModeOfOperation, Rw, Rx, Raw> = Object::new(0x6060, 0);
///
/// let mut out = [0];
/// MODE.encode(ModeOfOperation::PROFILE_VELOCITY, &mut out)?;
/// assert_eq!(out, [3]);
/// assert_eq!(MODE.decode(&[1])?.name(), Some("profile position"));
/// // A value that the manual does not name is still a value.
/// assert_eq!(format!("{:?}", MODE.decode(&[0xFD])?), "mode of operation -3");
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[macro_export]
macro_rules! wire_enum {
    (
        $(#[$meta:meta])*
        $vis:vis struct $name:ident($repr:ty) = $words:literal {
            $($(#[$value_meta:meta])* $value_name:ident = $value:literal => $value_words:literal),* $(,)?
        }
    ) => {
        // As few and as short bodies as do: each costs every user of a drive with hundreds of tables. `PartialEq` must be
        // derived, so that constants are patterns; `Clone` and `Eq` are cheaper by hand. Attributes cost, too: only what
        // calls something needs `inline` to be compiled by its users alone.
        $(#[$meta])*
        #[derive(PartialEq)]
        #[repr(transparent)]
        $vis struct $name(
            /// The number.
            $vis $repr,
        );

        #[allow(dead_code)]
        impl $name {
            $($(#[$value_meta])* $vis const $value_name: Self = Self($value);)*

            /// The named values.
            $vis const DESC: $crate::wire_enum::EnumDesc<'static> = $crate::wire_enum::EnumDesc {
                name: $words,
                values: &[$($crate::wire_enum::EnumValue { value: $value, name: $value_words }),*],
            };

            /// The name in words; `None` for a number that the manual does not name.
            #[inline]
            $vis fn name(self) -> ::core::option::Option<&'static str> {
                Self::DESC.name_of(self.0 as i128)
            }
        }

        impl ::core::marker::Copy for $name {}

        impl ::core::clone::Clone for $name {
            fn clone(&self) -> Self {
                *self
            }
        }

        impl ::core::cmp::Eq for $name {}

        impl $crate::wire_enum::Newtype for $name {
            type Repr = $repr;

            fn from_repr(repr: $repr) -> Self {
                Self(repr)
            }

            fn repr(self) -> $repr {
                self.0
            }
        }

        impl ::core::fmt::Debug for $name {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::wire_enum::debug(f, Self::DESC, self.0 as i128)
            }
        }

        impl<H: $crate::constant::Holds<Value = $name>> $crate::constant::Whole<H> for $name {
            const COUNT: i128 = H::VALUE.0 as i128;
        }

        $crate::__serde!($name);
        $crate::__defmt!($name);
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::format;

    crate::wire_enum! {
        /// Two names.
        struct Mode(i8) = "mode" {
            /// One.
            ONE = 1 => "one",
            /// Below zero.
            VENDOR = -3 => "vendor mode",
        }
    }

    crate::wire_enum! {
        /// None.
        struct Nothing(u32) = "nothing" {}
    }

    #[test]
    fn every_number_is_a_value() {
        for raw in i8::MIN..=i8::MAX {
            let mode = Mode::decode(&raw.to_le_bytes()).unwrap();
            assert_eq!((mode.0, mode.to_count()), (raw, raw.into()));
            assert_eq!(mode.name().is_some(), matches!(raw, 1 | -3));
        }
        assert_eq!(Mode::from_count(128), None);
    }

    #[test]
    fn names_show() {
        assert_eq!(format!("{:?} {:?}", Mode::VENDOR, Mode(9)), "vendor mode (-3) mode 9");
        assert_eq!(format!("{:?}", Nothing(u32::MAX)), "nothing 4294967295");
    }

    #[test]
    fn constants_are_patterns() {
        assert!(matches!(Mode(1), Mode::ONE));
    }
}
