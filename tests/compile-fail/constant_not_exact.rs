//! A constant between two counts.
//~ E0080: constant `SLOW` is not a whole number of counts of its object
use drivewright_runtime::prelude::*;

const PROFILE_VELOCITY: Object<u32, Rw, RxTx, Velocity> = Object::new(0x6081, 0).range(0, 60_000).scale(7, 1);

constant! {
    /// No multiple of seven.
    pub const SLOW: u32 = PROFILE_VELOCITY => physical(Value::rpm(10));
}

fn main() {}
