//! The client of a drive: what a program does with it, over any bus.

pub mod axis;
pub mod image;

pub use axis::{Axis, AxisPolicy};
pub use image::Image;
