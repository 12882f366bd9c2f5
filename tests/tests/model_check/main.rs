//! Everything that can happen to a client, a drive and the line between them, for every goal: searched, not sampled.
//!
//! The client is the real one, [`Axis`](drivewright_runtime::client::axis::Axis). The drive is small and made of the transitions of the
//! standard. In each cycle the sample may be lost or be an old one, the outputs may be lost or be old ones, the drive may
//! take its time, and it may fault. What is promised is checked in every state that can be reached:
//!
//! - nothing comes into operation with a target that makes the axis jump, nor without having been asked;
//! - bit 7 rises for a fault reset alone, bit 4 for a move and for homing alone;
//! - what is done is done: operation, home, a set-point that was taken;
//! - from every state a line that works again leads to an end.

#![allow(clippy::expect_used, clippy::panic, reason = "a search that cannot go on fails the test")]

mod controls;
mod drive;
mod goal;
mod promises;
mod search;
mod world;
