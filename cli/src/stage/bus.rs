//! The bus of a virtual drive, with somebody who looks at the drive after each step.

use std::convert::Infallible;
use std::time::Duration;

use drivewright_runtime::Address;
use drivewright_runtime::sim::{Disturbance, Disturbed, Link, VirtualDrive};
use drivewright_runtime::time::Instant;
use drivewright_runtime::transport::{Refusal, Transport};

use super::Recorder;

/// A bus whose drive is recorded.
pub(crate) struct Watched<'d, 'm, 's> {
    link: Disturbed<'d, 'm, 's>,
    cycle: Duration,
    /// Disturbances switch supplies on again; as long as there are none, supplies are as the user has them.
    disturbed: bool,
    pub(crate) recorder: Recorder,
}

impl<'d, 'm, 's> Watched<'d, 'm, 's> {
    /// A bus on which process data are exchanged every `cycle`.
    pub(crate) fn new(drive: &'d mut VirtualDrive<'m, 's>, cycle: Duration, recorder: Recorder) -> Self {
        Self { link: Disturbed::new(Link::new(drive, cycle)), cycle, disturbed: false, recorder }
    }

    pub(crate) fn drive(&mut self) -> &mut VirtualDrive<'m, 's> {
        self.link.drive()
    }

    /// Plans a disturbance from now on; `false` where too many are planned.
    pub(crate) fn disturb(&mut self, what: Disturbance, times: u32) -> bool {
        self.disturbed = true;
        self.link.disturb(what, 0, times)
    }

    /// Takes all disturbances back.
    pub(crate) fn calm(&mut self) {
        self.link.calm();
        self.disturbed = false;
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
        let exchanged = if self.disturbed {
            self.link.exchange(outputs, inputs)
        } else {
            Transport::exchange(self.link.link(), outputs, inputs)
        };
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
