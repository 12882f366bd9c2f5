//! Which process data may carry an object: as a marker type of a handle, and as a value of a table.
//!
//! Directions are seen from the drive: `Rx` is what it receives, `Tx` is what it sends.

use crate::object::{Is, Object};
use crate::pdo::MapEntry;
use crate::wire::Wire;

pub(crate) mod sealed {
    /// Keeps marker traits to the markers of this crate.
    pub trait Sealed {}
}
use sealed::Sealed;

/// Direction of process data, seen from the drive.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(u8)]
pub enum Direction {
    /// Received by the drive.
    Rx,
    /// Sent by the drive.
    Tx,
}

/// Which process data may carry an object, as a value.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(u8)]
pub enum Mapping {
    /// The manual does not say.
    NotStated,
    /// None.
    Unmapped,
    /// What the drive receives.
    Rx,
    /// What the drive sends.
    Tx,
    /// Both.
    RxTx,
}

impl Mapping {
    /// The word of profiles: `no`, `rx`, `tx` or `rx tx`; `None` where the manual does not say.
    pub const fn word(self) -> Option<&'static str> {
        match self {
            Self::NotStated => None,
            Self::Unmapped => Some("no"),
            Self::Rx => Some("rx"),
            Self::Tx => Some("tx"),
            Self::RxTx => Some("rx tx"),
        }
    }

    /// Whether process data of this direction may carry it; `None` where the manual does not say.
    pub const fn allows(self, direction: Direction) -> Option<bool> {
        match (self, direction) {
            (Self::NotStated, _) => None,
            (Self::RxTx, _) | (Self::Rx, Direction::Rx) | (Self::Tx, Direction::Tx) => Some(true),
            _ => Some(false),
        }
    }
}

macro_rules! markers {
    ($($(#[$doc:meta])* $name:ident = $value:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub enum $name {}
        impl Sealed for $name {}
        impl MappingMarker for $name {
            const MAPPING: Mapping = Mapping::$value;
        }
    )*};
}

markers! {
    /// The manual does not say, so nothing may carry it.
    MapNotStated = NotStated;
    /// No process data may carry it.
    Unmapped = Unmapped;
    /// Process data that the drive receives may carry it.
    Rx = Rx;
    /// Process data that the drive sends may carry it.
    Tx = Tx;
    /// Process data of both directions may carry it.
    RxTx = RxTx;
}

/// A marker for mapping.
pub trait MappingMarker: Sealed + Copy + 'static {
    /// The marker as a value.
    const MAPPING: Mapping;
}

/// Process data that the drive receives may carry this object.
#[diagnostic::on_unimplemented(
    message = "object cannot be mapped into an RxPDO: the drive refuses the entry with abort 0604 0041",
    label = "this object has mapping `{Self}`, so the drive cannot receive it as process data",
    note = "write it over SDO, or correct `pdo` in the profile if the manual says otherwise"
)]
pub trait MapsRx: MappingMarker {}
impl MapsRx for Rx {}
impl MapsRx for RxTx {}

/// Process data that the drive sends may carry this object.
#[diagnostic::on_unimplemented(
    message = "object cannot be mapped into a TxPDO: the drive refuses the entry with abort 0604 0041",
    label = "this object has mapping `{Self}`, so the drive cannot send it as process data",
    note = "read it over SDO, or correct `pdo` in the profile if the manual says otherwise"
)]
pub trait MapsTx: MappingMarker {}
impl MapsTx for Tx {}
impl MapsTx for RxTx {}

// `pdo_layout!` names the direction by its marker and calls these, so that the bound is the one that its user reads. The
// object comes by value and the type of the field as an argument: the compiler then points at the object in the layout.
impl Rx {
    /// The direction as a value.
    pub const DIRECTION: Direction = Direction::Rx;

    /// The mapping entry of an object that the drive may receive.
    pub const fn entry<T: Wire, A, M: MapsRx, Q>(_: Is<T>, object: Object<T, A, M, Q>) -> MapEntry {
        MapEntry::of(object)
    }
}

impl Tx {
    /// The direction as a value.
    pub const DIRECTION: Direction = Direction::Tx;

    /// The mapping entry of an object that the drive may send.
    pub const fn entry<T: Wire, A, M: MapsTx, Q>(_: Is<T>, object: Object<T, A, M, Q>) -> MapEntry {
        MapEntry::of(object)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn silence_allows_and_refuses_nothing() {
        assert_eq!(Mapping::NotStated.allows(Direction::Rx), None);
        assert_eq!(Mapping::Unmapped.allows(Direction::Tx), Some(false));
        assert_eq!(Mapping::RxTx.allows(Direction::Tx), Some(true));
        assert_eq!(Mapping::Rx.allows(Direction::Tx), Some(false));
        assert_eq!(Mapping::Tx.allows(Direction::Tx), Some(true));
    }
}
