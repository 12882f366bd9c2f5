//! The client of a drive: what a program does with it, over any bus.

pub mod axis;

pub use axis::{Axis, AxisPolicy};
