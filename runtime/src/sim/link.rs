//! A drive and its master in one program, in virtual time: what a client under test uses as its bus.

use core::convert::Infallible;
use core::time::Duration;

use crate::address::Address;
use crate::model::EsmState;
use crate::time::Instant;
use crate::transport::{AsyncTransport, Refusal, Transport};

use super::drive::{NoAnswer, VirtualDrive};
use super::network::BusRefusal;

/// Time that an SDO transfer takes.
const TRANSFER: Duration = Duration::from_millis(1);

/// A bus with one virtual drive. Every transfer lets time pass, and so does waiting; nothing sleeps.
///
/// The inputs that an exchange gives are those after the outputs were taken and a cycle went by. In OP, outputs of a wrong
/// length are not taken, and there is no answer: the working counter of a real bus would be wrong.
#[derive(Debug)]
pub struct Link<'d, 'm, 's> {
    drive: &'d mut VirtualDrive<'m, 's>,
    cycle: Duration,
}

impl<'d, 'm, 's> Link<'d, 'm, 's> {
    /// A bus on which process data are exchanged every `cycle`.
    pub fn new(drive: &'d mut VirtualDrive<'m, 's>, cycle: Duration) -> Self {
        Self { drive, cycle }
    }

    /// The drive.
    pub fn drive(&mut self) -> &mut VirtualDrive<'m, 's> {
        self.drive
    }

    /// Waits until the drive has started up, and brings it to OP.
    ///
    /// # Errors
    /// What the drive refuses.
    pub fn start(&mut self) -> Result<(), BusRefusal> {
        self.drive.advance(self.drive.config().start_up);
        for state in [EsmState::PreOp, EsmState::SafeOp, EsmState::Op] {
            self.drive.request(state)?;
        }
        Ok(())
    }

    /// Asks until there is an answer or the time is over.
    fn ask<T>(
        &mut self,
        within: Duration,
        mut question: impl FnMut(&mut VirtualDrive<'m, 's>) -> Result<T, NoAnswer>,
    ) -> Result<T, Refusal<Infallible>> {
        let end = self.drive.now().after(within);
        loop {
            self.drive.advance(TRANSFER);
            match question(self.drive) {
                Ok(answer) => return Ok(answer),
                Err(NoAnswer::Abort(code)) => return Err(Refusal::Abort(code)),
                Err(NoAnswer::TooLong) => return Err(Refusal::TooLong),
                Err(NoAnswer::Silent) if self.drive.now() >= end => return Err(Refusal::NoAnswer),
                Err(NoAnswer::Silent) => {}
            }
        }
    }

    fn read(
        &mut self,
        address: Address,
        into: &mut [u8],
        within: Duration,
    ) -> Result<usize, Refusal<Infallible>> {
        self.ask(within, |drive| drive.upload(address, into))
    }

    fn write(&mut self, address: Address, data: &[u8], within: Duration) -> Result<(), Refusal<Infallible>> {
        self.ask(within, |drive| drive.download(address, data))
    }

    fn cycle(&mut self, outputs: &[u8], inputs: &mut [u8]) -> Result<usize, Refusal<Infallible>> {
        let taken = self.drive.receive(outputs) || self.drive.bus_state() != EsmState::Op;
        self.drive.advance(self.cycle);
        if !taken {
            return Err(Refusal::NoAnswer);
        }
        match self.drive.process_data_bytes() {
            (_, length) if length > inputs.len() => Err(Refusal::TooLong),
            _ => self.drive.send(inputs).ok_or(Refusal::NoAnswer),
        }
    }

    /// A cycle in which nothing arrives.
    pub(super) fn pass_cycle(&mut self) {
        self.drive.advance(self.cycle);
    }

    /// Where the statusword is in what the drive sends.
    pub(super) fn statusword_byte(&self) -> Option<usize> {
        self.drive.sent.byte_of(self.drive.slots.statusword)
    }

    fn pass(&mut self, until: Instant) {
        let span = until.since(self.drive.now());
        self.drive.advance(span);
    }
}

impl Transport for Link<'_, '_, '_> {
    type Error = Infallible;

    fn upload(
        &mut self,
        address: Address,
        into: &mut [u8],
        within: Duration,
    ) -> Result<usize, Refusal<Infallible>> {
        self.read(address, into, within)
    }

    fn download(
        &mut self,
        address: Address,
        data: &[u8],
        within: Duration,
    ) -> Result<(), Refusal<Infallible>> {
        self.write(address, data, within)
    }

    fn exchange(&mut self, outputs: &[u8], inputs: &mut [u8]) -> Result<usize, Refusal<Infallible>> {
        self.cycle(outputs, inputs)
    }

    fn now(&mut self) -> Instant {
        self.drive.now()
    }

    fn wait(&mut self, until: Instant) {
        self.pass(until);
    }
}

impl AsyncTransport for Link<'_, '_, '_> {
    type Error = Infallible;

    async fn upload(
        &mut self,
        address: Address,
        into: &mut [u8],
        within: Duration,
    ) -> Result<usize, Refusal<Infallible>> {
        self.read(address, into, within)
    }

    async fn download(
        &mut self,
        address: Address,
        data: &[u8],
        within: Duration,
    ) -> Result<(), Refusal<Infallible>> {
        self.write(address, data, within)
    }

    async fn exchange(&mut self, outputs: &[u8], inputs: &mut [u8]) -> Result<usize, Refusal<Infallible>> {
        self.cycle(outputs, inputs)
    }

    fn now(&mut self) -> Instant {
        self.drive.now()
    }

    async fn wait(&mut self, until: Instant) {
        self.pass(until);
    }
}
