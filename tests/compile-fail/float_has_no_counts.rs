//! A physical value of a floating point number.
//~ E0277: `f32` is no whole number, so it has neither counts nor a scale
use drivewright_runtime::prelude::*;

const SPEED: Object<f32, Rw, Unmapped, Velocity> = Object::new(0x2000, 0);

fn main() {
    let _ = SPEED.raw_from(Value::rpm(1));
}
