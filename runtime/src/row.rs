//! Rows of generated code: a handle or an entry of the dictionary by one call with everything that is stated.
//!
//! They say what the builders of [`Object`] and [`ObjectDesc`] say. A chain of builders reads better by hand; a thousand
//! rows compile in half the time as plain calls of free functions with plain constants.

#![allow(clippy::too_many_arguments, reason = "each is a column of a table")]

use crate::access::Access;
use crate::address::Address;
use crate::data_type::DataType;
use crate::mapping::Mapping;
use crate::model::ObjectDesc;
use crate::object::{Object, NO_MAX, NO_MIN};

pub use crate::model::NO_UNIT;

/// A handle without limits, with one count as one base unit.
pub const fn object<T, A, M, Q>(index: u16, sub: u8) -> Object<T, A, M, Q> {
    ranged_scaled(index, sub, NO_MIN, NO_MAX, 1, 1)
}

/// A handle with the lowest and highest raw value.
pub const fn ranged<T, A, M, Q>(index: u16, sub: u8, min: i64, max: i64) -> Object<T, A, M, Q> {
    ranged_scaled(index, sub, min, max, 1, 1)
}

/// A handle with one count as `num / den` base units.
pub const fn scaled<T, A, M, Q>(index: u16, sub: u8, num: u32, den: u32) -> Object<T, A, M, Q> {
    ranged_scaled(index, sub, NO_MIN, NO_MAX, num, den)
}

/// A handle with the lowest and highest raw value, and one count as `num / den` base units.
pub const fn ranged_scaled<T, A, M, Q>(
    index: u16,
    sub: u8,
    min: i64,
    max: i64,
    num: u32,
    den: u32,
) -> Object<T, A, M, Q> {
    let types = core::marker::PhantomData;
    Object { address: Address::new(index, sub), num, den, min, max, allowed: &[], types }
}

/// An entry without limits and default; `unit` is a row of the model's table or [`NO_UNIT`].
pub const fn entry(
    index: u16,
    sub: u8,
    data_type: DataType,
    access: Access,
    mapping: Mapping,
    name: &str,
    unit: u8,
) -> ObjectDesc<'_> {
    ObjectDesc::row((index, sub), data_type, access, mapping, name, unit, (NO_MIN, NO_MAX), None)
}

/// An entry with a default and without limits.
pub const fn preset(
    index: u16,
    sub: u8,
    data_type: DataType,
    access: Access,
    mapping: Mapping,
    name: &str,
    unit: u8,
    default: i64,
) -> ObjectDesc<'_> {
    ObjectDesc::row((index, sub), data_type, access, mapping, name, unit, (NO_MIN, NO_MAX), Some(default))
}

/// An entry with the lowest and highest raw value and without default.
pub const fn limited(
    index: u16,
    sub: u8,
    data_type: DataType,
    access: Access,
    mapping: Mapping,
    name: &str,
    unit: u8,
    min: i64,
    max: i64,
) -> ObjectDesc<'_> {
    ObjectDesc::row((index, sub), data_type, access, mapping, name, unit, (min, max), None)
}

/// An entry with the lowest and highest raw value and a default.
pub const fn full(
    index: u16,
    sub: u8,
    data_type: DataType,
    access: Access,
    mapping: Mapping,
    name: &str,
    unit: u8,
    min: i64,
    max: i64,
    default: i64,
) -> ObjectDesc<'_> {
    ObjectDesc::row((index, sub), data_type, access, mapping, name, unit, (min, max), Some(default))
}

macro_rules! short {
    ($($name:ident: $ty:ident = $of:ident;)*) => {$(
        #[doc = concat!("[`", stringify!($ty), "::", stringify!($of), "`].")]
        pub const $name: $ty = $ty::$of;
    )*};
}

short! {
    RO: Access = Ro;
    RW: Access = Rw;
    WO: Access = Wo;
    CONST: Access = Const;
    NOT_STATED: Mapping = NotStated;
    UNMAPPED: Mapping = Unmapped;
    RX: Mapping = Rx;
    TX: Mapping = Tx;
    RX_TX: Mapping = RxTx;
    BOOLEAN: DataType = BOOLEAN;
    INTEGER8: DataType = INTEGER8;
    INTEGER16: DataType = INTEGER16;
    INTEGER24: DataType = INTEGER24;
    INTEGER32: DataType = INTEGER32;
    INTEGER40: DataType = INTEGER40;
    INTEGER48: DataType = INTEGER48;
    INTEGER56: DataType = INTEGER56;
    INTEGER64: DataType = INTEGER64;
    UNSIGNED8: DataType = UNSIGNED8;
    UNSIGNED16: DataType = UNSIGNED16;
    UNSIGNED24: DataType = UNSIGNED24;
    UNSIGNED32: DataType = UNSIGNED32;
    UNSIGNED40: DataType = UNSIGNED40;
    UNSIGNED48: DataType = UNSIGNED48;
    UNSIGNED56: DataType = UNSIGNED56;
    UNSIGNED64: DataType = UNSIGNED64;
    REAL32: DataType = REAL32;
    REAL64: DataType = REAL64;
    VISIBLE_STRING: DataType = VISIBLE_STRING;
    OCTET_STRING: DataType = OCTET_STRING;
    UNICODE_STRING: DataType = UNICODE_STRING;
    TIME_OF_DAY: DataType = TIME_OF_DAY;
    TIME_DIFFERENCE: DataType = TIME_DIFFERENCE;
    DOMAIN: DataType = DOMAIN;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prelude::{Raw, Rw, Rx, Velocity};

    #[test]
    fn handles_are_what_their_builders_make() {
        type Speed = Object<i32, Rw, Rx, Velocity>;
        let same = |a: Speed, b: Speed| {
            assert_eq!((a.address(), a.min(), a.max()), (b.address(), b.min(), b.max()));
            assert_eq!((a.allowed(), a.factor()), (b.allowed(), b.factor()));
        };
        let new = Speed::new(0x60FF, 3);
        same(object(0x60FF, 3), new);
        same(ranged(0x60FF, 3, -5, 7), new.range(-5, 7));
        same(scaled(0x60FF, 3, 2, 9), new.scale(2, 9));
        same(ranged_scaled(0x60FF, 3, -5, 7, 2, 9), new.range(-5, 7).scale(2, 9));
        let plain: Object<u8, Rw, Rx, Raw> = object(1, 2);
        assert_eq!((plain.min(), plain.max()), (None, None));
    }

    #[test]
    fn entries_are_what_their_builders_make() {
        let (at, name) = (Address::new(0x6081, 1), "speed");
        let new = ObjectDesc::new(at, INTEGER16, RW, RX_TX, name);
        assert_eq!(entry(0x6081, 1, INTEGER16, RW, RX_TX, name, NO_UNIT), new);
        assert_eq!(entry(0x6081, 1, INTEGER16, RW, RX_TX, name, 4), new.unit(4));
        let made = preset(0x6081, 1, INTEGER16, RW, RX_TX, name, 4, -1);
        assert_eq!(made, new.unit(4).default_int(-1));
        assert_eq!(limited(0x6081, 1, INTEGER16, RW, RX_TX, name, NO_UNIT, -5, 7), new.range(-5, 7));
        let made = full(0x6081, 1, INTEGER16, RW, RX_TX, name, 0, -5, 7, 6);
        assert_eq!(made, new.unit(0).range(-5, 7).default_int(6));
    }
}
