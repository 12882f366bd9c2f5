//! An object that no process data may carry, in a layout that the drive sends.
//~ E0277: object cannot be mapped into a TxPDO: the drive refuses the entry with abort 0604 0041
use drivewright_runtime::prelude::*;

const SERIAL: Object<u32, Ro, Unmapped, Raw> = Object::new(0x1018, 4);

pdo_layout! {
    /// Not process data.
    pub struct Report: Tx {
        /// Serial number.
        serial: u32 = SERIAL,
    }
}

fn main() {}
