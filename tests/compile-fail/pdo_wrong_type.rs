//! A field that is wider than its object: every later value would be two bytes off.
//~ E0308: TorqueRatio
//~ E0308
use drivewright_runtime::prelude::*;

const TORQUE: Object<i16, Ro, Tx, TorqueRatio> = Object::new(0x6077, 0).scale(1, 1_000);

pdo_layout! {
    /// Two bytes too many.
    pub struct Report: Tx {
        /// Torque.
        torque: i32 = TORQUE,
    }
}

fn main() {}
