//! Reads and writes by address, with what the model says about the entry.

use super::{is_free, received, taken, AccessError, Action, Cause, Content};
use crate::address::Address;
use crate::model::{DriveModel, ObjectDesc};
use crate::pdo::MapEntry;
use crate::procedure::{Answer, Ask, Procedure};
use crate::time::Instant;

/// The entry at `address`.
pub(crate) fn find<'m>(
    model: &DriveModel<'m>,
    address: Address,
    action: Action,
) -> Result<&'m ObjectDesc<'m>, AccessError> {
    model.object(address).ok_or(AccessError { address, action, cause: Cause::NotInProfile })
}

/// Reads an entry into memory of the caller: none is needed for numbers.
#[derive(Debug)]
pub struct ReadContent<'m, 'b> {
    object: &'m ObjectDesc<'m>,
    into: Option<&'b mut [u8]>,
}

impl<'m, 'b> ReadContent<'m, 'b> {
    /// The read of the entry at `address`.
    ///
    /// # Errors
    /// [`Cause::NotInProfile`], and [`Cause::Access`] where the drive would refuse it.
    pub fn new(model: &DriveModel<'m>, address: Address, into: &'b mut [u8]) -> Result<Self, AccessError> {
        let object = find(model, address, Action::Read)?;
        if !object.access().reads() {
            return Err(AccessError { address, action: Action::Read, cause: Cause::Access(object.access()) });
        }
        Ok(Self { object, into: Some(into) })
    }

    fn content(&mut self, answer: Answer<'_>) -> Result<Content<'b>, AccessError> {
        let address = self.object.address();
        let bytes = received(address, answer)?;
        if let Content::Int(value) = Content::decode(self.object, bytes)? {
            return Ok(Content::Int(value));
        }
        let too_long = AccessError { address, action: Action::Read, cause: Cause::TooLong };
        let place = self.into.take().and_then(|into| into.get_mut(..bytes.len())).ok_or(too_long)?;
        place.copy_from_slice(bytes);
        Ok(Content::Bytes(place))
    }
}

impl<'b> Procedure for ReadContent<'_, 'b> {
    type Output = Result<Content<'b>, AccessError>;

    fn next(&mut self, _: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        if answer == Answer::Begin {
            return Ask::Upload(self.object.address());
        }
        Ask::Done(self.content(answer))
    }
}

/// Writes an entry. The content was checked when the write was made.
#[derive(Clone, Copy, Debug)]
pub struct WriteContent<'b> {
    address: Address,
    content: Content<'b>,
    number: [u8; 8],
    used: usize,
}

impl<'b> WriteContent<'b> {
    /// The write of `content` to the entry at `address`.
    ///
    /// # Errors
    /// [`Cause::NotInProfile`], and those of [`Content::check`].
    pub fn new(model: &DriveModel<'_>, address: Address, content: Content<'b>) -> Result<Self, AccessError> {
        let action = Action::write(content.number());
        let object = find(model, address, action)?;
        content.check(model, object)?;
        let mut number = [0; 8];
        let used = match content {
            Content::Int(_) => content
                .encode(object.data_type(), &mut number)
                .map_err(|error| AccessError { address, action, cause: Cause::Wire(error) })?,
            Content::Bytes(_) => 0,
        };
        Ok(Self { address, content, number, used })
    }

    /// On a drive that receives this layout as process data now.
    ///
    /// # Errors
    /// [`Cause::MappedInRxPdo`] where the layout carries the entry: see [`is_free`].
    pub fn beside(self, layout: &[MapEntry]) -> Result<Self, AccessError> {
        is_free(self.address, layout)?;
        Ok(self)
    }

    /// What goes over the wire.
    pub fn bytes(&self) -> &[u8] {
        match self.content {
            Content::Int(_) => self.number.get(..self.used).unwrap_or(&[]),
            Content::Bytes(bytes) => bytes,
        }
    }
}

impl Procedure for WriteContent<'_> {
    type Output = Result<(), AccessError>;

    fn next(&mut self, _: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        if answer == Answer::Begin {
            return Ask::Download(self.address, self.bytes());
        }
        Ask::Done(taken(self.address, self.content.number(), answer))
    }
}
