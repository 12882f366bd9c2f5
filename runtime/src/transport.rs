//! What a program implements for its bus: SDO transfers, the exchange of process data, and a clock.
//!
//! The methods block, or are `async` in [`AsyncTransport`]. Neither asks for `Send`. [`crate::procedure`] runs on both.

use core::fmt;
use core::time::Duration;

use crate::abort::AbortCode;
use crate::address::Address;
use crate::time::Instant;

/// Why a transfer has no result. `E` is the error of the bus.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Refusal<E> {
    /// The drive refused it.
    Abort(AbortCode),
    /// No answer came in time, or the one that came makes no sense.
    NoAnswer,
    /// The answer has more bytes than there is room for.
    TooLong,
    /// The bus failed; nothing is tried again.
    Link(E),
}

impl<E: fmt::Display> fmt::Display for Refusal<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Abort(code) => write!(f, "the drive refused it: {code}"),
            Self::NoAnswer => f.write_str("no answer came in time"),
            Self::TooLong => f.write_str("the answer is longer than there is room for"),
            Self::Link(error) => write!(f, "the bus failed: {error}"),
        }
    }
}

impl<E: core::error::Error + 'static> core::error::Error for Refusal<E> {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Link(error) => Some(error),
            _ => None,
        }
    }
}

/// A bus with one drive on it, as a thread sees it that may wait.
///
/// An answer is bytes little endian, as they are on the wire.
pub trait Transport {
    /// What goes wrong on the bus itself: a cable, a socket.
    type Error;

    /// Reads an entry of the dictionary into `into`; gives the number of bytes.
    ///
    /// # Errors
    /// [`Refusal::NoAnswer`] after `within` without an answer, the others as they are described.
    fn upload(
        &mut self,
        address: Address,
        into: &mut [u8],
        within: Duration,
    ) -> Result<usize, Refusal<Self::Error>>;

    /// Writes an entry of the dictionary.
    ///
    /// # Errors
    /// As of [`upload`](Self::upload).
    fn download(
        &mut self,
        address: Address,
        data: &[u8],
        within: Duration,
    ) -> Result<(), Refusal<Self::Error>>;

    /// One cycle of process data: sends what the drive receives, waits for the next cycle, and gives what the drive sent, in
    /// number of bytes.
    ///
    /// # Errors
    /// [`Refusal::NoAnswer`] where no process data came in this cycle, the others as of [`upload`](Self::upload).
    fn exchange(&mut self, outputs: &[u8], inputs: &mut [u8]) -> Result<usize, Refusal<Self::Error>>;

    /// The time on the clock of the program.
    fn now(&mut self) -> Instant;

    /// Returns when it is `until`.
    fn wait(&mut self, until: Instant);
}

/// A bus with one drive on it, as a task sees it. The methods are those of [`Transport`].
#[allow(async_fn_in_trait)] // No `Send` is promised, on purpose: single-threaded executors are common on controllers.
pub trait AsyncTransport {
    /// What goes wrong on the bus itself.
    type Error;

    /// Reads an entry: [`Transport::upload`].
    async fn upload(
        &mut self,
        address: Address,
        into: &mut [u8],
        within: Duration,
    ) -> Result<usize, Refusal<Self::Error>>;

    /// Writes an entry: [`Transport::download`].
    async fn download(
        &mut self,
        address: Address,
        data: &[u8],
        within: Duration,
    ) -> Result<(), Refusal<Self::Error>>;

    /// One cycle of process data: [`Transport::exchange`].
    async fn exchange(&mut self, outputs: &[u8], inputs: &mut [u8]) -> Result<usize, Refusal<Self::Error>>;

    /// The time: [`Transport::now`].
    fn now(&mut self) -> Instant;

    /// Returns when it is `until`.
    async fn wait(&mut self, until: Instant);
}
