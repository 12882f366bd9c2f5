//! The services of the client: objects, identity, comparison, faults, layouts, parameters. Whatever a drive answers.

use core::fmt::{self, Write as _};
use core::hint::black_box;

use drivewright_runtime::client::compare::Compare;
use drivewright_runtime::client::decode::{DigitalInputs, SupportedModes};
use drivewright_runtime::client::fault::{Emergency, Fault, ReadFault};
use drivewright_runtime::client::identify::{Identify, Verdict};
use drivewright_runtime::client::layout::{Mapped, Plan, ReadBack, Write as WriteLayout};
use drivewright_runtime::client::message::Report;
use drivewright_runtime::client::object::{Content, Read, ReadContent, Shown, Write, WriteContent};
use drivewright_runtime::client::parameters::{Apply, Columns, Setting, Slot, Store};
use drivewright_runtime::prelude::*;
use drivewright_runtime::procedure::{Answer, Ask, Procedure};
use drivewright_runtime::rule::{Op, RuleDesc, Term};
use drivewright_runtime::time::Instant;
use drivewright_runtime::AbortCode;

const SPEED: Object<u32, Rw, RxTx, Velocity> = Object::new(0x6081, 0).range(0, 60_000).scale(1, 10);

static OBJECTS: [ObjectDesc<'static>; 2] = [
    ObjectDesc::new(Address::new(0x1C12, 0), DataType::UNSIGNED8, Access::Rw, Mapping::Unmapped, "Assign"),
    ObjectDesc::new(SPEED.address(), DataType::UNSIGNED32, Access::Rw, Mapping::Rx, "Velocity")
        .range(0, 60_000),
];
static TERMS: [Term; 3] = [Term::Object(SPEED.address()), Term::Number(5), Term::Apply(Op::More)];
static RULES: [RuleDesc<'static>; 1] = [RuleDesc::new("R1", "").with_require(&TERMS)];
static ENTRIES: [MapEntry; 1] = [MapEntry::new(SPEED.address(), 32)];
static PDOS: [PdoDesc<'static>; 1] = [PdoDesc::new(Address::new(0x1600, 0), Direction::Rx, &ENTRIES)];
static ALARMS: [AlarmDesc<'static>; 1] = [AlarmDesc::new("OF", 0x25, 0x8611, "following error exceeded")];
static TEXTS: [AlarmText<'static>; 1] = [AlarmText::new("OF", 0x25, &["jammed"], &["free it", "wait"])];
static MODEL: DriveModel<'static> = DriveModel::new(Identity::new("none", "none", "none"))
    .with_objects(&OBJECTS)
    .with_rules(&RULES)
    .with_pdos(&PDOS)
    .with_alarms(&ALARMS);

/// An answer that the optimiser knows nothing of.
fn answer(memory: &[u8]) -> Answer<'_> {
    let bytes = memory.get(..black_box(4)).unwrap_or(&[]);
    match black_box(0_u8) {
        0 => Answer::Begin,
        1 => Answer::Data(bytes),
        2 => Answer::Written,
        3 => Answer::Abort(AbortCode(black_box(7))),
        4 => Answer::Waited,
        5 => Answer::TooLong,
        _ => Answer::NoAnswer,
    }
}

/// Where messages go.
struct Lines(usize);

impl fmt::Write for Lines {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0 = black_box(self.0.wrapping_add(text.len()));
        Ok(())
    }
}

/// Prints something, and its one-line form.
fn show(what: impl fmt::Display) {
    let _ = write!(Lines(0), "{what} {what:#}");
}

/// Runs a procedure for as long as it asks.
fn ended<P: Procedure>(procedure: &mut P, memory: &[u8]) -> P::Output {
    loop {
        let ask = procedure.next(Instant::from_micros(black_box(1)), answer(memory));
        if let Ask::Done(result) = ask {
            return result;
        }
        black_box(matches!(ask, Ask::Download(..)));
    }
}

/// Runs a procedure, and prints its error.
fn drive<T, E: fmt::Display, P: Procedure<Output = Result<T, E>>>(mut procedure: P, memory: &[u8]) {
    if let Err(error) = ended(&mut procedure, memory) {
        show(error);
    }
}

fn objects(memory: &[u8]) {
    drive(Read::new(SPEED), memory);
    match Write::new(SPEED, black_box(5)) {
        Ok(write) => drive(write, memory),
        Err(error) => show(error.with(&MODEL)),
    }
    let mut room = [0; 8];
    if let Ok(read) = ReadContent::new(&MODEL, black_box(SPEED.address()), &mut room) {
        drive(read, memory);
    }
    if let Ok(write) = WriteContent::new(&MODEL, black_box(SPEED.address()), Content::Int(black_box(3))) {
        drive(write, memory);
    }
    if let Some(object) = MODEL.object(black_box(SPEED.address())) {
        show(Shown::new(&MODEL, object, black_box(Content::Int(3))));
    }
}

fn device(memory: &[u8]) {
    let found = ended(&mut Identify::new(&MODEL), memory);
    show(Report::new(&Verdict::new(&MODEL, &found)));
    drive(Compare::new(&MODEL, |finding| show(finding.with(&MODEL))), memory);
    match ended(&mut ReadFault::new(&MODEL).with_emergency(Emergency(black_box([1; 8]))), memory) {
        Ok(evidence) => show(Fault::new(&MODEL, &TEXTS, evidence)),
        Err(error) => show(error),
    }
    show(SupportedModes(black_box(0x25)));
    show(DigitalInputs::new(&MODEL, black_box(0x25)));
}

fn layouts(memory: &[u8]) {
    let mapped = [Mapped::new(black_box(0x1600), black_box(&ENTRIES))];
    let plan = Plan::new(black_box(Direction::Rx), &mapped);
    let mut read = ReadBack::new(&MODEL, plan);
    if let Err(error) = ended(&mut read, memory) {
        show(read.explain(&error));
    }
    match WriteLayout::new(&MODEL, plan) {
        Ok(write) => drive(write, memory),
        Err(error) => show(error),
    }
}

fn parameters(memory: &[u8]) {
    let wanted = [Setting::number(black_box(SPEED.address()), black_box(5))];
    let mut slots = [Slot::EMPTY; 4];
    ended(&mut Columns::new(&MODEL, &wanted, |row| show(row.with(&MODEL))), memory);
    if let Ok(mut apply) = Apply::new(&MODEL, &wanted, &[], &mut slots) {
        if let Err(error) = ended(&mut apply, memory) {
            show(apply.explain(&error));
        }
        black_box(apply.effects().last());
    }
    match Store::new(&MODEL, black_box(1)) {
        Ok(store) => drive(store.neutralize(), memory),
        Err(error) => show(error),
    }
}

/// Everything of this file.
pub fn run() {
    let memory = black_box([0; 64]);
    objects(&memory);
    device(&memory);
    layouts(&memory);
    parameters(&memory);
}
