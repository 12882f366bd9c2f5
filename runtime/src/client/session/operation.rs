//! The machine that runs a plan: SDO transfers, cycles of process data, and the axis between them.

use super::facts::{Fact, FACTS};
use super::{Client, Plan};
use crate::address::Address;
use crate::cia402::Mode;
use crate::client::error::ClientError;
use crate::client::image::{ImageError, Input, Output, Reading, FRAME_BYTES};
use crate::client::object::{AccessError, Action, Cause};
use crate::procedure::{Answer, Ask, Procedure};
use crate::time::Instant;
use crate::wire::WireError;

/// What is under way.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Stage {
    /// Nothing has been done yet.
    Begin,
    /// What the drive shows is read before anything is sent.
    Prime(usize),
    /// What the drive receives besides the outputs of the axis is read.
    Fill(usize),
    /// The next step begins.
    Step,
    /// A value is being written for a step.
    Write(Address, i64),
    /// A fact is being read for a step.
    Read(Fact),
    /// Outputs that are not mapped go by SDO.
    Send(usize),
    /// Process data are exchanged.
    Exchange,
    /// Inputs that are not mapped come by SDO.
    Receive(usize),
}

/// What to ask for; the bytes are in the buffer.
pub(super) enum Want {
    Upload(Address),
    Download(Address, usize),
    Exchange,
    Wait(Instant),
    Done(Result<(), ClientError>),
}

/// Runs a plan with a client over a bus.
pub struct Operation<'c, 'm> {
    pub(super) client: &'c mut Client<'m>,
    pub(super) plan: Plan,
    pub(super) at: usize,
    pub(super) stage: Stage,
    /// Before the operation.
    pub(super) mode: Option<Mode>,
    /// The axis had left operation before: that is no news.
    pub(super) tripped: bool,
    pub(super) reading: Reading,
    /// Process data came that make no sense.
    pub(super) odd: Option<ImageError>,
    /// The goal has come to an end; the last outputs are on their way.
    pub(super) ended: Option<Result<(), ClientError>>,
    /// The step is a cycle, or is held since this moment.
    pub(super) since: Option<Instant>,
    pub(super) held: Option<&'c mut dyn FnMut() -> bool>,
    pub(super) buffer: [u8; 8],
}

impl<'c, 'm> Operation<'c, 'm> {
    /// The operation that runs `plan`.
    pub fn new(client: &'c mut Client<'m>, plan: Plan) -> Self {
        Self {
            tripped: client.axis.trip().is_some(),
            client,
            plan,
            at: 0,
            stage: Stage::Begin,
            mode: None,
            reading: Reading::default(),
            odd: None,
            ended: None,
            since: None,
            held: None,
            buffer: [0; 8],
        }
    }

    /// With what says whether [`Step::Hold`] goes on.
    #[must_use]
    pub fn while_held(mut self, held: &'c mut dyn FnMut() -> bool) -> Self {
        self.held = Some(held);
        self
    }

    /// Takes what became of the last request.
    fn take(&mut self, answer: Answer<'_>) -> Result<(), ClientError> {
        match self.stage {
            Stage::Begin => {
                self.mode = self.client.axis.sample().and_then(|sample| sample.mode);
                self.stage = if self.client.primed { Stage::Step } else { Stage::Prime(0) };
            }
            Stage::Prime(n) => {
                FACTS.get(n).map_or(Ok(()), |fact| self.learn(*fact, answer))?;
                self.stage = Stage::Prime(n.saturating_add(1));
            }
            Stage::Fill(n) => {
                self.fill(n, answer)?;
                self.stage = Stage::Fill(n.saturating_add(1));
            }
            Stage::Step => (),
            Stage::Write(address, value) => {
                written(address, i128::from(value), answer)?;
                self.stage = Stage::Step;
            }
            Stage::Read(fact) => {
                self.learn(fact, answer)?;
                self.stage = Stage::Step;
            }
            Stage::Send(n) => {
                let output = Output::ALL.get(n).copied().unwrap_or(Output::Controlword);
                self.sent(output, answer)?;
                self.stage = Stage::Send(n.saturating_add(1));
            }
            Stage::Exchange => {
                let unpacked = match answer {
                    Answer::Inputs(bytes) => self.client.image.unpack(bytes),
                    _ => Ok(Reading::default()),
                };
                // What makes no sense is no sample. If it stays like that, this is why the axis is not heard.
                self.odd = unpacked.err().or(self.odd);
                self.reading = unpacked.unwrap_or_default();
                self.stage = Stage::Receive(0);
            }
            Stage::Receive(n) => {
                self.receive(n, answer)?;
                self.stage = Stage::Receive(n.saturating_add(1));
            }
        }
        Ok(())
    }

    /// Finds the next request.
    fn seek(&mut self, now: Instant) -> Result<Want, ClientError> {
        loop {
            match self.stage {
                Stage::Prime(n) => match FACTS.get(n) {
                    Some(fact) if self.is_wanted(*fact) => return Ok(Want::Upload(self.place_of(*fact))),
                    Some(_) => self.stage = Stage::Prime(n.saturating_add(1)),
                    None => self.primed(now),
                },
                Stage::Fill(n) => match self.client.image.others().nth(n) {
                    Some(entry) if self.is_readable(entry.address()) => {
                        return Ok(Want::Upload(entry.address()))
                    }
                    Some(_) => self.stage = Stage::Fill(n.saturating_add(1)),
                    None => {
                        self.client.primed = true;
                        self.stage = Stage::Step;
                    }
                },
                Stage::Step => {
                    if let Some(want) = self.begin_step(now)? {
                        return Ok(want);
                    }
                }
                // Never so: what begins has begun, and what is under way is taken before anything is sought.
                Stage::Begin | Stage::Write(..) | Stage::Read(_) => return Ok(Want::Done(Ok(()))),
                Stage::Send(n) => match Output::ALL.get(n) {
                    Some(output) if self.must_send(*output) => return Ok(self.send(*output)),
                    Some(_) => self.stage = Stage::Send(n.saturating_add(1)),
                    None => {
                        self.stage = Stage::Exchange;
                        return Ok(self.exchange(now));
                    }
                },
                Stage::Exchange => return Ok(self.exchange(now)),
                Stage::Receive(n) => match Input::ALL.get(n) {
                    Some(input) if self.must_receive(*input) => {
                        return Ok(Want::Upload(self.client.image.at(input.address())));
                    }
                    Some(_) => self.stage = Stage::Receive(n.saturating_add(1)),
                    None => {
                        if let Some(done) = self.end_cycle(now) {
                            return Ok(Want::Done(done));
                        }
                    }
                },
            }
        }
    }
}

impl Procedure for Operation<'_, '_> {
    type Output = Result<(), ClientError>;

    fn next(&mut self, now: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        let want = match self.take(answer).and_then(|()| self.seek(now)) {
            Ok(want) => want,
            Err(error) => Want::Done(Err(error)),
        };
        let frame = self.client.image.rx_bytes().min(FRAME_BYTES);
        match want {
            Want::Upload(address) => Ask::Upload(address),
            Want::Download(address, length) => {
                Ask::Download(address, self.buffer.get(..length).unwrap_or(&self.buffer))
            }
            Want::Exchange => Ask::Exchange(self.client.frame.get(..frame).unwrap_or(&[])),
            Want::Wait(until) => Ask::Wait(until),
            Want::Done(result) => Ask::Done(result),
        }
    }
}

impl Drop for Operation<'_, '_> {
    /// A held movement that is given up stops with the next cycle.
    fn drop(&mut self) {
        if self.since.is_some() && self.held.is_some() && self.client.axis.target_velocity(0).is_err() {
            // Not in operation, or beyond the step of a cyclic mode: then by the stop of the drive.
            self.client.axis.quick_stop();
        }
    }
}

pub(super) fn received(address: Address, answer: Answer<'_>) -> Result<&[u8], ClientError> {
    crate::client::object::received(address, answer).map_err(ClientError::Access)
}

pub(super) fn written(address: Address, number: i128, answer: Answer<'_>) -> Result<(), ClientError> {
    crate::client::object::taken(address, Some(number), answer).map_err(ClientError::Access)
}

pub(super) fn wrong_length(address: Address, expected: usize, found: usize) -> ClientError {
    let cause = Cause::Wire(WireError::Length { expected, found });
    ClientError::Access(AccessError { address, action: Action::Read, cause })
}
