//! Drives for tests: one that is a map of entries, and one that answers nonsense.

use core::time::Duration;
use std::collections::{BTreeMap, BTreeSet};
use std::vec::Vec;

use crate::abort::AbortCode;
use crate::address::Address;
use crate::procedure::{run, Policy, Procedure};
use crate::time::Instant;
use crate::transport::{Refusal, Transport};

pub(crate) type Outcome<T> = Result<T, Refusal<&'static str>>;

pub(crate) const fn at(index: u16, sub: u8) -> Address {
    Address::new(index, sub)
}

/// A drive as a map of entries, with a clock that only waiting moves.
#[derive(Default)]
pub(crate) struct Dictionary {
    pub(crate) entries: BTreeMap<Address, Vec<u8>>,
    /// What a read of these is answered with.
    pub(crate) reads: BTreeMap<Address, Refusal<&'static str>>,
    /// What a write to these is answered with.
    pub(crate) writes: BTreeMap<Address, Refusal<&'static str>>,
    /// Entries that take a write and forget it.
    pub(crate) deaf: BTreeSet<Address>,
    /// What was written, in order.
    pub(crate) written: Vec<(Address, Vec<u8>)>,
    pub(crate) now: u64,
}

impl Dictionary {
    pub(crate) fn with(mut self, address: Address, bytes: &[u8]) -> Self {
        self.entries.insert(address, bytes.into());
        self
    }

    pub(crate) fn run<P: Procedure>(&mut self, mut procedure: P) -> P::Output {
        run(&mut procedure, self, Policy::default()).unwrap()
    }
}

impl Transport for Dictionary {
    type Error = &'static str;

    fn upload(&mut self, address: Address, into: &mut [u8], _: Duration) -> Outcome<usize> {
        if let Some(refusal) = self.reads.get(&address) {
            return Err(*refusal);
        }
        let no_sub = self.entries.keys().any(|entry| entry.index() == address.index());
        let code = if no_sub { AbortCode::NO_SUB_INDEX } else { AbortCode::NO_OBJECT };
        let bytes = self.entries.get(&address).ok_or(Refusal::Abort(code))?;
        into.get_mut(..bytes.len()).ok_or(Refusal::TooLong)?.copy_from_slice(bytes);
        Ok(bytes.len())
    }

    fn download(&mut self, address: Address, data: &[u8], _: Duration) -> Outcome<()> {
        if let Some(refusal) = self.writes.get(&address) {
            return Err(*refusal);
        }
        if !self.entries.contains_key(&address) {
            return Err(Refusal::Abort(AbortCode::NO_OBJECT));
        }
        self.written.push((address, data.into()));
        if !self.deaf.contains(&address) {
            self.entries.insert(address, data.into());
        }
        Ok(())
    }

    fn exchange(&mut self, _: &[u8], _: &mut [u8]) -> Outcome<usize> {
        Err(Refusal::NoAnswer)
    }

    fn now(&mut self) -> Instant {
        Instant::from_micros(self.now)
    }

    fn wait(&mut self, until: Instant) {
        self.now = self.now.max(until.micros());
    }
}

/// A drive that answers whatever a generator of pseudo-random numbers says, and counts how often it was asked.
pub(crate) struct Nonsense {
    state: u64,
    pub(crate) asked: usize,
}

impl Nonsense {
    pub(crate) fn new(seed: u64) -> Self {
        Self { state: seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(1), asked: 0 }
    }

    pub(crate) fn random(&mut self) -> u64 {
        self.state =
            self.state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.state >> 33
    }

    fn refusal(&mut self) -> Refusal<&'static str> {
        match self.random() % 4 {
            0 => Refusal::Abort(AbortCode(u32::try_from(self.random()).unwrap())),
            1 => Refusal::Abort(AbortCode::NO_OBJECT),
            2 => Refusal::TooLong,
            _ => Refusal::NoAnswer,
        }
    }

    fn count(&mut self) {
        self.asked += 1;
        assert!(self.asked < 100_000, "a procedure that asks without end");
    }

    /// Runs a procedure to its end, which must come.
    pub(crate) fn run<P: Procedure>(&mut self, procedure: &mut P) -> P::Output {
        run(procedure, self, Policy::default()).unwrap()
    }
}

impl Transport for Nonsense {
    type Error = &'static str;

    fn upload(&mut self, _: Address, into: &mut [u8], _: Duration) -> Outcome<usize> {
        self.count();
        let length = match self.random() % 8 {
            0 => return Err(self.refusal()),
            1 => 0,
            2 => 255,
            3 => usize::MAX,
            n => [1, 2, 4, 8][usize::try_from(n - 4).unwrap()],
        };
        let small = self.random() % 2 == 0;
        for byte in into.iter_mut() {
            let random = u8::try_from(self.random() % 256).unwrap();
            *byte = if small { random % 4 } else { random };
        }
        Ok(length)
    }

    fn download(&mut self, _: Address, _: &[u8], _: Duration) -> Outcome<()> {
        self.count();
        if self.random() % 4 == 0 {
            return Err(self.refusal());
        }
        Ok(())
    }

    fn exchange(&mut self, _: &[u8], _: &mut [u8]) -> Outcome<usize> {
        Err(self.refusal())
    }

    fn now(&mut self) -> Instant {
        Instant::from_micros(u64::try_from(self.asked).unwrap())
    }

    fn wait(&mut self, _: Instant) {
        self.count();
    }
}
