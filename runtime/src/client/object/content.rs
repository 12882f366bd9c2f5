//! What an entry holds, for code that knows the type only at run time.

use super::{AccessError, Action, Cause};
use crate::data_type::DataType;
use crate::model::{DefaultValue, DriveModel, ObjectDesc};
use crate::object::RangeError;
use crate::wire::{put, Text, WireError};

/// What an entry holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum Content<'b> {
    /// A whole number, raw.
    Int(i128),
    /// A text, a domain, a time or floating point, as its bytes on the wire.
    Bytes(&'b [u8]),
}

impl<'b> Content<'b> {
    /// The content that these bytes are for the type of `object`.
    ///
    /// # Errors
    /// [`Cause::Wire`] where the length is not that of the type.
    pub fn decode(object: &ObjectDesc<'_>, bytes: &'b [u8]) -> Result<Self, AccessError> {
        let content = decode(object.data_type(), bytes);
        content.map_err(|error| AccessError {
            address: object.address(),
            action: Action::Read,
            cause: Cause::Wire(error),
        })
    }

    /// The number; `None` for bytes.
    pub const fn number(self) -> Option<i128> {
        match self {
            Self::Int(value) => Some(value),
            Self::Bytes(_) => None,
        }
    }

    /// That the entry takes this: it can be written, the value is within limits, list and type. Nothing is sent.
    ///
    /// # Errors
    /// [`AccessError`] with why not.
    pub fn check(self, model: &DriveModel<'_>, object: &ObjectDesc<'_>) -> Result<(), AccessError> {
        let refused =
            |cause| AccessError { address: object.address(), action: Action::write(self.number()), cause };
        if !object.access().writes() {
            return Err(refused(Cause::Access(object.access())));
        }
        let fits = match self {
            Self::Int(value) => fits(model, object, value),
            Self::Bytes(bytes) => fixed_length(object.data_type(), bytes).map_err(Cause::Wire),
        };
        fits.map_err(refused)
    }

    /// Writes it to the start of `out`, as the type wants it; returns how many bytes.
    pub(crate) fn encode(self, data_type: DataType, out: &mut [u8]) -> Result<usize, WireError> {
        match self {
            Self::Int(value) => data_type.encode_int(value, out),
            Self::Bytes(bytes) => put(out, bytes),
        }
    }

    /// Whether it is this default; `None` where none is stated. A text ends at its first NUL.
    pub fn is(self, default: DefaultValue<'_>) -> Option<bool> {
        match (self, default) {
            (_, DefaultValue::NotStated) => None,
            (Self::Int(found), DefaultValue::Int(value)) => Some(found == value),
            (Self::Bytes(found), DefaultValue::Text(text)) => {
                Some(Text(found).bytes() == Text::new(text).bytes())
            }
            _ => Some(false),
        }
    }

    /// Whether both are the same number, or the same text up to its first NUL.
    pub fn same(self, other: Content<'_>) -> bool {
        match (self, other) {
            (Self::Int(a), Content::Int(b)) => a == b,
            (Self::Bytes(a), Content::Bytes(b)) => Text(a).bytes() == Text(b).bytes() || a == b,
            _ => false,
        }
    }
}

fn decode(data_type: DataType, bytes: &[u8]) -> Result<Content<'_>, WireError> {
    if data_type.is_integer() {
        return data_type.decode_int(bytes).map(Content::Int);
    }
    fixed_length(data_type, bytes).map(|()| Content::Bytes(bytes))
}

/// That bytes have the length of the type, where that is fixed. Whole numbers do not come as bytes.
fn fixed_length(data_type: DataType, bytes: &[u8]) -> Result<(), WireError> {
    match data_type.bytes() {
        0 => Ok(()),
        expected if expected == bytes.len() => Ok(()),
        expected => Err(WireError::Length { expected, found: bytes.len() }),
    }
}

fn fits(model: &DriveModel<'_>, object: &ObjectDesc<'_>, value: i128) -> Result<(), Cause> {
    let data_type = object.data_type();
    let (low, high) = data_type.range().ok_or(Cause::Wire(WireError::NotInteger { data_type }))?;
    if !object.accepts(value) {
        let near = |n: i128| i64::try_from(n).unwrap_or(if n < 0 { i64::MIN } else { i64::MAX });
        let range =
            (near(object.min().unwrap_or(low).max(low)), near(object.max().unwrap_or(high).min(high)));
        return Err(Cause::Range(RangeError::new(object.address(), value, range, &[])));
    }
    let listed = model.allowed_of(object).map_or(true, |list| list.iter().any(|v| i128::from(*v) == value));
    if listed {
        Ok(())
    } else {
        Err(Cause::NotListed)
    }
}
