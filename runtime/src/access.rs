//! Who may read and write an object over SDO: as a marker type of a handle, and as a value of a table.

use crate::mapping::sealed::Sealed;

/// SDO access of an object, as a value.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(u8)]
pub enum Access {
    /// Read only.
    Ro,
    /// Read and write.
    Rw,
    /// Write only.
    Wo,
    /// Read only, and never changes.
    Const,
}

impl Access {
    /// The word of profiles and of EDS files: `ro`, `rw`, `wo` or `const`.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Ro => "ro",
            Self::Rw => "rw",
            Self::Wo => "wo",
            Self::Const => "const",
        }
    }

    /// Whether the drive answers a read; otherwise it aborts with 0601 0001.
    pub const fn reads(self) -> bool {
        !matches!(self, Self::Wo)
    }

    /// Whether the drive takes a write; otherwise it aborts with 0601 0002.
    pub const fn writes(self) -> bool {
        matches!(self, Self::Rw | Self::Wo)
    }
}

macro_rules! markers {
    ($($(#[$doc:meta])* $name:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub enum $name {}
        impl Sealed for $name {}
        impl AccessMarker for $name {
            const ACCESS: Access = Access::$name;
        }
    )*};
}

markers! {
    /// Read only.
    Ro;
    /// Read and write.
    Rw;
    /// Write only.
    Wo;
    /// Read only, and never changes.
    Const;
}

/// A marker for SDO access.
pub trait AccessMarker: Sealed + Copy + 'static {
    /// The marker as a value.
    const ACCESS: Access;
}

/// The drive answers a read of this object.
#[diagnostic::on_unimplemented(
    message = "object is write-only: the drive refuses a read with abort 0601 0001",
    label = "this object has access `{Self}` and cannot be read",
    note = "keep the value that was written, or read the object in which the drive reports its effect"
)]
pub trait Readable: AccessMarker {}
impl Readable for Ro {}
impl Readable for Rw {}
impl Readable for Const {}

/// The drive takes a write of this object.
#[diagnostic::on_unimplemented(
    message = "object is read-only: the drive refuses a write with abort 0601 0002",
    label = "this object has access `{Self}` and cannot be written",
    note = "write the object that commands this value, or correct `access` in the profile if the manual says otherwise"
)]
pub trait Writable: AccessMarker {}
impl Writable for Rw {}
impl Writable for Wo {}
