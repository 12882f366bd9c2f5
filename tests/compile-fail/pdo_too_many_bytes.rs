//! Ten bytes in a CAN frame.
//~ E0080: PDO layout `Command` is longer than the 8 bytes that the drive can map
use drivewright_runtime::prelude::*;

const CONTROLWORD: Object<u16, Rw, Rx, Raw> = Object::new(0x6040, 0);
const TARGET: Object<i32, Rw, Rx, UserPosition> = Object::new(0x607A, 0);
const SPEED: Object<u32, Rw, Rx, UserVelocity> = Object::new(0x6081, 0);

pdo_layout! {
    /// Ten where eight fit.
    pub struct Command: Rx, entries <= 8, bytes <= 8 {
        /// Controlword.
        controlword: u16 = CONTROLWORD,
        /// Target.
        target: i32 = TARGET,
        /// Speed.
        speed: u32 = SPEED,
    }
}

fn main() {}
