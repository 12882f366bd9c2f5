//! One entry of a mapping object.

use core::fmt;

use crate::address::Address;
use crate::object::Object;
use crate::wire::Wire;

/// An entry of a mapping object (1600h and up, 1A00h and up): what is mapped, and how long it is.
///
/// ```
/// use drivewright_runtime::prelude::*;
///
/// let entry = MapEntry::new(Address::new(0x6040, 0), 16);
/// assert_eq!(entry.word(), 0x6040_0010);
/// assert_eq!(MapEntry::from_word(0x6040_0010), entry);
/// assert_eq!(entry.to_string(), "6040:00 16 bit");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MapEntry {
    address: Address,
    bits: u8,
}

impl MapEntry {
    /// The entry at `address`, `bits` long: 1 to 255, 0 for an entry that holds nothing.
    pub const fn new(address: Address, bits: u8) -> Self {
        Self { address, bits }
    }

    /// The entry of a 32-bit word: index, sub-index, length in bits, from the top.
    #[allow(clippy::cast_possible_truncation)]
    pub const fn from_word(word: u32) -> Self {
        Self { address: Address::new((word >> 16) as u16, (word >> 8) as u8), bits: word as u8 }
    }

    /// The 32-bit word that a mapping object holds.
    pub const fn word(self) -> u32 {
        (self.address.index() as u32) << 16 | (self.address.sub() as u32) << 8 | self.bits as u32
    }

    /// What is mapped.
    pub const fn address(self) -> Address {
        self.address
    }

    /// Its length in bits.
    pub const fn bits(self) -> u8 {
        self.bits
    }

    /// The entry of an object; 0 bits if its length varies, which no layout accepts.
    #[allow(clippy::cast_possible_truncation)]
    pub(crate) const fn of<T: Wire, A, M, Q>(object: Object<T, A, M, Q>) -> Self {
        Self { address: object.address(), bits: T::BITS as u8 }
    }
}

impl fmt::Display for MapEntry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} bit", self.address, self.bits)
    }
}

impl fmt::Debug for MapEntry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
