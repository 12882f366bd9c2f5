//! A write of an object that never changes.
//~ E0277: object is read-only: the drive refuses a write with abort 0601 0002
use drivewright_runtime::prelude::*;

const DEVICE_NAME: Object<VisibleString, Const, Unmapped, Raw> = Object::new(0x1008, 0);

fn main() {
    let _ = DEVICE_NAME.encode(Text::new("mine"), &mut [0; 4]);
}
