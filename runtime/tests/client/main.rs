//! The client against scripted drives: tests named `bNN_` are the bugs of CiA 402 libraries that recur.

// Helpers of tests: what a test did not expect fails it.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
// A test decodes what it has made itself.
#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]

mod bugs;
mod bus;
mod drives;
mod fake;
mod nonsense;
mod states;
