//! A torque for a velocity, and a user velocity scaled as an angle.
//~ error[E0308]: mismatched types
//~ expected `Value<Velocity>`, found `Value<TorqueRatio>`
//~ error[E0277]: `drivewright_runtime::quantity::UserVelocity` cannot be expressed as `drivewright_runtime::quantity::Angle`
use drivewright_runtime::prelude::*;

const SPEED: Object<i32, Rw, Rx, Velocity> = Object::new(0x60FF, 0).scale(1, 10);

fn main() {
    let _ = SPEED.raw_from(Value::percent_torque(5));
    let _ = Scale::<UserVelocity, Angle>::new(1, 10_000);
}
