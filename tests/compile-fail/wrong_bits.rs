//! A bit of the other word.
//~ E0308: Statusword
//~ E0308
use drivewright_runtime::prelude::*;

bit_field! {
    /// Controlword.
    pub struct Controlword(u16) {
        /// Halt.
        HALT: 8,
        /// Mode specific.
        MODE_SPECIFIC: 4..=6,
    }
}
bit_field! {
    /// Statusword.
    pub struct Statusword(u16) {
        /// Target reached.
        TARGET_REACHED: 10,
    }
}

fn main() {
    let _ = Controlword(0).is(Statusword::TARGET_REACHED);
    let _ = Controlword(0).is(Controlword::MODE_SPECIFIC);
}
