//! A checked constant that is no whole number.
//~ E0277: `f32` is no whole number, so its constants cannot be checked
use drivewright_runtime::prelude::*;

const GAIN: Object<f32, Rw, Unmapped, Raw> = Object::new(0x2000, 0);

constant! {
    /// One and a half.
    pub const HIGH: f32 = GAIN => 1.5;
}

fn main() {}
