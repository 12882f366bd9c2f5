//! What is read before anything is sent: what the drive shows, what it can do, what it receives besides the outputs of the
//! axis.

use super::operation::{received, wrong_length, Operation, Stage};
use crate::address::Address;
use crate::cia402::{State, StopOption};
use crate::client::axis::Modes;
use crate::client::error::ClientError;
use crate::client::image::Input;
use crate::model::Reset;
use crate::procedure::Answer;
use crate::time::Instant;

/// Something to know.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Fact {
    /// What an input is now.
    Now(Input),
    /// 6502h.
    Modes,
    /// 605Ah.
    QuickStop,
    /// That the fault can be reset: 603Fh.
    Resettable,
}

/// What every client wants to know.
pub(super) const FACTS: [Fact; 5] = [
    Fact::Now(Input::Statusword),
    Fact::Now(Input::Mode),
    Fact::Now(Input::Position),
    Fact::Modes,
    Fact::QuickStop,
];

impl Operation<'_, '_> {
    /// Where it is read, in the dictionary of this axis.
    pub(super) fn place_of(&self, fact: Fact) -> Address {
        self.client.image.at(match fact {
            Fact::Now(input) => input.address(),
            Fact::Modes => Address::new(0x6502, 0),
            Fact::QuickStop => Address::new(0x605A, 0),
            Fact::Resettable => Input::ErrorCode.address(),
        })
    }

    /// Whether it is not known yet and can be read. What the program has said itself is not read.
    pub(super) fn is_wanted(&self, fact: Fact) -> bool {
        let policy = self.client.axis.policy();
        match fact {
            Fact::Now(input) => self.client.has(input),
            Fact::Modes => policy.modes == Modes::ANY && self.exists(fact),
            Fact::QuickStop => policy.quick_stop.is_none() && self.exists(fact),
            Fact::Resettable => self.exists(fact),
        }
    }

    pub(super) fn exists(&self, fact: Fact) -> bool {
        self.client.model.object(self.place_of(fact)).is_some()
    }

    /// Takes what was read. What the drive does not say stays unknown, but for what the axis works with.
    pub(super) fn learn(&mut self, fact: Fact, answer: Answer<'_>) -> Result<(), ClientError> {
        let place = self.place_of(fact);
        match (fact, answer) {
            (Fact::Now(input), _) => self.take_input(input, answer)?,
            (Fact::Resettable, _) => {
                let bytes = received(place, answer)?;
                let code = <[u8; 2]>::try_from(bytes).map_err(|_| wrong_length(place, 2, bytes.len()))?;
                self.resettable(u16::from_le_bytes(code))?;
            }
            (Fact::Modes, Answer::Data(&[a, b, c, d])) => {
                self.client.axis.policy_mut().modes = Modes(u32::from_le_bytes([a, b, c, d]));
            }
            (Fact::QuickStop, Answer::Data(&[low, high])) => {
                let option = StopOption::quick_stop(i16::from_le_bytes([low, high]));
                self.client.axis.policy_mut().quick_stop = option;
            }
            (Fact::Modes | Fact::QuickStop, _) => (),
        }
        Ok(())
    }

    /// Several alarms may share a code: one that can be reset is enough to try it.
    fn resettable(&self, code: u16) -> Result<(), ClientError> {
        let lasting = |reset| matches!(reset, Reset::NotResettable | Reset::PowerCycle);
        let mut alarms = self.client.model.alarms_by_code(code).peekable();
        let state = self.client.axis.sample().and_then(|sample| sample.statusword.state());
        let faulted = state.is_some_and(State::is_fault);
        if faulted && alarms.peek().is_some() && alarms.all(|alarm| lasting(alarm.reset())) {
            return Err(ClientError::NotResettable { code });
        }
        Ok(())
    }

    /// The axis sees what was read, so that the first outputs follow from it. The mode that is shown needs no write.
    pub(super) fn primed(&mut self, now: Instant) {
        let sample = self.reading.sample();
        self.client.axis.cycle(now, sample);
        self.mode = sample.and_then(|sample| sample.mode);
        if self.mode.is_some() {
            self.client.mode_is_written();
        }
        self.stage = Stage::Fill(0);
    }

    pub(super) fn is_readable(&self, address: Address) -> bool {
        self.client.model.object(address).map_or(true, |object| object.access().reads())
    }

    pub(super) fn fill(&mut self, n: usize, answer: Answer<'_>) -> Result<(), ClientError> {
        let Some(entry) = self.client.image.others().nth(n) else { return Ok(()) };
        let (address, length) = (entry.address(), usize::from(entry.bits() / 8));
        let bytes = received(address, answer)?;
        if bytes.len() != length {
            return Err(wrong_length(address, length, bytes.len()));
        }
        self.client.image.place(address, bytes, &mut self.client.frame);
        Ok(())
    }
}
