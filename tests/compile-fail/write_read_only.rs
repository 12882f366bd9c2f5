//! A write of an object that the drive only reports.
//~ E0277: object is read-only: the drive refuses a write with abort 0601 0002
use drivewright_runtime::prelude::*;

const POSITION: Object<i32, Ro, Tx, UserPosition> = Object::new(0x6064, 0);

fn main() {
    let _ = POSITION.encode(0, &mut [0; 4]);
}
