//! Why a read or a write has no result, and what to do about it.

use core::fmt;

use super::Shown;
use crate::abort::AbortCode;
use crate::access::Access;
use crate::address::Address;
use crate::client::message::{displays, Clean, Explain, Lines};
use crate::model::DriveModel;
use crate::object::{EncodeError, RangeError};
use crate::procedure::Answer;
use crate::wire::WireError;

/// What was tried.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum Action {
    /// A read.
    Read,
    /// A write, of this number; `None` for text, bytes and what is beyond 64 bits.
    Write(Option<i64>),
}

impl Action {
    /// A write of this number. Errors are values that are passed around: the number is kept in 64 bits.
    pub(crate) fn write(number: Option<i128>) -> Self {
        Self::Write(number.and_then(|number| i64::try_from(number).ok()))
    }
}

/// Why it has no result.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Cause {
    /// The drive refused it.
    Abort(AbortCode),
    /// No answer came, after all tries.
    NoAnswer,
    /// The answer is longer than there is room for.
    TooLong,
    /// The answer is no value of the type, or the value does not go into it.
    Wire(WireError),
    /// The value is outside the limits; nothing was sent.
    Range(RangeError),
    /// The value is none of those that the manual lists; nothing was sent.
    NotListed,
    /// The access of the entry rules it out; nothing was sent.
    Access(Access),
    /// The profile has no such entry; nothing was sent.
    NotInProfile,
    /// The entry is in the process data that the drive receives: they would overwrite the value; nothing was sent.
    MappedInRxPdo,
}

impl Cause {
    /// What an answer other than the expected one means. One that does not belong to the request is none.
    pub(crate) const fn of(answer: Answer<'_>) -> Self {
        match answer {
            Answer::Abort(code) => Self::Abort(code),
            Answer::TooLong => Self::TooLong,
            _ => Self::NoAnswer,
        }
    }

    /// Whether nothing went to the drive.
    pub const fn before_sending(self) -> bool {
        matches!(
            self,
            Self::Range(_) | Self::NotListed | Self::Access(_) | Self::NotInProfile | Self::MappedInRxPdo
        )
    }

    /// Whether the drive says that it has no such entry.
    pub const fn is_missing(self) -> bool {
        matches!(self, Self::Abort(AbortCode::NO_OBJECT | AbortCode::NO_SUB_INDEX))
    }
}

impl From<EncodeError> for Cause {
    fn from(error: EncodeError) -> Self {
        match error {
            EncodeError::Range(error) => Self::Range(error),
            EncodeError::Wire(error) => Self::Wire(error),
        }
    }
}

/// A read or a write without a result.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct AccessError {
    /// The entry.
    pub address: Address,
    /// What was tried.
    pub action: Action,
    /// Why it failed.
    pub cause: Cause,
}

impl AccessError {
    /// The error with what the model knows: the name of the entry, the value in its unit, what the abort code means for
    /// this drive.
    pub const fn with<'e, 'm>(&'e self, model: &'e DriveModel<'m>) -> Explained<'e, 'm> {
        Explained { error: self, model: Some(model) }
    }

    const fn alone(&self) -> Explained<'_, 'static> {
        Explained { error: self, model: None }
    }
}

/// An [`AccessError`] with what the model knows about it. A [`Report`](crate::client::message::Report) adds the source.
#[derive(Clone, Copy, Debug)]
pub struct Explained<'e, 'm> {
    error: &'e AccessError,
    model: Option<&'e DriveModel<'m>>,
}

impl<'m> Explained<'_, 'm> {
    fn object(&self) -> Option<&'m crate::model::ObjectDesc<'m>> {
        self.model?.object(self.error.address)
    }

    fn subject(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (verb, number) = match self.error.action {
            Action::Read => ("read", None),
            Action::Write(number) => ("write", number),
        };
        write!(f, "{verb} of {}", self.error.address)?;
        if let Some(object) = self.object() {
            write!(f, " \"{}\"", Clean(object.name().as_bytes()))?;
        }
        match (number, self.model, self.object()) {
            (Some(number), Some(model), Some(object)) => {
                write!(f, " = {}", Shown::number(model, object, number.into()))
            }
            (Some(number), ..) => write!(f, " = {number}"),
            _ => Ok(()),
        }
    }

    fn listed(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(" was not sent: the manual lists the values, and this is none of them")?;
        let list = self.object().and_then(|object| self.model?.allowed_of(object)).unwrap_or(&[]);
        let Some((first, others)) = list.split_first() else { return Ok(()) };
        write!(f, " [{first}")?;
        others.iter().try_for_each(|value| write!(f, ", {value}"))?;
        f.write_str("]")
    }
}

impl Explain for Explained<'_, '_> {
    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.error.cause {
            Cause::Abort(AbortCode(code)) => write!(f, "SDO {:04X} {:04X}", code >> 16, code & 0xFFFF),
            Cause::NoAnswer | Cause::TooLong => f.write_str("SDO"),
            Cause::Wire(_) => f.write_str("LENGTH"),
            Cause::Range(_) | Cause::NotListed => f.write_str("RANGE"),
            Cause::Access(_) => f.write_str("ACCESS"),
            Cause::NotInProfile => f.write_str("PROFILE"),
            Cause::MappedInRxPdo => f.write_str("MAPPED"),
        }
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.subject(f)?;
        match self.error.cause {
            Cause::Abort(code) => {
                write!(f, " refused: {}", code.name().unwrap_or("a code that CiA 301 does not list"))
            }
            Cause::NoAnswer => f.write_str(": no answer came, after all tries"),
            Cause::TooLong => f.write_str(": the answer is longer than there is room for"),
            Cause::Wire(error) => write!(f, ": {error}"),
            Cause::Range(error) => write!(f, " was not sent: {error}"),
            Cause::NotListed => self.listed(f),
            Cause::Access(access) => write!(f, " was not sent: the entry is {}", access.word()),
            Cause::NotInProfile => f.write_str(" was not sent: the profile has no such entry"),
            Cause::MappedInRxPdo => f.write_str(" was not sent: the entry is in the RxPDO that is in use"),
        }
    }

    fn details(&self, lines: &mut Lines<'_, '_>) -> fmt::Result {
        let Cause::Abort(code) = self.error.cause else { return Ok(()) };
        match self.model.and_then(|model| model.abort(code)) {
            Some(abort) => lines.line("drive", Clean(abort.name().as_bytes())),
            None => Ok(()),
        }
    }

    fn why(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.error.cause {
            Cause::MappedInRxPdo => f.write_str("process data would overwrite the value in the next cycle"),
            Cause::Wire(WireError::Length { .. }) => {
                f.write_str("the entry of this drive has another type than the profile says")
            }
            _ => Ok(()),
        }
    }

    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.error.cause {
            Cause::Abort(code) => abort_remedy(code),
            Cause::NoAnswer => {
                "check supply, cable and node, and that the drive is in a state with a mailbox"
            }
            Cause::TooLong => "read it with more room; the profile may have another type than the drive",
            Cause::Wire(_) => "compare profile and firmware: run the comparison of device and profile",
            Cause::Range(_) | Cause::NotListed => "write a value that the drive accepts",
            Cause::Access(Access::Wo) => {
                "keep the value that was written, or read the entry that reports its effect"
            }
            Cause::Access(_) => "write the entry that commands this value",
            Cause::NotInProfile => "correct the address, or add the entry to the profile",
            Cause::MappedInRxPdo => "set it in the process data, or map a layout without it",
        })
    }
}

/// What to do about an abort code. Empty for those that say it themselves or say nothing.
const fn abort_remedy(code: AbortCode) -> &'static str {
    match code {
        AbortCode::NO_OBJECT | AbortCode::NO_SUB_INDEX => {
            "check that profile and firmware belong together: read the identity"
        }
        AbortCode::READ_ONLY => "write the entry that commands this value",
        AbortCode::WRITE_ONLY => "keep the value that was written",
        AbortCode::SUB_INDEX_0_NOT_ZERO => "write 0 to sub-index 0, then the entries, then their number",
        AbortCode::MAPPED_IN_RX_PDO => "set it in the process data, or map a layout without it",
        AbortCode::NOT_MAPPABLE => "leave the entry out of this layout",
        AbortCode::PDO_LENGTH => "map fewer entries",
        AbortCode::LENGTH | AbortCode::LENGTH_TOO_HIGH | AbortCode::LENGTH_TOO_LOW => {
            "compare the type in the profile with the manual of this firmware"
        }
        AbortCode::VALUE
        | AbortCode::VALUE_TOO_HIGH
        | AbortCode::VALUE_TOO_LOW
        | AbortCode::MAX_BELOW_MIN => "write a value within the limits that the drive has now",
        AbortCode::DEVICE_STATE => {
            "disable the drive, or bring the bus to the state in which this can be written"
        }
        AbortCode::LOCAL_CONTROL => "end the operation at the panel or with the maker's tool",
        AbortCode::TIMED_OUT | AbortCode::NO_RESOURCE => "try again",
        _ => "",
    }
}

impl Explain for AccessError {
    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.alone().code(f)
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.alone().what(f)
    }

    fn why(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.alone().why(f)
    }

    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.alone().remedy(f)
    }
}

displays! {
    [] AccessError;
    ['e, 'm] Explained<'e, 'm>;
}
