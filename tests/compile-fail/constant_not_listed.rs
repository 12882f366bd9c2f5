//! Constants within the range of an object, but not among the values that its drive lists.
//~ E0080: constant `RAW` is not one of the values that the drive accepts
//~ E0080: constant `NAMED` is not one of the values that the drive accepts
use drivewright_runtime::prelude::*;

wire_enum! {
    /// Quick stop option.
    pub struct QuickStop(i16) = "quick stop option" {
        /// Not in this drive.
        CURRENT_LIMIT = 3 => "current limit",
    }
}

const BAUD_RATE: Object<u8, Rw, Unmapped, Raw> = Object::new(0x2000, 0).range(0, 8).allow(&[0, 1, 5]);
const QUICK_STOP: Object<QuickStop, Rw, Unmapped, Raw> = Object::new(0x605A, 0).range(0, 8).allow(&[0, 1, 5]);

constant! {
    /// Between two of them.
    pub const RAW: u8 = BAUD_RATE => 3;
    /// Has a name, and is not allowed all the same.
    pub const NAMED: QuickStop = QUICK_STOP => QuickStop::CURRENT_LIMIT;
}

fn main() {}
