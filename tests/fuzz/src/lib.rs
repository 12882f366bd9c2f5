//! Feeds the compiler, the client and the virtual drive what nobody would write.
//!
//! [`targets`] are plain functions of bytes that panic where a promise is broken: libFuzzer calls them with what it finds,
//! [`run`](run::run) with inputs that a stable generator makes, the same on every machine.

pub mod behaviour;
pub mod input;
pub mod judge;
pub mod run;
pub mod targets;
