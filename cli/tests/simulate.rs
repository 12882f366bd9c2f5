//! `simulate` as a user calls it: what a script sees of a drive, and how it ends.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "a test runs the program")]

mod support;

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use drivewright_codegen::compile_folder;

use support::{err, folder, out, sdv3_e};

/// Runs a script on the SDV3-E.
fn simulate(script: &str, more: &[&str]) -> Output {
    run(&sdv3_e(), script, more)
}

fn run(profile: &Path, script: &str, more: &[&str]) -> Output {
    let mut program = Command::new(env!("CARGO_BIN_EXE_drivewright"));
    program.arg("simulate").arg(profile).args(more);
    program.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = program.spawn().expect("it starts");
    child.stdin.take().expect("a pipe").write_all(script.as_bytes()).expect("it reads");
    child.wait_with_output().expect("it ends")
}

/// From power-on to operation enabled in profile velocity mode, with process data.
const ENABLE: &str = "\
run 200ms
bus safeop
bus op
exchange 6060=3 6040=0x06
until 6041 & 0x6F == 0x21 within 20ms
exchange 6040=0x07
until 6041 & 0x6F == 0x23 within 20ms
exchange 6040=0x0F
until state Operation enabled within 20ms
";

#[test]
fn a_drive_is_enabled_and_turns() {
    let script =
        format!("{ENABLE}exchange 60FF=3000\nrun 500ms\nread 606C\nexpect 606C > 2950\nexpect 606C < 3050\n");
    let ran = simulate(&script, &["--quiet"]);
    assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
    assert!(out(&ran).contains("606C:00 Velocity Actual Value = "), "{}", out(&ran));
    assert_eq!(err(&ran), "");
}

#[test]
fn what_is_not_as_expected_ends_with_1() {
    let ran =
        simulate("run 200ms\n\nexpect 6041 & 0x6F == 0x27 # not enabled yet\nread 6041\n", &["--quiet"]);
    assert_eq!((ran.status.code(), out(&ran).as_str()), (Some(1), ""), "nothing runs after it");
    let said = err(&ran);
    // Switch on disabled is x1xx 0000b under this mask: 40h.
    assert!(
        said.contains("line 3") && said.contains("& 0x6F is 0x40") && said.contains("Status Word"),
        "{said}"
    );
    let ran = simulate("until state Fault within 30ms\n", &["--quiet"]);
    assert_eq!(ran.status.code(), Some(1));
    assert!(err(&ran).contains("not so after 30 ms: the state is Not ready to switch on"), "{}", err(&ran));
}

#[test]
fn every_bad_line_is_named_and_nothing_is_run() {
    let ran = simulate("read 6041\nraed 6041\nrun 5\nexpect 6041 = 5\n", &[]);
    assert_eq!((ran.status.code(), out(&ran).as_str()), (Some(2), ""));
    let said = err(&ran);
    for part in [
        "standard input, line 2: there is no command `raed`",
        "line 3: `5` is no time, such as 250us, 10ms or 2s; write it like this: run 100ms",
        "line 4: `=` does not compare",
        "3 lines of the script cannot be read; nothing was run",
    ] {
        assert!(said.contains(part), "{part}: {said}");
    }
    let nowhere = simulate("", &["--script", "nowhere.txt"]);
    assert_eq!(nowhere.status.code(), Some(3));
    assert!(err(&nowhere).contains("nowhere.txt"));
}

#[test]
fn refusals_have_the_abort_codes_of_the_manual() {
    let (compiled, _) = compile_folder(&sdv3_e());
    let model = compiled.model.expect("a profile");
    let name = |code: u32| {
        let row = model.aborts.iter().find(|a| a.code.value == code).expect("an abort code of the manual");
        row.name.value.clone()
    };
    for (command, code) in [
        ("write 6041 0", 0x0601_0002),
        ("write 6060 2", 0x0609_0030),
        ("send 6040 06", 0x0607_0013),
        ("read 5FFF", 0x0602_0000),
    ] {
        let ran = simulate(&format!("run 200ms\nrefused {code:08X}h {command}\n"), &["--quiet"]);
        assert_eq!(ran.status.code(), Some(0), "{command}: {}", err(&ran));
        assert!(out(&ran).contains(&name(code)), "{command}: {}", out(&ran));
        let refused = simulate(&format!("run 200ms\n{command}\n"), &["--quiet"]);
        assert_eq!(refused.status.code(), Some(1), "{command}");
        let other = simulate(&format!("run 200ms\nrefused 08000000h {command}\n"), &["--quiet"]);
        assert_eq!(other.status.code(), Some(1), "{command}");
        assert!(err(&other).contains("refused, but otherwise"), "{}", err(&other));
    }
    let fine = simulate("run 200ms\nrefused read 6041\n", &["--quiet"]);
    assert!(fine.status.code() == Some(1) && err(&fine).contains("does not refuse it"), "{}", err(&fine));
}

#[test]
fn faults_come_and_go_as_they_are_asked_for() {
    // The watchdog is 100 ms: 90 lost cycles are none of its business, 120 are.
    let lost = |n: u32| format!("{ENABLE}fault lost-pdo {n}\nrun 300ms\nexpect state ");
    for (script, state) in [(lost(90), "Operation enabled"), (lost(120), "Fault")] {
        let ran = simulate(&format!("{script}{state}\nstate\n"), &["--quiet"]);
        assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
        assert_eq!(
            out(&ran).contains("Pto (8100h): PDO Watchdog timeout"),
            state == "Fault",
            "{}",
            out(&ran)
        );
    }
    let raised = "raise OF\nuntil state Fault within 1s\nread 603F\nexchange 6040=0\nexchange 6040=0x80\nexpect 603F == 0\n";
    let ran = simulate(&format!("{ENABLE}{raised}"), &["--quiet"]);
    assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
    // 8611h, following error.
    assert!(out(&ran).contains("603F:00 Error Code = 34321"), "{}", out(&ran));
    let reset = "exchange 6040=0\nexchange 6040=0x80\nrun 5ms\n";
    let held = format!(
        "{ENABLE}hold OF\nuntil state Fault within 1s\n{reset}expect state Fault\nclear OF\n{reset}expect state Switch on disabled\n"
    );
    let ran = simulate(&held, &["--quiet"]);
    assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
    let unknown = simulate("raise XX\n", &["--quiet"]);
    assert!(
        unknown.status.code() == Some(1) && err(&unknown).contains("known: OC1, OC2"),
        "{}",
        err(&unknown)
    );
    let late = simulate("run 200ms\nfault lost-answer 1\nrefused read 6041\nread 6041\n", &["--quiet"]);
    assert!(late.status.code() == Some(0) && out(&late).contains("no answer"), "{}", out(&late));
}

#[test]
fn without_supply_nothing_answers_and_nothing_is_remembered() {
    let script = format!(
        "{ENABLE}exchange off\npower off\nrun 50ms\nrefused read 6041\npower on\nrun 200ms\nexpect state Switch on disabled\nread 6060\n"
    );
    let ran = simulate(&script, &["--quiet"]);
    assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
    assert!(out(&ran).contains("no answer") && out(&ran).contains("6060:00"), "{}", out(&ran));
}

#[test]
fn assumptions_are_told_with_reasons_unless_it_is_to_be_quiet() {
    let ran = simulate("", &[]);
    assert_eq!(ran.status.code(), Some(0));
    assert!(
        err(&ran).contains("watchdog: 100 ms (the default of the EtherCAT slave controller"),
        "{}",
        err(&ran)
    );
    assert_eq!(err(&simulate("", &["--quiet"])), "");
}

#[test]
fn the_trace_is_the_same_every_time_and_in_every_form() {
    let at = folder("simulate", "trace");
    let (plot, csv) = (at.join("t.svg"), at.join("t.csv"));
    let (plot, csv) = (plot.to_str().expect("UTF-8"), csv.to_str().expect("UTF-8"));
    let script = format!("{ENABLE}note away\nexchange 60FF=3000\nrun 100ms\n");
    let more = ["--trace", "--quiet", "--plot", plot, "--csv", csv];
    let ran = simulate(&script, &more);
    assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
    let text = out(&ran);
    assert!(text.contains("Operation enabled") && text.contains("-- away"), "{text}");
    let (first, samples) = (fs::read(plot).expect("a plot"), fs::read_to_string(csv).expect("samples"));
    // One for each millisecond, the first one included, a line of heads, and the note.
    let last = samples.lines().last().and_then(|line| line.split('.').next()).expect("a line");
    let milliseconds: usize = last.parse().expect("a time");
    assert_eq!(samples.lines().count(), milliseconds + 1 + 1 + 1, "{last}");
    assert_eq!(out(&simulate(&script, &more)), text);
    assert_eq!(fs::read(plot).expect("a plot"), first);
}

#[test]
fn programs_get_an_object_a_line() {
    let ran = simulate("run 200ms\nread 6041\nexpect state Fault\n", &["--json", "--quiet"]);
    assert_eq!(ran.status.code(), Some(1));
    let rows: Vec<serde_json::Value> =
        out(&ran).lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    assert_eq!(rows.len(), 3);
    assert_eq!((&rows[1]["line"], &rows[1]["fine"]), (&2.into(), &true.into()));
    assert!(rows[1]["said"].as_str().expect("a text").contains("0250h"), "{}", rows[1]);
    assert_eq!(rows[2]["fine"], false);
}

/// A drive of which nothing is stated is a drive all the same.
#[test]
fn any_profile_can_be_simulated() {
    let at = folder("simulate", "bare");
    fs::write(at.join("drive.toml"), include_str!("../../codegen/tests/fixtures/drive.toml"))
        .expect("a file");
    let ran = run(&at, "run 200ms\nrefused read 6041\nstate\n", &["--quiet"]);
    assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
    assert!(out(&ran).contains("object does not exist"), "{}", out(&ran));
}
