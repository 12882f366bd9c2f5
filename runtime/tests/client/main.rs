//! The client against scripted drives: tests named `bNN_` are the bugs of CiA 402 libraries that recur.

// Helpers of tests: what a test did not expect fails it.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod fake;
mod states;
