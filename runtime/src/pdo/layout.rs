//! The macro that makes a layout, and the small functions that it expands to.

use super::MapEntry;
use crate::address::Address;
use crate::mapping::Direction;
use crate::wire::{Fixed, WireError};

/// A layout of process data, for code that works with any of them.
pub trait ProcessData: Sized {
    /// Direction, seen from the drive.
    const DIRECTION: Direction;
    /// What is mapped, in order.
    const MAPPING: &'static [MapEntry];
    /// Length in bytes.
    const BYTES: usize;

    /// Writes the values to the start of `out`; returns how many bytes.
    ///
    /// # Errors
    /// [`WireError::Space`] when `out` is too short.
    fn pack_into(&self, out: &mut [u8]) -> Result<usize, WireError>;

    /// Reads the values from all of `bytes`.
    ///
    /// # Errors
    /// [`WireError::Length`] unless there are exactly [`BYTES`](Self::BYTES).
    fn unpack_from(bytes: &[u8]) -> Result<Self, WireError>;
}

/// Length of the mapped entries in bytes.
#[doc(hidden)]
pub const fn byte_len(mapping: &[MapEntry]) -> usize {
    let (mut bits, mut i) = (0, 0);
    while i < mapping.len() {
        bits += mapping[i].bits() as usize;
        i += 1;
    }
    bits.div_ceil(8)
}

/// Whether every entry is one or more whole bytes.
#[doc(hidden)]
pub const fn bytes_are_whole(mapping: &[MapEntry]) -> bool {
    let mut i = 0;
    while i < mapping.len() {
        let bits = mapping[i].bits();
        if bits == 0 || bits % 8 != 0 {
            return false;
        }
        i += 1;
    }
    true
}

/// Byte offset of every entry.
#[doc(hidden)]
pub const fn offsets<const N: usize>(mapping: &[MapEntry; N]) -> [usize; N] {
    let (mut out, mut at, mut i) = ([0; N], 0, 0);
    while i < N {
        out[i] = at;
        at += mapping[i].bits() as usize / 8;
        i += 1;
    }
    out
}

/// Byte offset of the first entry at `address`.
#[doc(hidden)]
pub const fn offset_of(mapping: &[MapEntry], address: Address) -> Option<usize> {
    let (mut at, mut i) = (0, 0);
    while i < mapping.len() {
        let entry = mapping[i];
        if entry.address().index() == address.index() && entry.address().sub() == address.sub() {
            return Some(at);
        }
        at += entry.bits() as usize / 8;
        i += 1;
    }
    None
}

/// Writes `value` at `at`; returns where the next one goes. The layout's assertions keep it inside of `out`.
#[doc(hidden)]
#[inline]
pub fn put<T: Fixed>(out: &mut [u8], at: usize, value: T) -> usize {
    let bytes = value.to_bytes();
    let bytes = bytes.as_ref();
    let end = at + bytes.len();
    if let Some(place) = out.get_mut(at..end) {
        place.copy_from_slice(bytes);
    }
    end
}

/// Reads the value at `at` and moves `at` behind it. The layout's assertions keep it inside of `frame`.
#[doc(hidden)]
#[inline]
pub fn take<T: Fixed>(frame: &[u8], at: &mut usize) -> T {
    let start = *at;
    *at += T::BITS as usize / 8;
    let bytes = frame.get(start..*at).and_then(|b| T::Bytes::try_from(b).ok());
    T::from_bytes(bytes.unwrap_or_default())
}

/// A layout of process data: a struct with one field an entry, in the order of the mapping.
///
/// The direction is `Rx` or `Tx`, seen from the drive. `entries <=` and `bytes <=` are what the drive can hold; leave out
/// what the manual does not state. An entry that cannot be mapped in this direction, a field of another type than its
/// object, an entry that is not whole bytes, and a layout over its limits do not compile, and show under `cargo check`.
///
/// ```
/// use drivewright_runtime::prelude::*;
///
/// const CONTROLWORD: Object<u16, Rw, Rx, Raw> = Object::new(0x6040, 0);
/// const TARGET_POSITION: Object<i32, Rw, Rx, UserPosition> = Object::new(0x607A, 0).range(-1_000, 1_000);
///
/// pdo_layout! {
///     /// What the drive receives.
///     pub struct Command: Rx, entries <= 4, bytes <= 8 {
///         /// Controlword.
///         controlword: u16 = CONTROLWORD,
///         /// Target position in user units.
///         target_position: i32 = TARGET_POSITION,
///     }
/// }
///
/// assert_eq!(Command::MAPPING.map(|e| e.word()), [0x6040_0010, 0x607A_0020]);
/// assert_eq!((Command::ENTRIES, Command::BYTES, Command::OFFSETS), (2, 6, [0, 2]));
/// assert_eq!(Command::offset_of(TARGET_POSITION.address()), Some(2));
///
/// let command = Command { controlword: 0x000F, target_position: -2 };
/// let frame: [u8; 6] = command.pack();
/// assert_eq!(frame, [0x0F, 0, 0xFE, 0xFF, 0xFF, 0xFF]);
/// assert_eq!(Command::unpack(&frame).target_position, -2);
/// assert!(Command { target_position: 1_001, ..command }.checked_pack().is_err());
/// ```
#[macro_export]
macro_rules! pdo_layout {
    (
        $(#[$meta:meta])*
        $vis:vis struct $name:ident: $direction:ident
            $(, entries <= $entries:literal)? $(, bytes <= $bytes:literal)?
        {
            $($(#[$field_meta:meta])* $field:ident: $ty:ty = $object:expr),* $(,)?
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, PartialEq, Debug)]
        $vis struct $name {
            $($(#[$field_meta])* $vis $field: $ty,)*
        }

        #[allow(dead_code)]
        impl $name {
            /// How many entries are mapped.
            $vis const ENTRIES: usize = <[&str]>::len(&[$(stringify!($field)),*]);
            /// What is mapped, in order.
            $vis const MAPPING: [$crate::pdo::MapEntry; Self::ENTRIES] =
                [$($crate::mapping::$direction::entry($crate::object::is::<$ty>(), $object)),*];
            /// Length in bytes.
            $vis const BYTES: usize = $crate::pdo::byte_len(&Self::MAPPING);
            /// Byte offset of every entry.
            $vis const OFFSETS: [usize; Self::ENTRIES] = $crate::pdo::offsets(&Self::MAPPING);

            /// Byte offset of the entry at `address`; `None` if it is not mapped.
            $vis const fn offset_of(address: $crate::Address) -> ::core::option::Option<usize> {
                $crate::pdo::offset_of(&Self::MAPPING, address)
            }

            /// That every value is one that its object accepts: within its limits, and listed where values are listed.
            ///
            /// # Errors
            /// The first one that is not.
            #[inline]
            $vis fn check(&self) -> ::core::result::Result<(), $crate::RangeError> {
                $($object.check(self.$field)?;)*
                ::core::result::Result::Ok(())
            }

            /// The bytes of the frame. Limits are not looked at: see `checked_pack`.
            #[inline]
            $vis fn pack(&self) -> [u8; Self::BYTES] {
                let out = &mut [0; Self::BYTES];
                let at = 0;
                $(let at = $crate::pdo::put(out, at, self.$field);)*
                let _ = at;
                *out
            }

            /// The bytes of the frame, if every value is one that its object accepts.
            ///
            /// # Errors
            /// The first value that is not.
            #[inline]
            $vis fn checked_pack(&self) -> ::core::result::Result<[u8; Self::BYTES], $crate::RangeError> {
                self.check()?;
                ::core::result::Result::Ok(self.pack())
            }

            /// The values of a frame.
            #[inline]
            $vis fn unpack(frame: &[u8; Self::BYTES]) -> Self {
                let (frame, at) = (frame as &[u8], &mut 0);
                let _ = (frame, &at);
                Self { $($field: $crate::pdo::take(frame, at)),* }
            }
        }

        impl $crate::pdo::ProcessData for $name {
            const DIRECTION: $crate::mapping::Direction = $crate::mapping::$direction::DIRECTION;
            const MAPPING: &'static [$crate::pdo::MapEntry] = &$name::MAPPING;
            const BYTES: usize = $name::BYTES;

            fn pack_into(&self, out: &mut [u8]) -> ::core::result::Result<usize, $crate::WireError> {
                $crate::wire::put(out, &self.pack())
            }

            fn unpack_from(bytes: &[u8]) -> ::core::result::Result<Self, $crate::WireError> {
                $crate::wire::exactly(bytes).map(Self::unpack)
            }
        }

        // Items, not blocks in a function: these are evaluated by `cargo check` too.
        const _: () = assert!(
            $crate::pdo::bytes_are_whole(&$name::MAPPING),
            concat!("PDO layout `", stringify!($name), "`: every entry must have a fixed length of whole bytes"),
        );
        $(const _: () = assert!(
            $name::ENTRIES <= $entries,
            concat!("PDO layout `", stringify!($name), "` has more entries than the ", $entries, " that the drive can map"),
        );)?
        $(const _: () = assert!(
            $name::BYTES <= $bytes,
            concat!("PDO layout `", stringify!($name), "` is longer than the ", $bytes, " bytes that the drive can map"),
        );)?
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prelude::*;

    const STATUSWORD: Object<u16, Ro, Tx, Raw> = Object::new(0x6041, 0);
    const POSITION: Object<i32, Ro, Tx, UserPosition> = Object::new(0x6064, 0);
    const TORQUE: Object<i16, Ro, RxTx, TorqueRatio> = Object::new(0x6077, 0).scale(1, 1_000);
    const MODE: Object<i8, Ro, Tx, Raw> = Object::new(0x6061, 0).range(-1, 10);
    const PROBE: Object<I24, Ro, Tx, Raw> = Object::new(0x2000, 3);

    crate::pdo_layout! {
        /// Every width.
        struct Report: Tx, entries <= 5, bytes <= 12 {
            statusword: u16 = STATUSWORD,
            position: i32 = POSITION,
            torque: i16 = TORQUE,
            mode: i8 = MODE,
            probe: I24 = PROBE,
        }
    }

    crate::pdo_layout! {
        /// As the manual states no limits.
        struct Empty: Rx {}
    }

    #[test]
    fn offsets_follow_the_widths() {
        assert_eq!(Report::OFFSETS, [0, 2, 6, 8, 9]);
        assert_eq!(Report::BYTES, 12);
        assert_eq!(Report::offset_of(MODE.address()), Some(8));
        assert_eq!(Report::offset_of(Address::new(0x6041, 1)), None);
        assert_eq!((Empty::BYTES, Empty::ENTRIES), (0, 0));
        assert_eq!(Empty::unpack(&Empty {}.pack()), Empty {});
    }

    #[test]
    fn frames_round_trip() {
        let report = Report { statusword: 0x1237, position: i32::MIN, torque: -1, mode: -1, probe: I24::MIN };
        let frame = report.checked_pack().unwrap();
        assert_eq!(frame, [0x37, 0x12, 0, 0, 0, 0x80, 0xFF, 0xFF, 0xFF, 0, 0, 0x80]);
        assert_eq!(Report::unpack(&frame), report);
        assert_eq!(Report { mode: 11, ..report }.checked_pack().map_err(|e| e.address), Err(MODE.address()));
    }

    #[test]
    fn slices_have_the_exact_length() {
        assert_eq!(Report::unpack_from(&[0; 11]), Err(WireError::Length { expected: 12, found: 11 }));
        assert_eq!(Report::unpack_from(&[0; 13]), Err(WireError::Length { expected: 12, found: 13 }));
        let report = Report::unpack_from(&[1; 12]).unwrap();
        assert_eq!(report.pack_into(&mut [0; 11]), Err(WireError::Space { needed: 12, space: 11 }));
        assert_eq!(report.pack_into(&mut [0; 64]), Ok(12));
        assert_eq!(<Report as ProcessData>::DIRECTION, Direction::Tx);
        assert_eq!(<Report as ProcessData>::MAPPING, Report::MAPPING);
    }
}
