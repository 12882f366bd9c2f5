//! The seventeenth bit of sixteen.
//~ E0080: bit field `Statusword` names a bit that its number does not have
use drivewright_runtime::prelude::*;

bit_field! {
    /// Statusword.
    pub struct Statusword(u16) {
        /// In the next word.
        LOST: 16,
    }
}

fn main() {}
