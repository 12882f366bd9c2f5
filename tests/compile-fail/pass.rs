//! What all of the others get wrong, done right.
use drivewright_runtime::prelude::*;

bit_field! {
    /// Controlword.
    pub struct Controlword(u16) {
        /// Halt.
        HALT: 8,
    }
}
wire_enum! {
    /// Mode of operation.
    pub struct ModeOfOperation(i8) = "mode of operation" {
        /// Homing.
        HOMING = 6 => "homing",
    }
}

const CONTROLWORD: Object<Controlword, Rw, Rx, Raw> = Object::new(0x6040, 0);
const MODE: Object<ModeOfOperation, Rw, RxTx, Raw> = Object::new(0x6060, 0).allow(&[1, 6]);
const TARGET: Object<i32, Rw, Rx, UserPosition> = Object::new(0x607A, 0);
const SPEED: Object<u32, Rw, RxTx, Velocity> = Object::new(0x6081, 0).range(0, 60_000).scale(1, 10);

pdo_layout! {
    /// Exactly at its limits.
    pub struct Command: Rx, entries <= 4, bytes <= 11 {
        /// Controlword.
        controlword: Controlword = CONTROLWORD,
        /// Mode.
        mode: ModeOfOperation = MODE,
        /// Target.
        target: i32 = TARGET,
        /// Speed.
        speed: u32 = SPEED,
    }
}

constant! {
    /// Exactly at the limit.
    pub const FAST: u32 = SPEED => physical(Value::rpm(6_000));
    /// One that the drive lists.
    pub const HOMING: ModeOfOperation = MODE => ModeOfOperation::HOMING;
}

fn main() {
    let scale = Scale::<UserPosition, Angle>::new(1, 10_000).unwrap();
    let target = TARGET.raw_with(&scale, Value::revolutions(2)).unwrap();
    let controlword = Controlword(0x000F).with(Controlword::HALT, true);
    let command = Command { controlword, mode: HOMING, target, speed: FAST };
    let frame = command.checked_pack().unwrap();
    assert_eq!(frame, [0x0F, 0x01, 6, 0x20, 0x4E, 0, 0, 0x60, 0xEA, 0, 0]);
    assert_eq!(Command::unpack(&frame), command);
    assert!(Command { mode: ModeOfOperation(3), ..command }.checked_pack().is_err());
}
