//! The folder that `simulate` loads and the generated crate with the feature `sim` are one drive: their models are equal,
//! and so is what they do.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "a test runs the program")]

use std::path::Path;
use std::process::Command;
use std::time::Duration;

use drivewright_codegen::{compile_folder, live};
use drivewright_runtime::Address;
use drivewright_runtime::sim::VirtualDrive;
use drivewright_runtime::transport::Transport;
use savch_sdv3_e::sim::{Config, Link, MEMORY, simulated};
use serde_json::Value;

const PROFILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../profiles/savch/sdv3-e");

/// Enabled in profile velocity mode by SDO, turned, made to fault, reset. An SDO transfer takes a millisecond.
const STEPS: &[Step] = &[
    Step::Run(200),
    Step::Write(0x6060, 3, 1),
    Step::Write(0x6040, 0x06, 2),
    Step::Run(5),
    Step::Write(0x6040, 0x07, 2),
    Step::Run(5),
    Step::Write(0x6040, 0x0F, 2),
    Step::Run(5),
    Step::Write(0x60FF, 3000, 4),
    Step::Run(300),
    Step::Raise("OF", 0x25),
    Step::Run(200),
    Step::Write(0x6040, 0x00, 2),
    Step::Write(0x6040, 0x80, 2),
    Step::Run(20),
];

#[derive(Clone, Copy)]
enum Step {
    /// Milliseconds.
    Run(u64),
    /// Index, value, bytes.
    Write(u16, i32, usize),
    Raise(&'static str, u16),
}

impl Step {
    /// As a line of a script.
    fn line(self) -> String {
        match self {
            Self::Run(ms) => format!("run {ms}ms\n"),
            Self::Write(index, value, _) => format!("write {index:04X}:00 {value}\n"),
            Self::Raise(display, number) => format!("raise {display} {number}\n"),
        }
    }
}

/// What a line of the trace shows.
type Shown = (u64, u64, i64, i64, i64, i64, u64);

/// What the generated crate's drive shows each time a word or the mode changes.
fn generated() -> Vec<Shown> {
    let (mut memory, config) = (MEMORY, Config::default());
    let mut drive = simulated(&mut memory, config).expect("enough memory");
    let mut link = Link::new(&mut drive, config.cycle);
    let mut seen: Vec<Shown> = Vec::new();
    look(&mut seen, link.drive());
    for step in STEPS {
        match *step {
            Step::Run(ms) => {
                for _ in 0..ms {
                    let next = Transport::now(&mut link).after(Duration::from_millis(1));
                    Transport::wait(&mut link, next);
                    look(&mut seen, link.drive());
                }
            }
            Step::Write(index, value, bytes) => {
                let data = &value.to_le_bytes()[..bytes];
                let written =
                    Transport::download(&mut link, Address::new(index, 0), data, Duration::from_millis(500));
                written.expect("the drive takes it");
                look(&mut seen, link.drive());
            }
            Step::Raise(display, number) => link.drive().raise(display, number).expect("an alarm"),
        }
    }
    seen
}

fn look(seen: &mut Vec<Shown>, drive: &VirtualDrive<'_, '_>) {
    let value = |index| drive.value(Address::new(index, 0)).expect("an entry");
    let (control, word) = (u64::try_from(value(0x6040)).expect("a word"), u64::from(drive.statusword().0));
    let numbers = (value(0x6064), value(0x606C), value(0x6077), i64::from(drive.mode().0));
    let now = (drive.now().micros(), word, numbers.0, numbers.1, numbers.2, numbers.3, control);
    let words = |shown: &Shown| (shown.1, shown.5, shown.6);
    if seen.last().map(words) != Some(words(&now)) {
        seen.push(now);
    }
}

/// What `simulate` shows of the folder.
fn loaded() -> Vec<Shown> {
    let script: String = STEPS.iter().map(|step| step.line()).collect();
    let place = Path::new(env!("CARGO_TARGET_TMPDIR")).join("same-drive.txt");
    std::fs::write(&place, script).expect("a file");
    let mut program = Command::new(env!("CARGO_BIN_EXE_drivewright"));
    program.args(["simulate", PROFILE, "--quiet", "--json", "--trace", "--script"]).arg(&place);
    let ran = program.output().expect("it runs");
    assert_eq!(ran.status.code(), Some(0), "{}", String::from_utf8_lossy(&ran.stderr));
    let text = String::from_utf8(ran.stdout).expect("UTF-8");
    let rows = text.lines().map(|line| serde_json::from_str::<Value>(line).expect("JSON"));
    let shown = |row: Value| {
        let number = |name: &str| row[name].as_i64();
        let natural = |name: &str| row[name].as_u64();
        Some((
            natural("at_us")?,
            natural("statusword")?,
            number("position")?,
            number("speed")?,
            number("torque")?,
            number("mode")?,
            natural("controlword")?,
        ))
    };
    rows.filter_map(shown).collect()
}

#[test]
fn what_they_do_is_the_same() {
    let (generated, loaded) = (generated(), loaded());
    assert_eq!(generated, loaded);
    // It was worth comparing: the axis turned, there was a fault (xxxx xxxx x0xx 1000b), and it was reset.
    assert!(generated.len() > 10 && generated.iter().any(|shown| shown.2 > 1000), "{generated:?}");
    assert!(generated.iter().any(|shown| shown.1 & 0x4F == 0x08), "{generated:?}");
    assert_eq!(generated.last().map(|shown| shown.1 & 0x4F), Some(0x40), "{generated:?}");
}

#[test]
fn what_they_are_is_the_same() {
    let (compiled, _) = compile_folder(Path::new(PROFILE));
    let arena = live::Arena::default();
    let live = live::tables(compiled.sound().expect("a sound profile"), &arena);
    assert_eq!(*live.model(), savch_sdv3_e::MODEL);
}
