//! The tables of a generated crate, and texts made of them.

use core::fmt::{self, Write};
use core::hint::black_box;

use drivewright_runtime::cia402::{Cause, Controlword, Mode, Options, State, Statusword, Transition};
use drivewright_runtime::prelude::*;
use drivewright_runtime::AbortCode;
use savch_sdv3_e::{alarms, bits, enums, od, pdo, MODEL};

/// Where a panel or a serial port would be.
pub struct Lines(pub usize);

impl Write for Lines {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0 = self.0.wrapping_add(black_box(text).len());
        Ok(())
    }
}

fn frames(bytes: &mut [u8]) {
    let frame = pdo::Rx1 {
        control_word: bits::Controlword(black_box(0x0F)),
        target_position: black_box(1_000),
        target_velocity: black_box(0),
        target_torque: black_box(0),
        modes_of_operation: enums::ModeOfOperation::CYCLE_SYNCHRONIZED_POSITION_MODE,
    };
    black_box(frame.pack_into(bytes).is_ok());
    black_box(pdo::Tx1::unpack_from(bytes).is_ok());
    black_box(od::PROFILE_VELOCITY.encode(black_box(70_000), bytes).is_ok());
}

fn texts(lines: &mut Lines) -> fmt::Result {
    for alarm in MODEL.alarms_by_code(black_box(0x8102)) {
        write!(lines, "{} {:?} {:04X}h", alarm.name(), alarm.reset(), alarm.code())?;
    }
    for case in MODEL.homing(black_box(1)).into_iter().flat_map(|m| m.cases()) {
        write!(lines, "{}: {}", case.when(), case.moves())?;
    }
    alarms::ALARM_TEXTS.iter().flat_map(|t| t.remedies()).try_for_each(|remedy| lines.write_str(remedy))?;
    write!(lines, "{} {}", Statusword(black_box(0x0237)), Controlword(black_box(0x000F)))?;
    write!(lines, "{:?} {}", Mode(black_box(-3)), AbortCode(black_box(0x0602_0000)))?;
    let made = Transition::of(State::Fault, black_box(Cause::Fault), Options::default());
    made.map_or(Ok(()), |made| write!(lines, "{made}"))
}

/// Everything of this file.
pub fn run() {
    let mut memory = [0; 64];
    let length = black_box(64_usize).min(memory.len());
    frames(memory.get_mut(..length).unwrap_or_default());
    let mut lines = Lines(0);
    black_box(texts(&mut lines).is_ok());
    for object in MODEL.objects() {
        black_box((MODEL.default_of(object), MODEL.unit_of(object), object.accepts(black_box(9))));
    }
}
