//! One entry more than the drive maps.
//~ E0080: PDO layout `Command` has more entries than the 2 that the drive can map
use drivewright_runtime::prelude::*;

const CONTROLWORD: Object<u16, Rw, Rx, Raw> = Object::new(0x6040, 0);
const MODE: Object<i8, Rw, Rx, Raw> = Object::new(0x6060, 0);
const TARGET: Object<i32, Rw, Rx, UserPosition> = Object::new(0x607A, 0);

pdo_layout! {
    /// Three where two fit.
    pub struct Command: Rx, entries <= 2, bytes <= 8 {
        /// Controlword.
        controlword: u16 = CONTROLWORD,
        /// Mode.
        mode: i8 = MODE,
        /// Target.
        target: i32 = TARGET,
    }
}

fn main() {}
