//! Procedures: what a client does with a drive, as a machine that takes answers and asks for the next thing.
//!
//! A procedure does no input or output and owns no clock. [`run`] executes it on a bus that blocks, [`run_async`] on one
//! that does not; a program with a loop of its own calls [`Procedure::next`] by hand.

use core::time::Duration;

use crate::abort::AbortCode;
use crate::address::Address;
use crate::time::Instant;
use crate::transport::{AsyncTransport, Refusal, Transport};

/// What a procedure wants next.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Ask<'a, T> {
    /// Read this entry.
    Upload(Address),
    /// Write this entry.
    Download(Address, &'a [u8]),
    /// Exchange process data once, and send this.
    Exchange(&'a [u8]),
    /// Come again at this time.
    Wait(Instant),
    /// It is over, with this result.
    Done(T),
}

/// What became of what a procedure asked for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Answer<'a> {
    /// Nothing was asked yet.
    Begin,
    /// What was read.
    Data(&'a [u8]),
    /// It is written.
    Written,
    /// What the drive sent in this cycle.
    Inputs(&'a [u8]),
    /// The time has come.
    Waited,
    /// The drive refused it.
    Abort(AbortCode),
    /// No answer came, after all tries; or no process data in this cycle.
    NoAnswer,
    /// The answer is longer than there is room for.
    TooLong,
}

/// A machine that asks for one thing after the other.
///
/// An answer that does not belong to what was asked is to be taken as [`Answer::NoAnswer`]; nothing that a drive sends
/// makes a procedure panic or wait without end. After [`Ask::Done`] it may do anything but panic.
pub trait Procedure {
    /// Its result.
    type Output;

    /// Takes what became of the last thing and asks for the next.
    fn next(&mut self, now: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output>;
}

/// How long to wait for an answer and how often to ask again.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Policy {
    /// The longest time from an SDO request to its answer.
    pub answer_within: Duration,
    /// How often an SDO transfer without an answer is tried again. One that was refused is not.
    pub retries: u8,
}

impl Default for Policy {
    /// Half a second, and two more tries.
    fn default() -> Self {
        Self { answer_within: Duration::from_millis(500), retries: 2 }
    }
}

/// The most bytes of an answer that [`run`] has room for: texts and process data.
pub const ANSWER_BYTES: usize = 256;

/// Both runners are one loop; they differ in whether they wait or are told to come again.
macro_rules! run {
    ($procedure:ident, $bus:ident, $policy:ident $(, $wait:ident)?) => {{
        let mut buffer = [0; ANSWER_BYTES];
        let mut answer = Ended::Begin;
        let mut tries = 0;
        loop {
            let now = $bus.now();
            let ended = match $procedure.next(now, answer.answer(&buffer)) {
                Ask::Done(output) => return Ok(output),
                Ask::Wait(until) => {
                    $bus.wait(until)$(.$wait)?;
                    Ended::Waited
                }
                Ask::Exchange(outputs) => {
                    Ended::of($bus.exchange(outputs, &mut buffer)$(.$wait)?.map(Ended::Inputs))?
                }
                Ask::Upload(address) => loop {
                    let read = $bus.upload(address, &mut buffer, $policy.answer_within)$(.$wait)?;
                    match Ended::of(read.map(Ended::Data))? {
                        Ended::NoAnswer if tries < $policy.retries => tries += 1,
                        ended => break ended,
                    }
                },
                Ask::Download(address, data) => loop {
                    let written = $bus.download(address, data, $policy.answer_within)$(.$wait)?;
                    match Ended::of(written.map(|()| Ended::Written))? {
                        Ended::NoAnswer if tries < $policy.retries => tries += 1,
                        ended => break ended,
                    }
                },
            };
            (answer, tries) = (ended, 0);
        }
    }};
}

/// Runs a procedure to its end on a bus that blocks.
///
/// # Errors
/// The error of the bus itself. What the drive refuses is a matter of the procedure.
pub fn run<P: Procedure, T: Transport>(
    procedure: &mut P,
    bus: &mut T,
    policy: Policy,
) -> Result<P::Output, T::Error> {
    run!(procedure, bus, policy)
}

/// Runs a procedure to its end on a bus that does not block.
///
/// # Errors
/// As of [`run`].
pub async fn run_async<P: Procedure, T: AsyncTransport>(
    procedure: &mut P,
    bus: &mut T,
    policy: Policy,
) -> Result<P::Output, T::Error> {
    run!(procedure, bus, policy, await)
}

/// An [`Answer`] whose bytes are still in the buffer.
#[derive(Clone, Copy)]
enum Ended {
    Begin,
    Data(usize),
    Inputs(usize),
    Written,
    Waited,
    Abort(AbortCode),
    NoAnswer,
    TooLong,
}

impl Ended {
    fn of<E>(result: Result<Self, Refusal<E>>) -> Result<Self, E> {
        match result {
            Ok(ended) => Ok(ended),
            Err(Refusal::Abort(code)) => Ok(Self::Abort(code)),
            Err(Refusal::NoAnswer) => Ok(Self::NoAnswer),
            Err(Refusal::TooLong) => Ok(Self::TooLong),
            Err(Refusal::Link(error)) => Err(error),
        }
    }

    /// A transport that claims more bytes than the buffer has is not believed.
    fn answer(self, buffer: &[u8]) -> Answer<'_> {
        match self {
            Self::Begin => Answer::Begin,
            Self::Data(n) => buffer.get(..n).map_or(Answer::TooLong, Answer::Data),
            Self::Inputs(n) => buffer.get(..n).map_or(Answer::TooLong, Answer::Inputs),
            Self::Written => Answer::Written,
            Self::Waited => Answer::Waited,
            Self::Abort(code) => Answer::Abort(code),
            Self::NoAnswer => Answer::NoAnswer,
            Self::TooLong => Answer::TooLong,
        }
    }
}

#[cfg(test)]
mod tests;
