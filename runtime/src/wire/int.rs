//! BOOLEAN, integers of a whole power of two, REAL32 and REAL64.

use super::{decode_fixed, put, Count, Fixed, Wire, WireError};
use crate::data_type::DataType;

macro_rules! fixed {
    ($($ty:ty = $code:ident, $bytes:literal $(, $count:ident)?;)*) => {$(
        impl Wire for $ty {
            type View<'a> = Self;
            const DATA_TYPE: DataType = DataType::$code;

            #[inline]
            fn encode(view: Self, out: &mut [u8]) -> Result<usize, WireError> {
                put(out, &view.to_le_bytes())
            }

            #[inline]
            fn decode(bytes: &[u8]) -> Result<Self, WireError> {
                decode_fixed(bytes)
            }

            $(
                #[inline]
                fn whole(view: Self) -> Option<i128> {
                    Some($count::to_count(view))
                }
            )?
        }

        impl Fixed for $ty {
            type Bytes = [u8; $bytes];

            #[inline]
            fn to_bytes(self) -> [u8; $bytes] {
                self.to_le_bytes()
            }

            #[inline]
            fn from_bytes(bytes: [u8; $bytes]) -> Self {
                Self::from_le_bytes(bytes)
            }
        }

        $(
            impl $count for $ty {
                #[inline]
                fn to_count(self) -> i128 {
                    i128::from(self)
                }

                #[inline]
                fn from_count(count: i128) -> Option<Self> {
                    Self::try_from(count).ok()
                }
            }
        )?
    )*};
}

fixed! {
    u8 = UNSIGNED8, 1, Count;
    u16 = UNSIGNED16, 2, Count;
    u32 = UNSIGNED32, 4, Count;
    u64 = UNSIGNED64, 8, Count;
    i8 = INTEGER8, 1, Count;
    i16 = INTEGER16, 2, Count;
    i32 = INTEGER32, 4, Count;
    i64 = INTEGER64, 8, Count;
    f32 = REAL32, 4;
    f64 = REAL64, 8;
}

impl Wire for bool {
    type View<'a> = Self;
    const DATA_TYPE: DataType = DataType::BOOLEAN;

    #[inline]
    fn encode(view: Self, out: &mut [u8]) -> Result<usize, WireError> {
        put(out, &view.to_bytes())
    }

    #[inline]
    fn decode(bytes: &[u8]) -> Result<Self, WireError> {
        match bytes {
            [0] => Ok(false),
            [1] => Ok(true),
            [found] => Err(WireError::NotBoolean { found: *found }),
            _ => Err(WireError::Length { expected: 1, found: bytes.len() }),
        }
    }

    #[inline]
    fn whole(view: Self) -> Option<i128> {
        Some(view.to_count())
    }
}

impl Fixed for bool {
    type Bytes = [u8; 1];

    #[inline]
    fn to_bytes(self) -> [u8; 1] {
        [u8::from(self)]
    }

    #[inline]
    fn from_bytes(bytes: [u8; 1]) -> Self {
        bytes != [0]
    }
}

impl Count for bool {
    #[inline]
    fn to_count(self) -> i128 {
        i128::from(self)
    }

    #[inline]
    fn from_count(count: i128) -> Option<Self> {
        match count {
            0 => Some(false),
            1 => Some(true),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edges<T: Count + PartialEq + core::fmt::Debug>() {
        let (min, max) = T::DATA_TYPE.range().unwrap();
        for count in [min, 0, 1, max] {
            let value = T::from_count(count).unwrap();
            let mut out = [0x55; 9];
            let len = T::encode(value, &mut out).unwrap();
            assert_eq!((len, out[len]), (T::DATA_TYPE.bytes(), 0x55));
            assert_eq!(T::decode(&out[..len]), Ok(value));
            assert_eq!(T::DATA_TYPE.decode_int(&out[..len]), Ok(count), "both codecs agree");
            assert_eq!((T::whole(value), value.to_count()), (Some(count), count));
            assert!(T::encode(value, &mut out[..len - 1]).is_err());
            assert_eq!(T::decode(&out), Err(WireError::Length { expected: len, found: 9 }));
            assert_eq!(T::decode(&out[..len - 1]), Err(WireError::Length { expected: len, found: len - 1 }));
        }
        assert_eq!((T::from_count(min - 1), T::from_count(max + 1)), (None, None));
    }

    #[test]
    fn integers_round_trip_at_their_edges() {
        edges::<bool>();
        edges::<u8>();
        edges::<u16>();
        edges::<u32>();
        edges::<u64>();
        edges::<i8>();
        edges::<i16>();
        edges::<i32>();
        edges::<i64>();
        edges::<crate::wire::U24>();
        edges::<crate::wire::U40>();
        edges::<crate::wire::U48>();
        edges::<crate::wire::U56>();
        edges::<crate::wire::I24>();
        edges::<crate::wire::I40>();
        edges::<crate::wire::I48>();
        edges::<crate::wire::I56>();
    }

    #[test]
    fn little_endian() {
        let mut out = [0; 4];
        u32::encode(0x1234_5678, &mut out).unwrap();
        assert_eq!(out, [0x78, 0x56, 0x34, 0x12]);
        assert_eq!(f32::decode(&1.5_f32.to_le_bytes()), Ok(1.5));
        assert_eq!(f64::decode(&[0; 4]), Err(WireError::Length { expected: 8, found: 4 }));
        assert_eq!(f32::whole(1.0), None);
    }

    #[test]
    fn booleans_are_strict() {
        assert_eq!(bool::decode(&[0xFF]), Err(WireError::NotBoolean { found: 0xFF }));
        assert_eq!(bool::decode(&[]), Err(WireError::Length { expected: 1, found: 0 }));
    }
}
