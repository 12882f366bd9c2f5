//! A constant for an object that nobody can write.
//~ E0277: object is read-only: the drive refuses a write with abort 0601 0002
use drivewright_runtime::prelude::*;

const SPEED: Object<i32, Ro, Tx, Velocity> = Object::new(0x606C, 0);

constant! {
    /// For nothing.
    pub const SLOW: i32 = SPEED => 10;
}

fn main() {}
