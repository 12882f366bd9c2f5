//! Process data as the drive ships.

use crate::address::Address;
use crate::mapping::Direction;
use crate::pdo::MapEntry;

/// What a master may change about the mapping of process data.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Remap {
    /// The manual does not say.
    NotStated,
    /// Nothing: the mapping is fixed.
    Fixed,
    /// Whether it is used, not what it carries.
    Selectable,
    /// What it carries.
    Free,
}

/// Process data: a mapping object with what it carries as the drive ships, and what it can hold.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PdoDesc<'m> {
    address: Address,
    direction: Direction,
    remap: Remap,
    max_entries: Option<u8>,
    max_bytes: Option<u16>,
    entries: &'m [MapEntry],
}

impl<'m> PdoDesc<'m> {
    /// The mapping object at sub-index 0 of `address` (1600h and up, 1A00h and up), with its entries in order.
    pub const fn new(address: Address, direction: Direction, entries: &'m [MapEntry]) -> Self {
        Self { address, direction, remap: Remap::NotStated, max_entries: None, max_bytes: None, entries }
    }

    /// With the most entries that it can hold.
    #[must_use]
    pub const fn with_max_entries(mut self, entries: u8) -> Self {
        self.max_entries = Some(entries);
        self
    }

    /// With the most bytes that it can hold.
    #[must_use]
    pub const fn with_max_bytes(mut self, bytes: u16) -> Self {
        self.max_bytes = Some(bytes);
        self
    }

    /// With what a master may change.
    #[must_use]
    pub const fn with_remap(mut self, remap: Remap) -> Self {
        self.remap = remap;
        self
    }

    /// The mapping object, at sub-index 0.
    pub const fn address(&self) -> Address {
        self.address
    }

    /// Direction, seen from the drive.
    pub const fn direction(&self) -> Direction {
        self.direction
    }

    /// What is mapped as the drive ships, in order.
    pub const fn entries(&self) -> &'m [MapEntry] {
        self.entries
    }

    /// The most entries; `None` where the manual does not state it.
    pub const fn max_entries(&self) -> Option<u8> {
        self.max_entries
    }

    /// The most bytes; `None` where the manual does not state it.
    pub const fn max_bytes(&self) -> Option<u16> {
        self.max_bytes
    }

    /// What a master may change.
    pub const fn remap(&self) -> Remap {
        self.remap
    }

    /// Length as the drive ships, in bits.
    pub fn bits(&self) -> usize {
        self.entries.iter().map(|e| usize::from(e.bits())).sum()
    }
}
