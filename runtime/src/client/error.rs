//! Why a procedure of the client has no result.

use core::fmt;

use crate::address::Address;
use crate::client::axis::AxisError;
use crate::client::image::ImageError;
use crate::client::message::{Explain, Lines, Report};
use crate::client::object::AccessError;
use crate::object::RangeError;
use crate::quantity::QuantityKind;

/// Why a procedure of the client has no result.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum ClientError {
    /// The axis did not come to where it was to come.
    Axis(AxisError),
    /// A read or a write of an entry failed.
    Access(AccessError),
    /// Process data are not what they should be.
    Image(ImageError),
    /// A value has the wrong unit for the entry.
    Unit {
        /// The entry.
        address: Address,
        /// What the entry measures; `None` where the profile does not say.
        entry: Option<QuantityKind>,
        /// What was given.
        given: QuantityKind,
    },
    /// A value is outside what the entry takes.
    Range(RangeError),
    /// No scale for user units has been set.
    NoScale,
    /// No alarm with the error code of the drive can be reset.
    NotResettable {
        /// 603Fh.
        code: u16,
    },
    /// Not a homing method of this drive. 0 is none: not to home is up to the program.
    NotAHomingMethod {
        /// The number.
        method: i8,
    },
}

impl ClientError {
    /// The error that says more; `None` if this is all.
    fn inner(&self) -> Option<&dyn Explain> {
        match self {
            Self::Axis(error) => Some(error),
            Self::Access(error) => Some(error),
            _ => None,
        }
    }
}

impl Explain for ClientError {
    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Axis(error) => return error.code(f),
            Self::Access(error) => return error.code(f),
            Self::Image(_) => "LAYOUT",
            Self::Unit { .. } | Self::NoScale => "UNIT",
            Self::Range(_) => "RANGE",
            Self::NotResettable { .. } => "RESET",
            Self::NotAHomingMethod { .. } => "HOMING",
        })
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Axis(error) => error.what(f),
            Self::Access(error) => error.what(f),
            Self::Image(error) => write!(f, "{error}"),
            Self::Range(error) => write!(f, "{error}"),
            Self::Unit { address, entry: Some(entry), given } => {
                write!(f, "{address} measures {}, not {}", entry.name(), given.name())
            }
            Self::Unit { address, entry: None, given } => {
                write!(
                    f,
                    "the profile states no unit for {address}, so that {} cannot be written",
                    given.name()
                )
            }
            Self::NoScale => f.write_str("user units need the scale of the drive, and none has been set"),
            Self::NotResettable { code } => {
                write!(f, "no alarm with the error code {code:04X}h can be reset")
            }
            Self::NotAHomingMethod { method } => write!(f, "the drive has no homing method {method}"),
        }
    }

    fn details(&self, lines: &mut Lines<'_, '_>) -> fmt::Result {
        self.inner().map_or(Ok(()), |inner| inner.details(lines))
    }

    fn why(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotAHomingMethod { method: 0 } => {
                f.write_str("not to home is up to the program, it is no method")
            }
            _ => self.inner().map_or(Ok(()), |inner| inner.why(f)),
        }
    }

    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Axis(error) => return error.remedy(f),
            Self::Access(error) => return error.remedy(f),
            Self::Image(_) => "read the layout back and compare it, then use the one that the drive has",
            Self::Unit { .. } => "give the value in this unit, or as a raw count",
            Self::NoScale => "read the gear objects of the drive and set a scale, or give raw counts",
            Self::Range(_) => "give a value that the entry takes",
            Self::NotResettable { .. } => "remove the cause, then switch the control supply off and on",
            Self::NotAHomingMethod { .. } => "take a method of the drive",
        })
    }
}

impl fmt::Display for ClientError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&Report::new(self), f)
    }
}

impl core::error::Error for ClientError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Axis(error) => Some(error),
            Self::Access(error) => Some(error),
            Self::Image(error) => Some(error),
            Self::Range(error) => Some(error),
            _ => None,
        }
    }
}

impl From<AxisError> for ClientError {
    fn from(error: AxisError) -> Self {
        Self::Axis(error)
    }
}

impl From<AccessError> for ClientError {
    fn from(error: AccessError) -> Self {
        Self::Access(error)
    }
}

impl From<ImageError> for ClientError {
    fn from(error: ImageError) -> Self {
        Self::Image(error)
    }
}

impl From<RangeError> for ClientError {
    fn from(error: RangeError) -> Self {
        Self::Range(error)
    }
}

/// Why a call of a drive has no result. `E` is the error of the bus.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DriveError<E> {
    /// The drive, or what was asked of it.
    Client(ClientError),
    /// The bus failed.
    Link(E),
}

impl<E: fmt::Display> fmt::Display for DriveError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Client(error) => error.fmt(f),
            Self::Link(error) => write!(f, "the bus failed: {error}"),
        }
    }
}

impl<E: core::error::Error + 'static> core::error::Error for DriveError<E> {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Client(error) => Some(error),
            Self::Link(error) => Some(error),
        }
    }
}

impl<E> From<ClientError> for DriveError<E> {
    fn from(error: ClientError) -> Self {
        Self::Client(error)
    }
}
