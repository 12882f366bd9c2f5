//! A single bit in a layout of whole bytes.
//~ E0080: PDO layout `Command`: every entry must have a fixed length of whole bytes
use drivewright_runtime::prelude::*;

const ENABLE: Object<bool, Rw, Rx, Raw> = Object::new(0x2000, 1);

pdo_layout! {
    /// One bit.
    pub struct Command: Rx {
        /// Enable.
        enable: bool = ENABLE,
    }
}

fn main() {}
