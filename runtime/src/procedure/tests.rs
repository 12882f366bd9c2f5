//! One procedure on both kinds of bus.

use super::*;
use std::vec::Vec;

/// Reads 6041h once and gives what became of it.
struct Read;

impl Procedure for Read {
    type Output = Result<u16, &'static str>;

    fn next(&mut self, _: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        match answer {
            Answer::Begin => Ask::Upload(Address::new(0x6041, 0)),
            Answer::Data(&[low, high]) => Ask::Done(Ok(u16::from_le_bytes([low, high]))),
            Answer::Abort(_) => Ask::Done(Err("refused")),
            Answer::TooLong => Ask::Done(Err("too long")),
            _ => Ask::Done(Err("no answer")),
        }
    }
}

/// A bus that gives these results one after the other.
struct Script(Vec<Result<usize, Refusal<&'static str>>>);

impl Transport for Script {
    type Error = &'static str;

    fn upload(&mut self, _: Address, into: &mut [u8], _: Duration) -> Result<usize, Refusal<&'static str>> {
        into[..2].copy_from_slice(&[0x37, 0x12]);
        if self.0.is_empty() {
            return Err(Refusal::Link("asked too often"));
        }
        self.0.remove(0)
    }

    fn download(&mut self, _: Address, _: &[u8], _: Duration) -> Result<(), Refusal<&'static str>> {
        Err(Refusal::NoAnswer)
    }

    fn exchange(&mut self, _: &[u8], _: &mut [u8]) -> Result<usize, Refusal<&'static str>> {
        Err(Refusal::NoAnswer)
    }

    fn now(&mut self) -> Instant {
        Instant::START
    }

    fn wait(&mut self, _: Instant) {}
}

fn read(
    results: Vec<Result<usize, Refusal<&'static str>>>,
) -> Result<Result<u16, &'static str>, &'static str> {
    run(&mut Read, &mut Script(results), Policy::default())
}

#[test]
fn an_answer_comes_after_as_many_tries_as_the_policy_has() {
    let lost = Err(Refusal::NoAnswer);
    assert_eq!(read(std::vec![Ok(2)]), Ok(Ok(0x1237)));
    assert_eq!(read(std::vec![lost, lost, Ok(2)]), Ok(Ok(0x1237)));
    assert_eq!(read(std::vec![lost, lost, lost, Ok(2)]), Ok(Err("no answer")));
}

#[test]
fn what_is_refused_is_not_tried_again() {
    assert_eq!(read(std::vec![Err(Refusal::Abort(AbortCode::NO_OBJECT)), Ok(2)]), Ok(Err("refused")));
    assert_eq!(read(std::vec![Err(Refusal::Link("cable")), Ok(2)]), Err("cable"));
    assert_eq!(read(std::vec![Err(Refusal::TooLong), Ok(2)]), Ok(Err("too long")));
}

#[test]
fn a_bus_that_claims_more_than_there_is_is_not_believed() {
    assert_eq!(read(std::vec![Ok(usize::MAX)]), Ok(Err("too long")));
    assert_eq!(read(std::vec![Ok(0)]), Ok(Err("no answer")));
}
