//! Reads and writes of the object dictionary: by typed handle, or by address with what the model says.
//!
//! A value is checked before it is sent: a write that the drive would refuse, or clip without a word, is an error that
//! costs no transfer. An answer is taken only if it has the length of the type.
//!
//! ```
//! use drivewright_runtime::client::object::{Read, Write};
//! use drivewright_runtime::prelude::*;
//! use drivewright_runtime::procedure::{Answer, Ask, Procedure};
//! use drivewright_runtime::time::Instant;
//!
//! const SPEED: Object<u32, Rw, RxTx, Velocity> = Object::new(0x6081, 0).range(0, 60_000).scale(1, 10);
//!
//! let mut read = Read::new(SPEED);
//! assert_eq!(read.next(Instant::START, Answer::Begin), Ask::Upload(SPEED.address()));
//! assert_eq!(read.next(Instant::START, Answer::Data(&[0x30, 0x75, 0, 0])), Ask::Done(Ok(30_000)));
//!
//! let error = Write::new(SPEED, 60_001).unwrap_err();
//! assert_eq!(error.to_string(), "\
//! error[RANGE]: write of 6081:00 = 60001 was not sent: 60001 is outside 0 to 60000, the raw range of 6081:00
//!   do     : write a value that the drive accepts");
//! ```

mod content;
mod error;
mod mapped;
mod show;
mod typed;
mod untyped;

pub use content::Content;
pub use error::{AccessError, Action, Cause, Explained};
pub use mapped::is_free;
pub(crate) use show::Bits;
pub use show::Shown;
pub use typed::{Read, ReadBytes, Write, WriteBytes};
pub use untyped::{ReadContent, WriteContent};

use crate::address::Address;
use crate::procedure::Answer;

/// The bytes that a read of `address` gave.
pub(crate) fn received(address: Address, answer: Answer<'_>) -> Result<&[u8], AccessError> {
    match answer {
        Answer::Data(bytes) => Ok(bytes),
        other => Err(AccessError { address, action: Action::Read, cause: Cause::of(other) }),
    }
}

/// That a write to `address` was taken.
pub(crate) fn taken(address: Address, number: Option<i128>, answer: Answer<'_>) -> Result<(), AccessError> {
    match answer {
        Answer::Written => Ok(()),
        other => Err(AccessError { address, action: Action::write(number), cause: Cause::of(other) }),
    }
}

#[cfg(test)]
mod tests;
