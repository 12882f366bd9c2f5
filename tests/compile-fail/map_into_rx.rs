//! An object that the drive only sends, in a layout that it receives.
//~ E0277: object cannot be mapped into an RxPDO: the drive refuses the entry with abort 0604 0041
use drivewright_runtime::prelude::*;

const STATUSWORD: Object<u16, Ro, Tx, Raw> = Object::new(0x6041, 0);

pdo_layout! {
    /// Wrong way round.
    pub struct Command: Rx {
        /// Statusword.
        statusword: u16 = STATUSWORD,
    }
}

fn main() {}
