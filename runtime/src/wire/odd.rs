//! Integers of 24, 40, 48 and 56 bits.

use core::fmt;

use super::{decode_fixed, put, Count, Fixed, Wire, WireError};
use crate::data_type::DataType;

macro_rules! odd {
    ($($name:ident($inner:ty) = $code:ident, $bytes:literal, $min:expr, $max:expr;)*) => {$(
        #[doc = concat!("`", stringify!($code), "`: ", stringify!($bytes), " bytes on the wire.")]
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[repr(transparent)]
        pub struct $name($inner);

        impl $name {
            /// Lowest value.
            pub const MIN: Self = Self($min);
            /// Highest value.
            pub const MAX: Self = Self($max);

            /// The value; `None` outside [`MIN`](Self::MIN) to [`MAX`](Self::MAX).
            #[allow(clippy::absurd_extreme_comparisons, unused_comparisons)]
            pub const fn new(value: $inner) -> Option<Self> {
                if value < $min || value > $max {
                    None
                } else {
                    Some(Self(value))
                }
            }

            /// The value as the next wider integer.
            pub const fn get(self) -> $inner {
                self.0
            }
        }

        impl From<$name> for $inner {
            fn from(value: $name) -> Self {
                value.0
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.fmt(f)
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.fmt(f)
            }
        }

        impl Wire for $name {
            type View<'a> = Self;
            const DATA_TYPE: DataType = DataType::$code;

            #[inline]
            fn encode(view: Self, out: &mut [u8]) -> Result<usize, WireError> {
                put(out, &view.to_bytes())
            }

            #[inline]
            fn decode(bytes: &[u8]) -> Result<Self, WireError> {
                decode_fixed(bytes)
            }

            #[inline]
            fn whole(view: Self) -> Option<i128> {
                Some(view.to_count())
            }
        }

        impl Fixed for $name {
            type Bytes = [u8; $bytes];

            #[inline]
            fn to_bytes(self) -> [u8; $bytes] {
                let mut bytes = [0; $bytes];
                bytes.copy_from_slice(&self.0.to_le_bytes()[..$bytes]);
                bytes
            }

            #[inline]
            fn from_bytes(bytes: [u8; $bytes]) -> Self {
                let mut wide = <$inner>::default().to_le_bytes();
                wide[..$bytes].copy_from_slice(&bytes);
                // Up to the top and back: the second shift repeats the sign of a signed type.
                let unused = <$inner>::BITS - 8 * $bytes;
                Self(<$inner>::from_le_bytes(wide) << unused >> unused)
            }
        }

        impl Count for $name {
            #[inline]
            fn to_count(self) -> i128 {
                i128::from(self.0)
            }

            #[inline]
            fn from_count(count: i128) -> Option<Self> {
                Self::new(<$inner>::try_from(count).ok()?)
            }
        }
    )*};
}

odd! {
    U24(u32) = UNSIGNED24, 3, 0, (1 << 24) - 1;
    U40(u64) = UNSIGNED40, 5, 0, (1 << 40) - 1;
    U48(u64) = UNSIGNED48, 6, 0, (1 << 48) - 1;
    U56(u64) = UNSIGNED56, 7, 0, (1 << 56) - 1;
    I24(i32) = INTEGER24, 3, -(1 << 23), (1 << 23) - 1;
    I40(i64) = INTEGER40, 5, -(1 << 39), (1 << 39) - 1;
    I48(i64) = INTEGER48, 6, -(1 << 47), (1 << 47) - 1;
    I56(i64) = INTEGER56, 7, -(1 << 55), (1 << 55) - 1;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sign_is_kept() {
        assert_eq!(I24::decode(&[0xFF, 0xFF, 0xFF]), Ok(I24(-1)));
        assert_eq!(I24::decode(&[0x00, 0x00, 0x80]), Ok(I24::MIN));
        assert_eq!(U24::decode(&[0xFF, 0xFF, 0xFF]), Ok(U24::MAX));
        assert_eq!(I24::new(1 << 23), None);
        assert_eq!(U24::new(1 << 24), None);
    }
}
