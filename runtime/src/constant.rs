//! Constants that a handle has checked before anything runs.

use crate::access::Writable;
use crate::object::{ConvertError, Is, Object};
use crate::wire::{I24, I40, I48, I56, U24, U40, U48, U56};

/// A constant value for a handle, checked against its limits and its list of values when it is compiled, and shown by
/// `cargo check`.
///
/// The value is a raw value of the type of the object, or a physical value in `physical(...)`, which must be a whole
/// number of counts of an integer primitive.
///
/// ```
/// use drivewright_runtime::prelude::*;
///
/// const PROFILE_VELOCITY: Object<u32, Rw, RxTx, Velocity> =
///     Object::new(0x6081, 0).range(0, 60_000).scale(1, 10);
///
/// constant! {
///     /// Slow enough to walk beside it.
///     pub const CREEP: u32 = PROFILE_VELOCITY => 250;
///     /// As fast as the machine goes.
///     pub const CRUISE: u32 = PROFILE_VELOCITY => physical(Value::rpm(3_000));
/// }
///
/// assert_eq!((CREEP, CRUISE), (250, 30_000));
/// ```
///
/// Named values are checked as well:
///
/// ```
/// use drivewright_runtime::prelude::*;
///
/// wire_enum! {
///     /// What the drive does on a quick stop.
///     pub struct QuickStop(i16) = "quick stop" {
///         /// Slows down.
///         SLOW_DOWN = 1 => "slow down",
///     }
/// }
/// const QUICK_STOP: Object<QuickStop, Rw, Unmapped, Raw> = Object::new(0x605A, 0).allow(&[0, 1, 5]);
///
/// constant! {
///     /// As the application needs it.
///     pub const STOP: QuickStop = QUICK_STOP => QuickStop::SLOW_DOWN;
/// }
/// ```
#[macro_export]
macro_rules! constant {
    () => {};
    ($(#[$meta:meta])* $vis:vis const $name:ident: $ty:ty = $object:expr => physical($value:expr); $($rest:tt)*) => {
        $(#[$meta])*
        // The assertion below compares the result with what was cast.
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        $vis const $name: $ty = $crate::constant::count($object.exact_count($value)) as $ty;
        const _: () = assert!(
            $object.exact_count($value).is_ok(),
            concat!("constant `", stringify!($name), "` is not a whole number of counts of its object"),
        );
        $crate::__constant_fits!($name: $ty, $object, $crate::constant::count($object.exact_count($value)));
        $crate::constant! { $($rest)* }
    };
    ($(#[$meta:meta])* $vis:vis const $name:ident: $ty:ty = $object:expr => $value:expr; $($rest:tt)*) => {
        $(#[$meta])*
        $vis const $name: $ty = $value;
        $crate::__constant_fits!($name: $ty, $object);
        $crate::constant! { $($rest)* }
    };
}

/// The assertions of one constant: of its object's type, within the type, within the limits, and listed.
#[doc(hidden)]
#[macro_export]
macro_rules! __constant_fits {
    ($name:ident: $ty:ty, $object:expr $(, $count:expr)?) => {
        const _: () = $crate::constant::is_of($crate::object::is::<$ty>(), $object);
        const _: () = {
            enum TheConstant {}
            impl $crate::constant::Holds for TheConstant {
                type Value = $ty;
                const VALUE: $ty = $name;
            }
            const COUNT: i128 = <$ty as $crate::constant::Whole<TheConstant>>::COUNT;
            assert!(
                true $(&& $count == COUNT)? && $object.in_range(COUNT),
                concat!("constant `", stringify!($name), "` is outside the range that the drive accepts"),
            );
            assert!(
                $object.in_list(COUNT),
                concat!("constant `", stringify!($name), "` is not one of the values that the drive accepts"),
            );
        };
    };
}

/// Compiles only if the handle is for this type.
#[doc(hidden)]
pub const fn is_of<T, A: Writable, M, Q>(_: Is<T>, object: Object<T, A, M, Q>) {
    let _ = object;
}

/// A constant as a type.
#[doc(hidden)]
pub trait Holds {
    /// Its type.
    type Value;
    /// The constant.
    const VALUE: Self::Value;
}

/// A type whose constants are whole numbers that are known when they are compiled.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no whole number, so its constants cannot be checked",
    label = "this object holds text, bytes or floating point",
    note = "write the constant without `constant!`"
)]
pub trait Whole<H> {
    /// The number of the constant.
    const COUNT: i128;
}

macro_rules! whole {
    ($($ty:ty)*) => {$(
        impl<H: Holds<Value = $ty>> Whole<H> for $ty {
            const COUNT: i128 = H::VALUE as i128;
        }
    )*};
}

whole! { bool u8 u16 u32 u64 i8 i16 i32 i64 }

macro_rules! odd {
    ($($ty:ident)*) => {$(
        impl<H: Holds<Value = $ty>> Whole<H> for $ty {
            const COUNT: i128 = H::VALUE.get() as i128;
        }
    )*};
}

odd! { U24 U40 U48 U56 I24 I40 I48 I56 }

/// The count, or 0 where there is none: the assertion beside it has the word.
#[doc(hidden)]
pub const fn count(result: Result<i128, ConvertError>) -> i128 {
    match result {
        Ok(count) => count,
        Err(_) => 0,
    }
}

#[cfg(test)]
mod tests {
    use crate::prelude::*;

    const SPEED: Object<i16, Rw, RxTx, Velocity> = Object::new(0x60FF, 0).range(-30_000, 30_000).scale(1, 10);

    const PROBE: Object<I24, Rw, Rx, Raw> = Object::new(0x2000, 0).allow(&[-1]);
    const MODE: Object<Mode, Rw, Rx, Raw> = Object::new(0x6060, 0).range(1, 3).allow(&[1, 3]);
    const CONTROL: Object<Control, Rw, Rx, Raw> = Object::new(0x6040, 0).range(0, 0xFFFF);

    crate::wire_enum! {
        struct Mode(i8) = "mode" {
            VELOCITY = 3 => "velocity",
        }
    }
    crate::bit_field! {
        struct Control(u16) {
            ENABLE: 3,
        }
    }

    crate::constant! {
        const BACK: i16 = SPEED => -30_000;
        const FORTH: i16 = SPEED => physical(Value::rpm(3_000));
        const NOTHING: I24 = PROBE => match I24::new(-1) { Some(n) => n, None => I24::MAX };
        const TURN: Mode = MODE => Mode::VELOCITY;
        const ENABLED: Control = CONTROL => Control(0).with(Control::ENABLE, true);
    }

    #[test]
    fn constants_are_plain_numbers() {
        assert_eq!((BACK, FORTH), (-30_000, 30_000));
    }

    #[test]
    fn constants_keep_the_type_of_their_object() {
        assert_eq!((NOTHING.get(), TURN, ENABLED), (-1, Mode(3), Control(8)));
    }
}
