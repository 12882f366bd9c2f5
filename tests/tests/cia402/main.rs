//! CiA 402 against tables written by hand from the SDV3-E manual, section 4.1, and from the standard: every state, every
//! word, every option code.
//!
//! Nothing here is made by the code under test. A table is text, one row a line, and a naive reader turns it into masks.

#![allow(clippy::expect_used, clippy::panic, reason = "a table that cannot be read fails the test")]

mod bits;
mod commands;
mod modes;
mod options;
mod states;
mod table;
