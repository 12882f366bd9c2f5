//! Constants that a handle has checked before anything runs.

use crate::access::Writable;
use crate::object::{ConvertError, Is, Object};

/// A constant raw value for a handle, checked against its limits when it is compiled, and shown by `cargo check`.
///
/// The value is a raw number, or a physical value in `physical(...)`, which must be a whole number of counts. The type is
/// that of the object: an integer primitive.
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
        $crate::__constant_fits!($name: $ty, $object, $name as i128);
        $crate::constant! { $($rest)* }
    };
}

/// The assertions of one constant: of its object's type, within the type, within the limits.
#[doc(hidden)]
#[macro_export]
macro_rules! __constant_fits {
    ($name:ident: $ty:ty, $object:expr, $count:expr) => {
        const _: () = $crate::constant::is_of($crate::object::is::<$ty>(), $object);
        const _: () = assert!(
            $count == $name as i128 && $object.accepts($count),
            concat!("constant `", stringify!($name), "` is outside the range that the drive accepts"),
        );
    };
}

/// Compiles only if the handle is for this type.
#[doc(hidden)]
pub const fn is_of<T, A: Writable, M, Q>(_: Is<T>, object: Object<T, A, M, Q>) {
    let _ = object;
}

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

    crate::constant! {
        const BACK: i16 = SPEED => -30_000;
        const FORTH: i16 = SPEED => physical(Value::rpm(3_000));
    }

    #[test]
    fn constants_are_plain_numbers() {
        assert_eq!((BACK, FORTH), (-30_000, 30_000));
    }
}
