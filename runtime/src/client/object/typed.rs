//! Reads and writes by a typed handle.

use super::{is_free, received, taken, AccessError, Action, Cause};
use crate::access::{AccessMarker, Readable, Writable};
use crate::address::Address;
use crate::object::Object;
use crate::pdo::MapEntry;
use crate::procedure::{Answer, Ask, Procedure};
use crate::time::Instant;
use crate::wire::{Fixed, VisibleString, Wire};

/// Reads an entry.
#[derive(Clone, Copy, Debug)]
pub struct Read<T, A, M, Q>(Object<T, A, M, Q>);

impl<T: Fixed, A: Readable, M, Q> Read<T, A, M, Q> {
    /// The read of `object`.
    pub const fn new(object: Object<T, A, M, Q>) -> Self {
        Self(object)
    }
}

impl<T: Fixed, A: Readable, M, Q> Procedure for Read<T, A, M, Q> {
    type Output = Result<T, AccessError>;

    fn next(&mut self, _: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        let address = self.0.address();
        if answer == Answer::Begin {
            return Ask::Upload(address);
        }
        let value = received(address, answer).and_then(|bytes| {
            let wire = |error| AccessError { address, action: Action::Read, cause: Cause::Wire(error) };
            T::decode(bytes).map_err(wire)
        });
        Ask::Done(value)
    }
}

/// Reads an entry whose length varies into memory of the caller, and gives how many bytes it has.
///
/// ```
/// use drivewright_runtime::client::object::ReadBytes;
/// use drivewright_runtime::prelude::*;
/// use drivewright_runtime::procedure::{Answer, Ask, Procedure};
/// use drivewright_runtime::time::Instant;
///
/// const NAME: Object<VisibleString, Ro, Unmapped, Raw> = Object::new(0x1008, 0);
///
/// let mut room = [0; 32];
/// let mut read = ReadBytes::new(NAME, &mut room);
/// read.next(Instant::START, Answer::Begin);
/// let Ask::Done(Ok(length)) = read.next(Instant::START, Answer::Data(b"X3")) else { panic!() };
/// assert_eq!(NAME.decode(&room[..length]).unwrap().as_str(), Ok("X3"));
/// ```
#[derive(Debug)]
pub struct ReadBytes<'b> {
    address: Address,
    into: &'b mut [u8],
}

impl<'b> ReadBytes<'b> {
    /// The read of `object` into this memory.
    pub fn new<T: Wire, A: Readable, M, Q>(object: Object<T, A, M, Q>, into: &'b mut [u8]) -> Self {
        Self { address: object.address(), into }
    }
}

impl Procedure for ReadBytes<'_> {
    type Output = Result<usize, AccessError>;

    fn next(&mut self, _: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        if answer == Answer::Begin {
            return Ask::Upload(self.address);
        }
        let too_long = AccessError { address: self.address, action: Action::Read, cause: Cause::TooLong };
        let length = received(self.address, answer).and_then(|bytes| {
            let place = self.into.get_mut(..bytes.len()).ok_or(too_long)?;
            place.copy_from_slice(bytes);
            Ok(bytes.len())
        });
        Ask::Done(length)
    }
}

/// Writes an entry. The value was checked when the write was made.
#[derive(Clone, Copy, Debug)]
pub struct Write<T: Fixed, A, M, Q> {
    object: Object<T, A, M, Q>,
    number: Option<i128>,
    bytes: T::Bytes,
}

impl<T: Fixed, A: Writable, M, Q> Write<T, A, M, Q> {
    /// The write of `value` to `object`.
    ///
    /// # Errors
    /// [`Cause::Range`] for a value that the drive refuses.
    pub fn new(object: Object<T, A, M, Q>, value: T) -> Result<Self, AccessError> {
        let number = T::whole(value);
        let refused = |error| AccessError {
            address: object.address(),
            action: Action::write(number),
            cause: Cause::Range(error),
        };
        object.check(value).map_err(refused)?;
        Ok(Self { object, number, bytes: value.to_bytes() })
    }

    /// On a drive that receives this layout as process data now.
    ///
    /// # Errors
    /// [`Cause::MappedInRxPdo`] where the layout carries the entry: see [`is_free`].
    pub fn beside(self, layout: &[MapEntry]) -> Result<Self, AccessError> {
        is_free(self.object.address(), layout)?;
        Ok(self)
    }
}

impl<T: Fixed, A: AccessMarker, M, Q> Procedure for Write<T, A, M, Q> {
    type Output = Result<(), AccessError>;

    fn next(&mut self, _: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        if answer == Answer::Begin {
            return Ask::Download(self.object.address(), self.bytes.as_ref());
        }
        Ask::Done(taken(self.object.address(), self.number, answer))
    }
}

/// Writes an entry whose length varies.
#[derive(Clone, Copy, Debug)]
pub struct WriteBytes<'b> {
    address: Address,
    bytes: &'b [u8],
}

impl<'b> WriteBytes<'b> {
    /// The write of these bytes to `object`.
    pub fn new<T, A, M, Q>(object: Object<T, A, M, Q>, bytes: &'b [u8]) -> Self
    where
        T: Wire<View<'b> = &'b [u8]>,
        A: Writable,
    {
        Self { address: object.address(), bytes }
    }

    /// The write of this text to `object`, without a terminator.
    pub fn text<A: Writable, M, Q>(object: Object<VisibleString, A, M, Q>, text: &'b str) -> Self {
        Self { address: object.address(), bytes: text.as_bytes() }
    }

    /// On a drive that receives this layout as process data now.
    ///
    /// # Errors
    /// [`Cause::MappedInRxPdo`] where the layout carries the entry: see [`is_free`].
    pub fn beside(self, layout: &[MapEntry]) -> Result<Self, AccessError> {
        is_free(self.address, layout)?;
        Ok(self)
    }
}

impl Procedure for WriteBytes<'_> {
    type Output = Result<(), AccessError>;

    fn next(&mut self, _: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        if answer == Answer::Begin {
            return Ask::Download(self.address, self.bytes);
        }
        Ask::Done(taken(self.address, None, answer))
    }
}
