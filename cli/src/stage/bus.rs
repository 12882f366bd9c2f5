//! The bus of a virtual drive, with somebody who looks at the drive after each step.

use std::convert::Infallible;
use std::time::Duration;

use drivewright_runtime::Address;
use drivewright_runtime::sim::{Link, VirtualDrive};
use drivewright_runtime::time::Instant;
use drivewright_runtime::transport::{Refusal, Transport};

use super::Recorder;

/// A [`Link`] whose drive is recorded.
pub(crate) struct Watched<'d, 'm, 's> {
    link: Link<'d, 'm, 's>,
    cycle: Duration,
    pub(crate) recorder: Recorder,
}

impl<'d, 'm, 's> Watched<'d, 'm, 's> {
    /// A bus on which process data are exchanged every `cycle`.
    pub(crate) fn new(drive: &'d mut VirtualDrive<'m, 's>, cycle: Duration, recorder: Recorder) -> Self {
        Self { link: Link::new(drive, cycle), cycle, recorder }
    }

    pub(crate) fn drive(&mut self) -> &mut VirtualDrive<'m, 's> {
        self.link.drive()
    }

    /// Looks at the drive now.
    pub(crate) fn look(&mut self) {
        self.recorder.look(self.link.drive());
    }
}

impl Transport for Watched<'_, '_, '_> {
    type Error = Infallible;

    fn upload(
        &mut self,
        address: Address,
        into: &mut [u8],
        within: Duration,
    ) -> Result<usize, Refusal<Infallible>> {
        let read = self.link.upload(address, into, within);
        self.look();
        read
    }

    fn download(
        &mut self,
        address: Address,
        data: &[u8],
        within: Duration,
    ) -> Result<(), Refusal<Infallible>> {
        let written = self.link.download(address, data, within);
        self.look();
        written
    }

    fn exchange(&mut self, outputs: &[u8], inputs: &mut [u8]) -> Result<usize, Refusal<Infallible>> {
        let exchanged = self.link.exchange(outputs, inputs);
        self.look();
        exchanged
    }

    fn now(&mut self) -> Instant {
        Transport::now(&mut self.link)
    }

    /// In steps of a cycle, so that nothing is missed.
    fn wait(&mut self, until: Instant) {
        while Transport::now(&mut self.link) < until {
            let next = Transport::now(&mut self.link).after(self.cycle).min(until);
            Transport::wait(&mut self.link, next);
            self.look();
        }
    }
}
