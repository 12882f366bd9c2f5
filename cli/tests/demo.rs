//! `demo` as a user calls it. What it must have done follows from the axis, the profile, and arithmetic.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "a test runs the program")]

mod support;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use drivewright_codegen::compile_folder;
use serde_json::Value;

use support::{err, folder, out, sdv3_e};

/// Counts of a revolution of the virtual axis.
const REVOLUTION: i64 = 131_072;

fn demo(profile: &Path, more: &[&str]) -> Output {
    let mut program = Command::new(env!("CARGO_BIN_EXE_drivewright"));
    program.arg("demo").arg(profile).args(more).output().expect("it runs")
}

/// The last line of the answer for programs.
fn summary(output: &Output) -> Value {
    let text = out(output);
    let line = text.lines().last().unwrap_or_else(|| panic!("nothing was printed: {}", err(output)));
    serde_json::from_str(line).expect("JSON")
}

fn number(summary: &Value, scene: &str, name: &str) -> i64 {
    let scenes = summary["scenes"].as_array().expect("scenes");
    let found = scenes.iter().find(|s| s["scene"].as_str().is_some_and(|title| title.starts_with(scene)));
    found.and_then(|s| s[name].as_i64()).unwrap_or_else(|| panic!("{scene} has no {name}: {summary}"))
}

#[test]
fn the_sdv3_e_does_what_it_is_told_in_every_mode() {
    let ran = demo(&sdv3_e(), &["--json"]);
    assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
    let summary = summary(&ran);
    assert_eq!(summary["failed"], Value::Null);

    // Method 17: home is the edge of the negative limit, a quarter of a revolution before the hard stop, which lies ten
    // and a half from the middle, where the axis was switched on.
    let edge = -(REVOLUTION * 10 + REVOLUTION / 4);
    assert_eq!(number(&summary, "home", "method"), 17);
    assert_eq!(number(&summary, "home", "home_count"), edge);
    // Sixteen counts are a user unit: 6093h as the drive ships. The axis stands where its position says.
    let (count, position) = (number(&summary, "home", "count"), number(&summary, "home", "position"));
    assert!((count - edge - position * 16).abs() <= 16, "{count} {position}");
    assert!(position.abs() < REVOLUTION / 16 / 100, "the axis stands near home: {position}");

    let (compiled, _) = compile_folder(&sdv3_e());
    let model = compiled.model.expect("a profile");
    let default = |index| {
        let address = drivewright_codegen::model::Address::new(index, 0);
        i64::try_from(model.default_int(address).expect("a default")).expect("64 bits")
    };
    let (window, speed_window) = (default(0x6067), default(0x606D) * 10);
    for (scene, within) in [
        ("profile position", window),
        ("profile velocity", speed_window),
        ("profile torque", 5),
        ("cyclic synchronous position", window),
        ("cyclic synchronous velocity", speed_window),
        ("cyclic synchronous torque", 5),
    ] {
        let (target, reached) = (number(&summary, scene, "target"), number(&summary, scene, "reached"));
        assert!((target - reached).abs() <= within, "{scene}: {target}, {reached}");
    }
    // Eight revolutions of 8,192 units; 300.0 rpm in tenths; 5.0 % in tenths.
    let way = number(&summary, "profile position", "target") - position;
    assert!((way - 8 * 8192).abs() <= 8, "{way}");
    assert_eq!(number(&summary, "profile velocity", "target"), 3000);
    assert_eq!(number(&summary, "profile torque", "target"), 50);
    for mode in &model.modes {
        let shown = out(&ran).contains(&format!("\"mode\":{}", mode.number));
        assert!(shown, "mode {} was not run", mode.number);
    }
}

#[test]
fn the_fault_is_explained_as_the_manual_does() {
    let ran = demo(&sdv3_e(), &["--json"]);
    let summary = summary(&ran);
    let (compiled, _) = compile_folder(&sdv3_e());
    let model = compiled.model.expect("a profile");
    let code = number(&summary, "fault", "code");
    let alarms: Vec<_> = model.alarms.iter().filter(|a| i64::from(a.code.value) == code).collect();
    let [alarm] = alarms.as_slice() else { panic!("{code:04X}h is not of one alarm") };
    let told = summary["fault"].as_str().expect("a text");
    // A long line may be broken.
    let told: Vec<&str> = told.split_whitespace().collect();
    let told = told.join(" ");
    assert!(told.contains(&alarm.display) && told.contains(alarm.name.value.original()), "{told}");
    let texts = alarm.causes.iter().chain(&alarm.remedies).map(|text| &text.value);
    let texts: Vec<&String> = texts.collect();
    assert!(texts.len() > 2, "an alarm with causes and remedies was chosen");
    for text in texts {
        assert!(told.contains(text.as_str()), "{text}: {told}");
    }
    assert!(told.contains("5.1 T5-1"), "where it is printed: {told}");
}

#[test]
fn people_read_a_trace_and_a_summary() {
    let ran = demo(&sdv3_e(), &[]);
    assert_eq!((ran.status.code(), err(&ran).as_str()), (Some(0), ""));
    let text = out(&ran);
    for part in [
        "SAVCH SDV3-E, virtual: simulated from its profile, without hardware",
        "== home by method 17",
        "-- home found",
        "!! Pto (8100h)",
        "-- fault reset",
        "rpm",
        "Operation enabled",
    ] {
        assert!(text.contains(part), "{part}:\n{text}");
    }
    let (fault, reset) =
        (text.find("!! Pto").expect("a fault"), text.find("-- fault reset").expect("a reset"));
    assert!(fault < reset);
    assert!(!text.contains('\u{1b}'), "colour in a pipe");
    assert_eq!(out(&demo(&sdv3_e(), &["--quiet"])), "");
}

#[test]
fn the_picture_is_the_same_every_time() {
    let at = folder("demo", "plot");
    let draw = |name: &str| {
        let place = at.join(name);
        let ran = demo(&sdv3_e(), &["--quiet", "--plot", place.to_str().expect("UTF-8")]);
        assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
        fs::read_to_string(place).expect("a picture")
    };
    let picture = draw("a.svg");
    assert_eq!(picture, draw("b.svg"));
    assert!(picture.len() < 100_000, "{}", picture.len());
    for part in ["Operation enabled", "Fault", "homing", "[rpm]", "target reached"] {
        assert!(picture.contains(part), "{part}");
    }
}

fn repository(name: &str) -> String {
    let place = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name);
    fs::read_to_string(place).expect("a file of the repository")
}

/// What the README shows is what the command prints, in that order, and draws.
#[test]
fn the_readme_shows_what_it_does() {
    let place = folder("demo", "readme").join("demo.svg");
    let ran = demo(&sdv3_e(), &["--plot", place.to_str().expect("UTF-8")]);
    let (printed, readme) = (out(&ran), repository("README.md"));
    let (_, block) =
        readme.split_once("$ cargo run -p drivewright -- demo --plot demo.svg\n").expect("the command");
    let (block, _) = block.split_once("```").expect("its end");
    let mut lines = printed.lines();
    for wanted in block.lines().filter(|line| !line.is_empty() && *line != "...") {
        assert!(lines.any(|line| line == wanted), "README.md: the demonstration does not print\n{wanted}");
    }
    assert!(block.lines().count() > 10);
    let drawn = fs::read_to_string(place).expect("a picture");
    let update = "run `cargo run -p drivewright -- demo --quiet --plot cli/demo.svg`";
    assert!(
        repository("cli/demo.svg") == drawn,
        "cli/demo.svg is not what the demonstration draws: {update}"
    );
}

#[test]
fn a_drive_without_modes_is_not_shown() {
    let at = folder("demo", "bare");
    fs::write(at.join("drive.toml"), include_str!("../../codegen/tests/fixtures/drive.toml"))
        .expect("a file");
    let ran = demo(&at, &[]);
    assert_eq!((ran.status.code(), out(&ran).as_str()), (Some(1), ""));
    assert!(
        err(&ran).contains("x1 cannot be shown: its profile has no controlword and statusword"),
        "{}",
        err(&ran)
    );
    fs::write(at.join("objects.toml"), "objects = [\n  { at = \"6040:00\", name = \"Controlword\", type = \"u16\", access = \"rw\", pdo = \"no\", src = \"1 L1\" },\n  { at = \"6041:00\", name = \"Statusword\", type = \"u16\", access = \"ro\", pdo = \"no\", src = \"1 L2\" },\n]\n").expect("a file");
    let ran = demo(&at, &[]);
    assert_eq!(ran.status.code(), Some(1));
    assert!(err(&ran).contains("states no modes of operation; `drivewright todo x1`"), "{}", err(&ran));
}

/// A drive without process data and homing, and with these alarms.
fn small(name: &str, alarms: &str) -> PathBuf {
    let at = folder("demo", name);
    fs::write(at.join("drive.toml"), include_str!("../../codegen/tests/fixtures/drive.toml"))
        .expect("a file");
    let object = |(at, name, ty, access, unit): (&str, &str, &str, &str, &str)| {
        let unit = if unit.is_empty() { String::new() } else { format!("unit = \"{unit}\", ") };
        format!(
            "  {{ at = \"{at}:00\", name = \"{name}\", type = \"{ty}\", access = \"{access}\", pdo = \"no\", {unit}src = \"1 L1\" }},\n"
        )
    };
    let objects: String = [
        ("603F", "Error code", "u16", "ro", ""),
        ("6040", "Controlword", "u16", "rw", ""),
        ("6041", "Statusword", "u16", "ro", ""),
        ("6060", "Mode", "i8", "rw", ""),
        ("6061", "Mode display", "i8", "ro", ""),
        ("6064", "Position", "i32", "ro", "user position"),
        ("606C", "Velocity", "i32", "ro", "rpm"),
        ("607A", "Target position", "i32", "rw", "user position"),
        ("6081", "Profile velocity", "u32", "rw", "rpm"),
        ("60FF", "Target velocity", "i32", "rw", "rpm"),
    ]
    .map(object)
    .concat();
    fs::write(at.join("objects.toml"), format!("objects = [\n{objects}]\n")).expect("a file");
    let modes = "modes = [\n  { mode = 1, name = \"PP\", src = \"1 L1\" },\n  { mode = 3, name = \"PV\", src = \"1 L2\" },\n  { mode = 7, name = \"IP\", src = \"1 L3\" },\n]\n";
    fs::write(at.join("modes.toml"), modes).expect("a file");
    fs::write(at.join("alarms.toml"), format!("alarms = [{alarms}]\n")).expect("a file");
    at
}

/// No process data, no homing, no alarms: what is there is run over SDO, and what is not is left out.
#[test]
fn a_small_drive_shows_what_it_has() {
    let ran = demo(&small("small", ""), &["--json"]);
    assert_eq!(ran.status.code(), Some(0), "{}", err(&ran));
    let summary = summary(&ran);
    assert_eq!(number(&summary, "profile velocity", "target"), 300);
    let text = summary["scenes"].to_string();
    for part in
        ["interpolated position", "this demonstration has no part for it", "the profile has no alarms"]
    {
        assert!(text.contains(part), "{part}: {text}");
    }
}

/// A drive that does not mind silence gets an alarm; one that no reset clears is switched off and on.
#[test]
fn the_way_out_of_a_fault_is_that_of_the_alarm() {
    for (reset, way) in [
        ("resettable", "by a rising edge of bit 7"),
        ("not resettable", "by switching the control supply off and on"),
    ] {
        let alarm = format!(
            "{{ display = \"E1\", number = 1, code = 0x2310, name = \"Too much\", reset = \"{reset}\", causes = [\"A short circuit.\"], remedies = [\"Look at the cable.\"], src = \"1 L1\", detail = \"1 L2\" }}"
        );
        let ran = demo(&small(&reset.replace(' ', "-"), &alarm), &["--json"]);
        assert_eq!(ran.status.code(), Some(0), "{reset}: {}", err(&ran));
        let summary = summary(&ran);
        assert_eq!(number(&summary, "fault", "code"), 0x2310);
        let (fault, scenes) = (summary["fault"].to_string(), summary["scenes"].to_string());
        assert!(fault.contains("A short circuit.") && fault.contains("Look at the cable."), "{fault}");
        assert!(scenes.contains("raised by hand") && scenes.contains(way), "{reset}: {scenes}");
    }
}
