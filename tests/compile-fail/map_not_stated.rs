//! An object of which the manual does not say whether it can be mapped.
//~ E0277: object cannot be mapped into an RxPDO: the drive refuses the entry with abort 0604 0041
use drivewright_runtime::prelude::*;

const GAIN: Object<u16, Rw, MapNotStated, Raw> = Object::new(0x2101, 0);

pdo_layout! {
    /// A guess.
    pub struct Command: Rx {
        /// Gain.
        gain: u16 = GAIN,
    }
}

fn main() {}
