//! A program without std, allocator and start files that uses the runtime the way firmware does.
//!
//! It is built, not run. Its own panic handler collides with that of std (E0152) as soon as anything links std.
#![no_std]
#![no_main]

use core::fmt::Write;
use core::hint::black_box;
use core::panic::PanicInfo;

use drivewright_runtime::pdo::compare;
use drivewright_runtime::prelude::*;

bit_field! {
    /// Controlword.
    pub struct Controlword(u16) {
        /// Enable operation.
        ENABLE_OPERATION: 3,
    }
}

wire_enum! {
    /// Mode of operation.
    pub struct ModeOfOperation(i8) = "mode of operation" {
        /// Cyclic synchronous position.
        CYCLIC_POSITION = 8 => "cyclic synchronous position",
    }
}

const CONTROLWORD: Object<Controlword, Rw, Rx, Raw> = Object::new(0x6040, 0);
const MODE: Object<ModeOfOperation, Rw, Rx, Raw> = Object::new(0x6060, 0);
const TARGET: Object<i32, Rw, Rx, UserPosition> = Object::new(0x607A, 0);
const OPTION: Object<i16, Rw, Unmapped, Raw> = Object::new(0x605A, 0).allow(&[0, 1, 5]);
const VELOCITY: Object<u32, Rw, RxTx, Velocity> = Object::new(0x6081, 0).range(0, 60_000).scale(1, 10);

pdo_layout! {
    /// What the drive receives.
    pub struct Command: Rx, entries <= 4, bytes <= 8 {
        /// Controlword.
        controlword: Controlword = CONTROLWORD,
        /// Mode.
        mode: ModeOfOperation = MODE,
        /// Target position.
        target: i32 = TARGET,
    }
}

static OBJECTS: [ObjectDesc<'static>; 1] =
    [ObjectDesc::new(TARGET.address(), DataType::INTEGER32, Access::Rw, Mapping::Rx, "Target position")];
static ALARMS: [AlarmDesc<'static>; 1] = [AlarmDesc::new("OF", 0x25, 0x8611, "following error exceeded")];
static MODEL: DriveModel<'static> =
    DriveModel::new(Identity::new("none", "none", "none")).with_objects(&OBJECTS).with_alarms(&ALARMS);

/// Where a panel or a serial port would be.
struct Lines(usize);

impl Write for Lines {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        self.0 += black_box(text).len();
        Ok(())
    }
}

fn setpoint(lines: &mut Lines) -> Result<(), core::fmt::Error> {
    let scale = Scale::<UserPosition, Angle>::new(1, black_box(10_000));
    let Some(scale) = scale else { return lines.write_str("the gear is not set") };
    match TARGET.raw_nearest_with(&scale, Value::degrees(black_box(45))) {
        Ok(target) => {
            let controlword = Controlword(0).with(Controlword::ENABLE_OPERATION, true);
            let frame = Command { controlword, mode: ModeOfOperation::CYCLIC_POSITION, target }.pack();
            write!(lines, "{:?} {:?}", Command::unpack(black_box(&frame)).mode, scale.den())
        }
        Err(error) => write!(lines, "{error}"),
    }
}

fn velocity(lines: &mut Lines) -> Result<(), core::fmt::Error> {
    let mut out = [0; 4];
    match VELOCITY.raw_from(Value::rpm(black_box(3_000))).map(|raw| VELOCITY.encode(raw, &mut out)) {
        Ok(Ok(_)) => write!(lines, "{:?}", VELOCITY.decode(black_box(&out))),
        other => write!(lines, "{other:?}"),
    }
}

fn option(lines: &mut Lines) -> Result<(), core::fmt::Error> {
    match OPTION.check(black_box(2)) {
        Ok(()) => lines.write_str("listed"),
        Err(error) => write!(lines, "{error}"),
    }
}

/// The same with a generated crate: a command, a frame, and why a drive stopped.
fn generated(lines: &mut Lines) -> Result<(), core::fmt::Error> {
    use savch_sdv3_e::{alarms, bits, enums, pdo};
    let frame = pdo::Rx1 {
        control_word: bits::Controlword(0).with(bits::Controlword::ENABLE_OPERATION, black_box(true)),
        target_position: black_box(1_000),
        target_velocity: 0,
        target_torque: 0,
        modes_of_operation: enums::ModeOfOperation::CYCLE_SYNCHRONIZED_POSITION_MODE,
    };
    write!(lines, "{:?}", black_box(frame.pack()))?;
    for alarm in savch_sdv3_e::MODEL.alarms_by_code(black_box(0x8102)) {
        write!(lines, "{} {:?}", alarm.name(), alarm.reset())?;
    }
    for case in savch_sdv3_e::MODEL.homing(black_box(1)).into_iter().flat_map(|m| m.cases()) {
        write!(lines, "{}: {}", case.when(), case.moves())?;
    }
    alarms::ALARM_TEXTS.iter().flat_map(|t| t.remedies()).try_for_each(|remedy| lines.write_str(remedy))
}

fn report(lines: &mut Lines) -> Result<(), core::fmt::Error> {
    setpoint(lines)?;
    velocity(lines)?;
    option(lines)?;
    generated(lines)?;
    if let Err(difference) = compare(&Command::MAPPING, black_box([0x6040_0010, 0x6060_0010])) {
        write!(lines, "{difference}")?;
    }
    for alarm in MODEL.alarms_by_code(black_box(0x8611)) {
        lines.write_str(alarm.name())?;
    }
    write!(lines, "{:?}", MODEL.object(black_box(TARGET.address())).map(ObjectDesc::name))
}

/// Where the program would begin.
#[no_mangle]
pub extern "C" fn _start() -> ! {
    let mut lines = Lines(0);
    let _ = report(&mut lines);
    black_box(lines.0);
    #[allow(clippy::empty_loop)]
    loop {}
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    #[allow(clippy::empty_loop)]
    loop {}
}
