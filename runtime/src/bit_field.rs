//! Named bits of a number.

use core::fmt;
use core::marker::PhantomData;

use crate::wire_enum::Newtype;

/// Some bits of `W`: where they are and, in the type, how many.
pub struct Bits<W, const WIDTH: u8> {
    shift: u8,
    word: PhantomData<fn() -> W>,
}

impl<W, const WIDTH: u8> Bits<W, WIDTH> {
    /// `WIDTH` bits from bit `shift` up.
    pub const fn new(shift: u8) -> Self {
        Self { shift, word: PhantomData }
    }

    /// The lowest bit.
    pub const fn shift(self) -> u8 {
        self.shift
    }

    /// How many bits.
    pub const fn width(self) -> u8 {
        WIDTH
    }

    /// The bits in place, as a mask.
    pub const fn mask(self) -> u64 {
        let ones = match u64::MAX.checked_shr(64_u32.saturating_sub(WIDTH as u32)) {
            Some(ones) => ones,
            None => 0,
        };
        match ones.checked_shl(self.shift as u32) {
            Some(mask) => mask,
            None => 0,
        }
    }
}

impl<W, const WIDTH: u8> Clone for Bits<W, WIDTH> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<W, const WIDTH: u8> Copy for Bits<W, WIDTH> {}

impl<W, const WIDTH: u8> fmt::Debug for Bits<W, WIDTH> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Bits({}..{})", self.shift, self.shift.saturating_add(WIDTH))
    }
}

/// More than the bits of a field can hold.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct FieldError {
    /// The value.
    pub value: u64,
    /// How many bits the field has.
    pub width: u8,
}

impl fmt::Display for FieldError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} does not fit a field of {} bits", self.value, self.width)
    }
}

impl core::error::Error for FieldError {}

/// A row of a table of named bits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct BitDesc<'m> {
    bit: u8,
    width: u8,
    mode: Option<i8>,
    name: &'m str,
}

impl<'m> BitDesc<'m> {
    /// `width` bits from bit `bit` up, in every mode, with a name in words.
    pub const fn new(bit: u8, width: u8, name: &'m str) -> Self {
        Self { bit, width, mode: None, name }
    }

    /// With this meaning only in one mode of operation (6060h).
    #[must_use]
    pub const fn in_mode(mut self, mode: i8) -> Self {
        self.mode = Some(mode);
        self
    }

    /// The lowest bit.
    pub const fn bit(&self) -> u8 {
        self.bit
    }

    /// How many bits.
    pub const fn width(&self) -> u8 {
        self.width
    }

    /// The mode of operation in which the bits have this meaning; `None`: in every mode.
    pub const fn mode(&self) -> Option<i8> {
        self.mode
    }

    /// The name, in words.
    pub const fn name(&self) -> &'m str {
        self.name
    }

    /// The bits of `word`, moved down to bit 0.
    pub const fn of(&self, word: u64) -> u64 {
        let ones = match u64::MAX.checked_shr(64_u32.saturating_sub(self.width as u32)) {
            Some(ones) => ones,
            None => 0,
        };
        match word.checked_shr(self.bit as u32) {
            Some(moved) => moved & ones,
            None => 0,
        }
    }
}

/// A table of named bits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct BitFieldDesc<'m> {
    name: &'m str,
    bits: &'m [BitDesc<'m>],
}

impl<'m> BitFieldDesc<'m> {
    /// A table and its name, in words.
    pub const fn new(name: &'m str, bits: &'m [BitDesc<'m>]) -> Self {
        Self { name, bits }
    }

    /// Its name, in words.
    pub const fn name(&self) -> &'m str {
        self.name
    }

    /// The rows, in the order of the profile.
    pub const fn bits(&self) -> &'m [BitDesc<'m>] {
        self.bits
    }

    /// The rows that have a meaning in `mode`.
    pub fn bits_in(&self, mode: i8) -> impl Iterator<Item = &'m BitDesc<'m>> {
        self.bits.iter().filter(move |b| b.mode.unwrap_or(mode) == mode)
    }
}

/// `Debug` of every `bit_field!`: the type and its number in hexadecimal.
#[doc(hidden)]
pub fn debug<N: Newtype>(f: &mut fmt::Formatter<'_>, name: &str, value: N) -> fmt::Result
where
    N::Repr: fmt::UpperHex,
{
    write!(f, "{name}({:#X})", value.repr())
}

/// A type for a number whose bits have names: a newtype with one constant a bit or a group of bits.
///
/// A single bit is read by `is` and written by `with`, a group by `get` and `set`. Setting keeps all other bits, known or
/// not. The representation is an unsigned primitive.
///
/// ```
/// use drivewright_runtime::prelude::*;
///
/// bit_field! {
///     /// Controlword.
///     pub struct Controlword(u16) {
///         /// Switch on.
///         SWITCH_ON: 0,
///         /// Quick stop; 0 requests it.
///         QUICK_STOP: 2,
///         /// Three bits whose meaning depends on the mode.
///         MODE_SPECIFIC: 4..=6,
///     }
/// }
///
/// let word = Controlword(0x000F);
/// assert!(word.is(Controlword::SWITCH_ON));
/// assert_eq!(word.with(Controlword::QUICK_STOP, false), Controlword(0x000B));
/// assert_eq!(word.set(Controlword::MODE_SPECIFIC, 0b101)?, Controlword(0x005F));
/// assert_eq!(Controlword(0x0020).get(Controlword::MODE_SPECIFIC), 2);
/// assert!(word.set(Controlword::MODE_SPECIFIC, 8).is_err());
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[macro_export]
macro_rules! bit_field {
    (
        $(#[$meta:meta])*
        $vis:vis struct $name:ident($repr:ty) {
            $($(#[$bit_meta:meta])* $bit_name:ident: $low:literal $(..= $high:literal)?),* $(,)?
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, PartialEq, Eq)]
        #[repr(transparent)]
        $vis struct $name(
            /// The number.
            $vis $repr,
        );

        #[allow(dead_code, clippy::cast_possible_truncation, clippy::cast_lossless, clippy::unnecessary_cast)]
        impl $name {
            $(
                $(#[$bit_meta])*
                $vis const $bit_name: $crate::bit_field::Bits<Self, { 1 $(+ $high - $low)? }> =
                    $crate::bit_field::Bits::new($low);
            )*

            /// Whether the bit is 1.
            #[inline]
            $vis const fn is(self, bit: $crate::bit_field::Bits<Self, 1>) -> bool {
                self.0 & bit.mask() as $repr != 0
            }

            /// This word with one bit changed.
            #[inline]
            #[must_use]
            $vis const fn with(self, bit: $crate::bit_field::Bits<Self, 1>, on: bool) -> Self {
                let mask = bit.mask() as $repr;
                Self(if on { self.0 | mask } else { self.0 & !mask })
            }

            /// The bits, moved down to bit 0.
            #[inline]
            $vis const fn get<const WIDTH: u8>(self, bits: $crate::bit_field::Bits<Self, WIDTH>) -> $repr {
                $crate::bit_field::get(self.0 as u64, bits) as $repr
            }

            /// This word with a group of bits changed; an error if `value` has more bits than the group.
            #[inline]
            $vis const fn set<const WIDTH: u8>(
                self,
                bits: $crate::bit_field::Bits<Self, WIDTH>,
                value: $repr,
            ) -> ::core::result::Result<Self, $crate::bit_field::FieldError> {
                match $crate::bit_field::set(self.0 as u64, bits, value as u64) {
                    ::core::result::Result::Ok(word) => ::core::result::Result::Ok(Self(word as $repr)),
                    ::core::result::Result::Err(error) => ::core::result::Result::Err(error),
                }
            }
        }

        impl $crate::wire_enum::Newtype for $name {
            type Repr = $repr;

            #[inline]
            fn from_repr(repr: $repr) -> Self {
                Self(repr)
            }

            #[inline]
            fn repr(self) -> $repr {
                self.0
            }
        }

        impl ::core::fmt::Debug for $name {
            #[inline]
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::bit_field::debug(f, stringify!($name), *self)
            }
        }

        // An item, not a block in a function: it is evaluated by `cargo check` too.
        const _: () = assert!(
            true $(&& $crate::bit_field::fits($name::$bit_name, <$repr>::BITS))*,
            concat!("bit field `", stringify!($name), "` names a bit that its number does not have"),
        );

        impl<H: $crate::constant::Holds<Value = $name>> $crate::constant::Whole<H> for $name {
            #[allow(clippy::cast_lossless)]
            const COUNT: i128 = H::VALUE.0 as i128;
        }

        $crate::__serde!($name);
        $crate::__defmt!($name);
    };
}

/// Whether the bits are some of the lowest `bits`.
#[doc(hidden)]
pub const fn fits<W, const WIDTH: u8>(field: Bits<W, WIDTH>, bits: u32) -> bool {
    WIDTH > 0 && field.shift as u32 + WIDTH as u32 <= bits
}

/// The bits of `word`, moved down to bit 0.
#[doc(hidden)]
#[inline]
pub const fn get<W, const WIDTH: u8>(word: u64, bits: Bits<W, WIDTH>) -> u64 {
    match (word & bits.mask()).checked_shr(bits.shift as u32) {
        Some(value) => value,
        None => 0,
    }
}

/// `word` with the bits changed to `value`.
#[doc(hidden)]
#[inline]
pub const fn set<W, const WIDTH: u8>(word: u64, bits: Bits<W, WIDTH>, value: u64) -> Result<u64, FieldError> {
    let moved = match value.checked_shl(bits.shift as u32) {
        Some(moved) => moved,
        None => 0,
    };
    if get(moved, bits) == value {
        Ok(word & !bits.mask() | moved)
    } else {
        Err(FieldError { value, width: WIDTH })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::format;

    crate::bit_field! {
        /// Sixteen bits.
        struct Word(u16) {
            /// Lowest.
            LOW: 0,
            /// Highest.
            HIGH: 15,
            /// Middle.
            MIDDLE: 4..=6,
            /// All.
            ALL: 0..=15,
        }
    }

    crate::bit_field! {
        /// As wide as it gets.
        struct Wide(u64) {
            /// All.
            ALL: 0..=63,
            /// Highest.
            HIGH: 63,
        }
    }

    #[test]
    fn bits_of_every_word() {
        for raw in 0..=u16::MAX {
            let word = Word(raw);
            assert_eq!(word.is(Word::LOW), raw & 1 != 0);
            assert_eq!(word.is(Word::HIGH), raw & 0x8000 != 0);
            assert_eq!(word.get(Word::MIDDLE), raw >> 4 & 7);
            assert_eq!(word.get(Word::ALL), raw);
            assert_eq!(word.with(Word::HIGH, true).0, raw | 0x8000);
            assert_eq!(word.with(Word::LOW, false).0, raw & 0xFFFE);
            assert_eq!(word.set(Word::MIDDLE, 2).unwrap().0, raw & 0xFF8F | 0x20);
        }
    }

    #[test]
    fn groups_refuse_more_than_they_hold() {
        assert_eq!(Word(0).set(Word::MIDDLE, 8), Err(FieldError { value: 8, width: 3 }));
        assert_eq!(Word(0).set(Word::ALL, u16::MAX), Ok(Word(u16::MAX)));
        assert_eq!(Wide(5).set(Wide::ALL, u64::MAX), Ok(Wide(u64::MAX)));
        assert!(Wide(1 << 63).is(Wide::HIGH));
        assert!(set(0, Bits::<(), 2>::new(63), 2).is_err());
        assert_eq!(Bits::<(), 0>::new(0).mask(), 0);
        assert_eq!(Bits::<(), 200>::new(200).mask(), 0);
    }

    #[test]
    fn rows_read_bits_and_know_their_mode() {
        let table = [BitDesc::new(0, 1, "switch on"), BitDesc::new(4, 1, "new set-point").in_mode(1)];
        let table = BitFieldDesc::new("controlword", &table);
        assert_eq!(table.bits_in(1).count(), 2);
        assert_eq!(table.bits_in(6).count(), 1);
        assert_eq!(BitDesc::new(4, 3, "x").of(0x7F), 7);
        assert_eq!(BitDesc::new(200, 3, "x").of(0x7F), 0);
        assert_eq!(BitDesc::new(0, 200, "x").of(0x7F), 0x7F);
    }

    #[test]
    fn shown_in_hexadecimal() {
        assert_eq!(format!("{:?}", Word(0x1288)), "Word(0x1288)");
    }
}
