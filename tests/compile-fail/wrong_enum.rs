//! The value of another object.
//~ E0308: HomingMethod
//~ E0308
use drivewright_runtime::prelude::*;

wire_enum! {
    /// Mode of operation.
    pub struct ModeOfOperation(i8) = "mode of operation" {
        /// Homing.
        HOMING = 6 => "homing",
    }
}
wire_enum! {
    /// Homing method.
    pub struct HomingMethod(i8) = "homing method" {
        /// Current position.
        CURRENT_POSITION = 35 => "current position",
    }
}

const MODE: Object<ModeOfOperation, Rw, Rx, Raw> = Object::new(0x6060, 0);

fn main() {
    let _ = MODE.encode(HomingMethod::CURRENT_POSITION, &mut [0; 1]);
    let _ = MODE.encode(6, &mut [0; 1]);
}
