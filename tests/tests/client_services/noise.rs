//! The virtual drive over a bus that loses answers, cuts them, and makes abort codes up: every service ends, and says how.

use std::convert::Infallible;
use std::time::Duration;

use drivewright_runtime::client::compare::Compare;
use drivewright_runtime::client::fault::ReadFault;
use drivewright_runtime::client::identify::{Identify, ProfileMatch};
use drivewright_runtime::client::layout::{Mapped, Plan, ReadBack, Write as WriteLayout};
use drivewright_runtime::client::object::Read;
use drivewright_runtime::client::parameters::{Apply, Setting, Slot};
use drivewright_runtime::mapping::Direction;
use drivewright_runtime::procedure::{Policy, run};
use drivewright_runtime::sim::Link;
use drivewright_runtime::time::Instant;
use drivewright_runtime::transport::{Refusal, Transport};
use drivewright_runtime::{AbortCode, Address};
use drivewright_tests::random::Random;
use savch_sdv3_e::{MODEL, od};

use crate::{at, with_drive};

/// A bus on which one transfer of `one_in` goes wrong.
struct Noisy<'l, 'd, 'm, 's> {
    link: &'l mut Link<'d, 'm, 's>,
    random: Random,
    one_in: usize,
}

impl Noisy<'_, '_, '_, '_> {
    /// What goes wrong with this transfer; `None`: nothing.
    fn trouble(&mut self) -> Option<Refusal<Infallible>> {
        if self.random.below(self.one_in) != 0 {
            return None;
        }
        let made_up = u32::try_from(self.random.below(usize::from(u16::MAX))).unwrap();
        Some(match self.random.below(4) {
            0 => Refusal::Abort(AbortCode(made_up << 8)),
            1 => Refusal::Abort(AbortCode::GENERAL),
            2 => Refusal::TooLong,
            _ => Refusal::NoAnswer,
        })
    }
}

impl Transport for Noisy<'_, '_, '_, '_> {
    type Error = Infallible;

    fn upload(
        &mut self,
        address: Address,
        into: &mut [u8],
        within: Duration,
    ) -> Result<usize, Refusal<Infallible>> {
        match self.trouble() {
            // A cut answer.
            Some(Refusal::TooLong) => self.link.upload(address, into, within).map(|n| n / 2),
            Some(refusal) => Err(refusal),
            None => self.link.upload(address, into, within),
        }
    }

    fn download(
        &mut self,
        address: Address,
        data: &[u8],
        within: Duration,
    ) -> Result<(), Refusal<Infallible>> {
        match self.trouble() {
            // The write arrives, its answer does not.
            Some(Refusal::NoAnswer) => self.link.download(address, data, within).and(Err(Refusal::NoAnswer)),
            Some(refusal) => Err(refusal),
            None => self.link.download(address, data, within),
        }
    }

    fn exchange(&mut self, outputs: &[u8], inputs: &mut [u8]) -> Result<usize, Refusal<Infallible>> {
        self.link.exchange(outputs, inputs)
    }

    fn now(&mut self) -> Instant {
        Transport::now(self.link)
    }

    fn wait(&mut self, until: Instant) {
        Transport::wait(self.link, until);
    }
}

#[test]
fn every_service_ends_on_a_bad_bus_and_never_claims_what_is_not_so() {
    for seed in 0..200 {
        with_drive(|link| {
            let mut bus = Noisy { link, random: Random::new(seed), one_in: 4 };
            let policy = Policy::default();
            let found = run(&mut Identify::new(&MODEL), &mut bus, policy).unwrap();
            let outcome = found.against(&MODEL);
            assert!(matches!(outcome, ProfileMatch::Exact | ProfileMatch::Mismatch(_)), "{outcome:?}");
            run(&mut Compare::new(&MODEL, |_| {}), &mut bus, policy).unwrap().map_err(|e| e.to_string()).ok();
            run(&mut ReadFault::new(&MODEL), &mut bus, policy).unwrap().map_err(|e| e.to_string()).ok();
            apply(&mut bus);
            layout(&mut bus);
        });
    }
}

/// What is said to be written is written; what is said not to be is not, unless its answer was lost.
fn apply(bus: &mut Noisy<'_, '_, '_, '_>) {
    let wanted = [Setting::number(at(0x6081, 0), 20_000), Setting::number(at(0x6098, 0), 17)];
    let mut slots = [Slot::EMPTY; 16];
    let mut apply = Apply::new(&MODEL, &wanted, &[], &mut slots).unwrap();
    let result = run(&mut apply, bus, Policy::default()).unwrap();
    let written: Vec<Address> = apply.written().collect();
    let speed = run(&mut Read::new(od::PROFILE_VELOCITY), bus.link, Policy::default()).unwrap().unwrap();
    match result {
        Ok(applied) => assert_eq!((applied.written, speed), (2, 20_000)),
        Err(error) => {
            assert_eq!(error.written, written.len());
            assert!(!apply.explain(&error).to_string().is_empty());
        }
    }
    assert!(!written.contains(&at(0x6081, 0)) || speed == 20_000);
}

/// A layout that was read back is there.
fn layout(bus: &mut Noisy<'_, '_, '_, '_>) {
    let shipped = [Mapped::shipped(MODEL.pdo(at(0x1A02, 0)).unwrap())];
    let plan = Plan::new(Direction::Tx, &shipped);
    bus.link.drive().request(drivewright_runtime::model::EsmState::PreOp).unwrap();
    let written = run(&mut WriteLayout::new(&MODEL, plan).unwrap(), bus, Policy::default()).unwrap();
    let noisy = run(&mut ReadBack::new(&MODEL, plan), bus, Policy::default()).unwrap();
    let true_one = run(&mut ReadBack::new(&MODEL, plan), bus.link, Policy::default()).unwrap();
    assert!(written.is_err() || true_one.is_ok(), "{written:?} {true_one:?}");
    assert!(noisy.is_err() || true_one.is_ok(), "{noisy:?} {true_one:?}");
}
