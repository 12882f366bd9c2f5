//! A procedure on a bus that answers as it likes.

use core::convert::Infallible;
use core::hint::black_box;
use core::time::Duration;

use drivewright_runtime::procedure::{run as on, Answer, Ask, Policy, Procedure};
use drivewright_runtime::time::Instant;
use drivewright_runtime::transport::{Refusal, Transport};
use drivewright_runtime::{AbortCode, Address};

/// A bus whose every answer is a number from outside.
pub struct Anything;

fn any<T>(value: T) -> Result<T, Refusal<Infallible>> {
    match black_box(0_u8) {
        0 => Ok(black_box(value)),
        1 => Err(Refusal::NoAnswer),
        2 => Err(Refusal::TooLong),
        _ => Err(Refusal::Abort(AbortCode(black_box(0)))),
    }
}

impl Transport for Anything {
    type Error = Infallible;

    fn upload(&mut self, _: Address, into: &mut [u8], _: Duration) -> Result<usize, Refusal<Infallible>> {
        black_box(into);
        any(usize::MAX)
    }

    fn download(&mut self, _: Address, data: &[u8], _: Duration) -> Result<(), Refusal<Infallible>> {
        black_box(data);
        any(())
    }

    fn exchange(&mut self, outputs: &[u8], inputs: &mut [u8]) -> Result<usize, Refusal<Infallible>> {
        black_box((outputs, inputs));
        any(usize::MAX)
    }

    fn now(&mut self) -> Instant {
        Instant::from_micros(black_box(u64::MAX))
    }

    fn wait(&mut self, until: Instant) {
        black_box(until);
    }
}

/// Asks for one thing after the other and takes what comes.
struct Everything(u8);

impl Procedure for Everything {
    type Output = usize;

    fn next(&mut self, now: Instant, answer: Answer<'_>) -> Ask<'_, usize> {
        self.0 = self.0.saturating_add(1);
        let bytes = match answer {
            Answer::Data(bytes) | Answer::Inputs(bytes) => bytes.len(),
            _ => 0,
        };
        match black_box(self.0) {
            0 => Ask::Upload(Address::new(0x6041, 0)),
            1 => Ask::Download(Address::new(0x6040, 0), &[6, 0]),
            2 => Ask::Exchange(&[0; 8]),
            3 => Ask::Wait(now.after(Duration::from_millis(1))),
            _ => Ask::Done(bytes),
        }
    }
}

/// Everything of this file.
pub fn run() {
    black_box(on(&mut Everything(0), &mut Anything, Policy::default()).is_ok());
}
