//! Objects, process data and tables of a drive.

use core::hint::black_box;

use drivewright_runtime::pdo::compare;
use drivewright_runtime::prelude::*;
use drivewright_runtime::AbortCode;

bit_field! {
    /// Controlword.
    pub struct Controlword(u16) {
        /// Enable operation.
        ENABLE_OPERATION: 3,
        /// Bits whose meaning depends on the mode.
        MODE_SPECIFIC: 4..=6,
    }
}

const CONTROLWORD: Object<Controlword, Rw, Rx, Raw> = Object::new(0x6040, 0);
const TARGET: Object<i32, Rw, Rx, UserPosition> = Object::new(0x607A, 0);
const VELOCITY: Object<u32, Rw, RxTx, Velocity> = Object::new(0x6081, 0).range(0, 60_000).scale(1, 10);
const PROBE: Object<I24, Rw, RxTx, Raw> = Object::new(0x2000, 0);
const ENABLE: Object<bool, Rw, Unmapped, Raw> = Object::new(0x2001, 0);
const OPTION: Object<i16, Rw, RxTx, Raw> = Object::new(0x605A, 0).range(0, 8).allow(&[0, 1, 5]);
const NAME: Object<VisibleString, Const, Unmapped, Raw> = Object::new(0x1008, 0);

pdo_layout! {
    /// What the drive receives.
    pub struct Command: Rx, entries <= 5, bytes <= 16 {
        /// Controlword.
        controlword: Controlword = CONTROLWORD,
        /// Target position.
        target: i32 = TARGET,
        /// Velocity.
        velocity: u32 = VELOCITY,
        /// Probe.
        probe: I24 = PROBE,
        /// Option.
        option: i16 = OPTION,
    }
}

static OBJECTS: [ObjectDesc<'static>; 2] = [
    ObjectDesc::new(TARGET.address(), DataType::INTEGER32, Access::Rw, Mapping::Rx, "Target position")
        .values(3),
    ObjectDesc::new(VELOCITY.address(), DataType::UNSIGNED32, Access::Rw, Mapping::Rx, "Velocity").unit(1),
];
static ALARMS: [AlarmDesc<'static>; 1] = [AlarmDesc::new("OF", 0x25, 0x8611, "following error exceeded")];
static HOMING: [HomingDesc<'static>; 2] = [HomingDesc::new(1), HomingDesc::new(2).with_same(1)];
static MODEL: DriveModel<'static> = DriveModel::new(Identity::new("none", "none", "none"))
    .with_objects(&OBJECTS)
    .with_alarms(&ALARMS)
    .with_homing(&HOMING);

fn convert() {
    let scale = Scale::<UserPosition, Angle>::new(black_box(1), black_box(10_000));
    if let Some(scale) = scale.and_then(|s| s.times(black_box(3), black_box(7))) {
        black_box(TARGET.raw_with(&scale, black_box(Value::degrees(45))).is_ok());
        black_box(TARGET.raw_nearest_with(&scale, black_box(Value::degrees(45))).is_ok());
        black_box(TARGET.value_with(&scale, black_box(5)).is_ok());
    }
    black_box(VELOCITY.raw_from(black_box(Value::rpm(3_000))).is_ok());
    black_box(VELOCITY.raw_nearest(black_box(Value::rpm(3_000))).is_ok());
    black_box(VELOCITY.value_of(black_box(30_000)).is_ok());
}

fn transfer(bytes: &mut [u8]) {
    black_box(VELOCITY.encode(black_box(70_000), bytes).is_ok());
    black_box(VELOCITY.decode(bytes).is_ok());
    black_box(OPTION.encode(black_box(2), bytes).is_ok());
    black_box(PROBE.decode(bytes).is_ok());
    black_box(ENABLE.decode(bytes).is_ok());
    black_box(NAME.decode(bytes).is_ok_and(|t| t.as_str().is_ok()));
    let data_type = DataType(black_box(7));
    black_box(data_type.decode_int(bytes).is_ok());
    black_box(data_type.encode_int(black_box(5), bytes).is_ok());
}

fn process(bytes: &mut [u8]) {
    if let Ok(command) = Command::unpack_from(bytes) {
        let controlword = command.controlword.with(Controlword::ENABLE_OPERATION, black_box(true));
        let controlword = controlword.set(Controlword::MODE_SPECIFIC, black_box(9)).unwrap_or(controlword);
        let next = Command { controlword, ..command };
        black_box(next.checked_pack().is_ok());
        black_box(next.pack_into(bytes).is_ok());
    }
    black_box(compare(&Command::MAPPING, black_box([0x6040_0010, 0x6060_0010])).is_ok());
}

fn look_up() {
    if let Some(object) = MODEL.object(black_box(TARGET.address())) {
        black_box((
            MODEL.unit_of(object),
            MODEL.enum_of(object),
            MODEL.bits_of(object),
            object.accepts(black_box(9)),
        ));
        black_box((
            MODEL.default_of(object),
            MODEL.allowed_of(object),
            MODEL.entries_of(object.address()).len(),
        ));
    }
    black_box(MODEL.alarms_by_code(black_box(0x8611)).count());
    black_box(MODEL.alarm(black_box("OF"), black_box(0x25)).is_some());
    black_box(MODEL.homing(black_box(1)).map(|method| (method.status(), method.cases().len())));
    black_box(AbortCode::decode(black_box(&[0; 4])).map(AbortCode::name).is_ok());
}

/// Everything of this file.
pub fn run() {
    let mut memory = [0; 64];
    let length = black_box(16_usize).min(memory.len());
    if let Some(bytes) = memory.get_mut(..length) {
        transfer(bytes);
        process(bytes);
    }
    convert();
    look_up();
}
