//! Constants that the drive would refuse.
//~ E0080: constant `RAW` is outside the range that the drive accepts
//~ E0080: constant `PHYSICAL` is outside the range that the drive accepts
use drivewright_runtime::prelude::*;

const PROFILE_VELOCITY: Object<u32, Rw, RxTx, Velocity> = Object::new(0x6081, 0).range(0, 60_000).scale(1, 10);

constant! {
    /// One count above the limit.
    pub const RAW: u32 = PROFILE_VELOCITY => 60_001;
    /// A tenth of a revolution a minute above the limit.
    pub const PHYSICAL: u32 = PROFILE_VELOCITY => physical(Value::rpm(6_001));
}

fn main() {}
