//! Revolutions for an object whose counts depend on the gear of the drive.
//~ E0308: Angle
//~ E0277: has no fixed unit: one count depends on gear objects of the drive, or the manual states no unit
use drivewright_runtime::prelude::*;

const TARGET: Object<i32, Rw, Rx, UserPosition> = Object::new(0x607A, 0);

fn main() {
    let _ = TARGET.raw_from(Value::revolutions(1));
    let _ = TARGET.value_of(1);
}
