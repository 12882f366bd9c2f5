//! What real wires and supplies do, on demand: between a client and a virtual drive.

use core::convert::Infallible;
use core::time::Duration;

use crate::abort::AbortCode;
use crate::address::Address;
use crate::time::Instant;
use crate::transport::{AsyncTransport, Refusal, Transport};

use super::drive::VirtualDrive;
use super::link::Link;

/// The most disturbances that are planned at once.
pub const MAX_DISTURBANCES: usize = 8;

/// Something that goes wrong.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Disturbance {
    /// SDO: the request does not arrive.
    LostRequest,
    /// SDO: the drive does what is asked for, and its answer does not arrive.
    LostAnswer,
    /// SDO: the answer comes so much later, in milliseconds, or too late.
    LateAnswer(u16),
    /// SDO: the drive refuses with this code and does nothing.
    WrongAbort(AbortCode),
    /// SDO: the answer to an upload has a byte less; an answer of one byte has none.
    ShortAnswer,
    /// SDO: the answer to an upload has a byte more.
    LongAnswer,
    /// Process data: neither direction arrives in this cycle.
    LostCycle,
    /// Process data: what the drive sends arrives as it was in the last cycle, and the drive receives what is sent.
    FrozenInputs,
    /// Process data: what arrives has a byte less.
    ShortInputs,
    /// Bits of the statusword are stuck, in process data and in answers.
    StuckStatus {
        /// Which bits.
        mask: u16,
        /// Their value.
        value: u16,
    },
    /// The drive must not make torque: it leaves operation enabled by itself.
    NoTorque,
    /// The main supply is off.
    MainsDip,
    /// The control supply is off: the drive starts anew afterwards.
    SupplyDip,
}

impl Disturbance {
    /// Whether it counts SDO transfers, and not cycles of process data.
    const fn is_of_transfers(self) -> bool {
        matches!(
            self,
            Self::LostRequest
                | Self::LostAnswer
                | Self::LateAnswer(_)
                | Self::WrongAbort(_)
                | Self::ShortAnswer
                | Self::LongAnswer
        )
    }
}

/// A disturbance that is planned.
#[derive(Clone, Copy, Debug)]
struct Planned {
    what: Disturbance,
    after: u32,
    times: u32,
}

/// A bus that goes wrong when it is told to.
#[derive(Debug)]
pub struct Disturbed<'d, 'm, 's> {
    link: Link<'d, 'm, 's>,
    planned: [Option<Planned>; MAX_DISTURBANCES],
    /// What the drive sent last.
    last: [u8; 64],
    length: usize,
}

impl<'d, 'm, 's> Disturbed<'d, 'm, 's> {
    /// A bus that works so far.
    pub const fn new(link: Link<'d, 'm, 's>) -> Self {
        Self { link, planned: [None; MAX_DISTURBANCES], last: [0; 64], length: 0 }
    }

    /// The bus without disturbances.
    pub fn link(&mut self) -> &mut Link<'d, 'm, 's> {
        &mut self.link
    }

    /// The drive.
    pub fn drive(&mut self) -> &mut VirtualDrive<'m, 's> {
        self.link.drive()
    }

    /// Plans a disturbance, `times` times after `after` more transfers, or after so many more cycles of process data.
    /// `false` where too many are planned.
    pub fn disturb(&mut self, what: Disturbance, after: u32, times: u32) -> bool {
        let free = self.planned.iter_mut().find(|place| place.is_none());
        free.map(|place| *place = Some(Planned { what, after, times })).is_some()
    }

    /// Takes back everything that is planned; supplies are on again.
    pub fn calm(&mut self) {
        self.planned = [None; MAX_DISTURBANCES];
        self.apply(|_| false);
    }

    /// The disturbances of the next transfer or cycle; they are counted down.
    fn due(&mut self, of_transfers: bool) -> [Option<Disturbance>; MAX_DISTURBANCES] {
        let mut due = [None; MAX_DISTURBANCES];
        for (place, due) in self.planned.iter_mut().zip(&mut due) {
            let Some(planned) = place.as_mut().filter(|p| p.what.is_of_transfers() == of_transfers) else {
                continue;
            };
            if let Some(after) = planned.after.checked_sub(1) {
                planned.after = after;
                continue;
            }
            *due = Some(planned.what);
            planned.times = planned.times.saturating_sub(1);
            if planned.times == 0 {
                *place = None;
            }
        }
        due
    }

    /// Switches supplies as `is` says; nothing happens where they are so already.
    fn apply(&mut self, is: impl Fn(Disturbance) -> bool) {
        let drive = self.link.drive();
        drive.allow_torque(!is(Disturbance::NoTorque));
        drive.set_mains(!is(Disturbance::MainsDip));
        drive.set_supply(!is(Disturbance::SupplyDip));
    }

    /// The bits of the statusword that are stuck now.
    fn stuck(&self) -> (u16, u16) {
        let stuck = |planned: &Planned| match planned.what {
            Disturbance::StuckStatus { mask, value } if planned.after == 0 => Some((mask, value)),
            _ => None,
        };
        self.planned.iter().flatten().find_map(stuck).unwrap_or((0, 0))
    }

    fn read(
        &mut self,
        address: Address,
        into: &mut [u8],
        within: Duration,
    ) -> Result<usize, Refusal<Infallible>> {
        let stuck = self.stuck();
        let due = self.due(true);
        self.before(&due, within)?;
        let length = Transport::upload(&mut self.link, address, into, within)?;
        self.afterwards(&due, within)?;
        if address == Address::new(0x6041, 0) {
            stick(into, stuck);
        }
        let has = |what| due.contains(&Some(what));
        match (has(Disturbance::ShortAnswer), has(Disturbance::LongAnswer)) {
            (true, _) => Ok(length.saturating_sub(1)),
            (_, true) if length < into.len() => Ok(length.saturating_add(1)),
            (_, true) => Err(Refusal::TooLong),
            _ => Ok(length),
        }
    }

    fn write(&mut self, address: Address, data: &[u8], within: Duration) -> Result<(), Refusal<Infallible>> {
        let due = self.due(true);
        self.before(&due, within)?;
        Transport::download(&mut self.link, address, data, within)?;
        self.afterwards(&due, within)
    }

    /// What happens on the way to the drive.
    fn before(&mut self, due: &[Option<Disturbance>], within: Duration) -> Result<(), Refusal<Infallible>> {
        for what in due.iter().flatten() {
            match what {
                Disturbance::LostRequest => return self.nothing(within),
                Disturbance::WrongAbort(code) => return Err(Refusal::Abort(*code)),
                _ => {}
            }
        }
        Ok(())
    }

    /// What happens on the way back.
    fn afterwards(
        &mut self,
        due: &[Option<Disturbance>],
        within: Duration,
    ) -> Result<(), Refusal<Infallible>> {
        for what in due.iter().flatten() {
            match what {
                Disturbance::LostAnswer => return self.nothing(within),
                Disturbance::LateAnswer(millis) => {
                    let late = Duration::from_millis(u64::from(*millis));
                    if late >= within {
                        return self.nothing(within);
                    }
                    self.link.drive().advance(late);
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn nothing(&mut self, within: Duration) -> Result<(), Refusal<Infallible>> {
        self.link.drive().advance(within);
        Err(Refusal::NoAnswer)
    }

    fn cycle(&mut self, outputs: &[u8], inputs: &mut [u8]) -> Result<usize, Refusal<Infallible>> {
        let stuck = self.stuck();
        let due = self.due(false);
        let has = |what| due.contains(&Some(what));
        self.apply(has);
        if has(Disturbance::LostCycle) {
            self.link.pass_cycle();
            return Err(Refusal::NoAnswer);
        }
        let result = Transport::exchange(&mut self.link, outputs, inputs)?;
        let length =
            if has(Disturbance::FrozenInputs) { self.repeat(inputs) } else { self.keep(inputs, result) };
        if let Some(word) = self.link.statusword_byte().and_then(|byte| inputs.get_mut(byte..)) {
            stick(word, stuck);
        }
        Ok(if has(Disturbance::ShortInputs) { length.saturating_sub(1) } else { length })
    }

    fn keep(&mut self, inputs: &[u8], length: usize) -> usize {
        self.last.iter_mut().zip(inputs).for_each(|(to, from)| *to = *from);
        self.length = length;
        length
    }

    fn repeat(&self, inputs: &mut [u8]) -> usize {
        inputs.iter_mut().zip(self.last).for_each(|(to, from)| *to = from);
        self.length.min(inputs.len())
    }
}

/// Bits of a word, little endian, are stuck.
fn stick(word: &mut [u8], (mask, value): (u16, u16)) {
    for ((byte, mask), value) in word.iter_mut().zip(mask.to_le_bytes()).zip(value.to_le_bytes()) {
        *byte = *byte & !mask | value & mask;
    }
}

impl Transport for Disturbed<'_, '_, '_> {
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
        Transport::now(&mut self.link)
    }

    fn wait(&mut self, until: Instant) {
        Transport::wait(&mut self.link, until);
    }
}

impl AsyncTransport for Disturbed<'_, '_, '_> {
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
        Transport::now(&mut self.link)
    }

    async fn wait(&mut self, until: Instant) {
        Transport::wait(&mut self.link, until);
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::{at, MODEL};
    use super::super::{cells, Config};
    use super::*;

    const MS: Duration = Duration::from_millis(1);
    const WITHIN: Duration = Duration::from_millis(50);

    fn with(check: impl FnOnce(&mut Disturbed<'_, '_, '_>)) {
        let mut cells = [0; cells(&MODEL)];
        let mut drive = VirtualDrive::new(&MODEL, &mut cells, Config::default()).unwrap();
        let mut link = Link::new(&mut drive, MS);
        link.start().unwrap();
        check(&mut Disturbed::new(link));
    }

    #[test]
    fn transfers_go_wrong_when_they_are_told_to() {
        with(|bus| {
            let write = |bus: &mut Disturbed<'_, '_, '_>, value: u8| {
                bus.write(at(0x6083, 0), &[value, 0, 0, 0], WITHIN)
            };
            let value = |bus: &mut Disturbed<'_, '_, '_>| bus.drive().value(at(0x6083, 0));
            bus.disturb(Disturbance::LostRequest, 1, 1);
            bus.disturb(Disturbance::LostAnswer, 2, 1);
            bus.disturb(Disturbance::WrongAbort(AbortCode::GENERAL), 3, 1);
            assert_eq!((write(bus, 1), value(bus)), (Ok(()), Some(1)));
            assert_eq!((write(bus, 2), value(bus)), (Err(Refusal::NoAnswer), Some(1)));
            assert_eq!((write(bus, 3), value(bus)), (Err(Refusal::NoAnswer), Some(3)));
            assert_eq!((write(bus, 4), value(bus)), (Err(Refusal::Abort(AbortCode::GENERAL)), Some(3)));
            assert_eq!((write(bus, 5), value(bus)), (Ok(()), Some(5)));
        });
    }

    #[test]
    fn answers_have_the_wrong_length_or_come_late() {
        with(|bus| {
            let read = |bus: &mut Disturbed<'_, '_, '_>| bus.read(at(0x6083, 0), &mut [0; 8], WITHIN);
            for (what, answer) in [
                (Disturbance::ShortAnswer, Ok(3)),
                (Disturbance::LongAnswer, Ok(5)),
                (Disturbance::LateAnswer(10), Ok(4)),
                (Disturbance::LateAnswer(50), Err(Refusal::NoAnswer)),
            ] {
                bus.disturb(what, 0, 1);
                assert_eq!(read(bus), answer, "{what:?}");
            }
        });
    }

    #[test]
    fn process_data_go_wrong() {
        with(|bus| {
            let mut inputs = [0; 7];
            let outputs = [6, 0, 0, 0, 0, 0, 1];
            bus.disturb(Disturbance::LostCycle, 1, 2);
            bus.disturb(Disturbance::StuckStatus { mask: 0x0001, value: 0 }, 3, 1);
            assert_eq!((bus.cycle(&outputs, &mut inputs), inputs[0]), (Ok(7), 0x31));
            assert_eq!(bus.cycle(&outputs, &mut inputs), Err(Refusal::NoAnswer));
            assert_eq!(bus.cycle(&outputs, &mut inputs), Err(Refusal::NoAnswer));
            assert_eq!((bus.cycle(&outputs, &mut inputs), inputs[0]), (Ok(7), 0x30));
            bus.disturb(Disturbance::FrozenInputs, 0, 1);
            bus.cycle(&[7, 0, 0, 0, 0, 0, 1], &mut inputs).unwrap();
            assert_eq!(inputs[0], 0x31);
            assert_eq!((bus.cycle(&[7, 0, 0, 0, 0, 0, 1], &mut inputs), inputs[0]), (Ok(7), 0x33));
        });
    }

    #[test]
    fn supplies_dip() {
        with(|bus| {
            let mut inputs = [0; 7];
            for word in [6, 7, 15] {
                bus.cycle(&[word, 0, 0, 0, 0, 0, 1], &mut inputs).unwrap();
            }
            assert_eq!(inputs[0] & 0x6F, 0x27);
            bus.disturb(Disturbance::NoTorque, 0, 1);
            bus.cycle(&[15, 0, 0, 0, 0, 0, 1], &mut inputs).unwrap();
            assert_eq!(inputs[0], 0x40, "no voltage, switch on disabled");
            bus.disturb(Disturbance::SupplyDip, 0, 1);
            assert_eq!(bus.cycle(&[15, 0, 0, 0, 0, 0, 1], &mut inputs), Err(Refusal::NoAnswer));
        });
    }
}
