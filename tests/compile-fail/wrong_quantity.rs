//! A torque for a velocity, and a user velocity scaled as an angle.
//~ E0308: TorqueRatio
//~ E0277: cannot be expressed as
use drivewright_runtime::prelude::*;

const SPEED: Object<i32, Rw, Rx, Velocity> = Object::new(0x60FF, 0).scale(1, 10);

fn main() {
    let _ = SPEED.raw_from(Value::percent_torque(5));
    let _ = Scale::<UserVelocity, Angle>::new(1, 10_000);
}
