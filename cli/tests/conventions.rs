//! What people expect of every command: help with examples, the same flags, quiet and silent ends.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "a test runs the program")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A drive without findings, but for the vendor.
fn drive(vendor: &str) -> String {
    include_str!("../../codegen/tests/fixtures/drive.toml").replace("\"acme\"", &format!("\"{vendor}\""))
}

/// A checkout with drives at `profiles/<place>`.
fn checkout(name: &str, places: &[&str]) -> PathBuf {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("conventions").join(name);
    let _ = fs::remove_dir_all(&root);
    fs::create_dir_all(&root).expect("a folder");
    for place in places {
        let folder = root.join("profiles").join(place);
        fs::create_dir_all(&folder).expect("a folder");
        let vendor = place.split('/').next().expect("a vendor");
        fs::write(folder.join("drive.toml"), drive(vendor)).expect("a file");
    }
    root
}

fn run(at: &Path, arguments: &[&str]) -> Output {
    let mut program = Command::new(env!("CARGO_BIN_EXE_drivewright"));
    program.current_dir(at).args(arguments).output().expect("the program runs")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// The commands that `--help` lists.
fn commands(at: &Path) -> Vec<String> {
    let help = text(&run(at, &["--help"]).stdout);
    let (_, list) = help.split_once("Commands:\n").expect("a list of commands");
    let names = list.lines().take_while(|l| l.starts_with("  ")).filter(|l| !l.starts_with("   "));
    names.filter_map(|l| l.split_whitespace().next()).map(str::to_owned).collect()
}

#[test]
fn every_command_has_help_with_an_example_and_the_common_flags() {
    let at = checkout("help", &[]);
    let commands = commands(&at);
    assert!(commands.len() > 7, "{commands:?}");
    for command in commands.iter().filter(|c| *c != "help") {
        let asked = run(&at, &[command, "--help"]);
        let help = text(&asked.stdout);
        assert_eq!(asked.status.code(), Some(0), "{command}");
        for part in ["Example", &format!("  drivewright {command}"), "--quiet", "--json", "Usage: "] {
            assert!(help.contains(part), "`{command} --help` lacks {part}:\n{help}");
        }
        let short = text(&run(&at, &[command, "-h"]).stdout);
        assert!(!short.is_empty() && !short.contains('\u{1b}'), "{command}: colour in a pipe");
    }
    let help = text(&run(&at, &["--help"]).stdout);
    assert!(help.contains("0 fine, 1 findings, 2 wrong usage, 3 the disk refused"), "{help}");
}

#[test]
fn all_drives_are_meant_where_none_is_named() {
    let at = checkout("all", &["acme/x1", "beta/x1"]);
    for command in ["check", "coverage", "todo"] {
        let ran = run(&at, &[command]);
        assert_eq!(ran.status.code(), Some(0), "{command}: {}", text(&ran.stderr));
    }
    let checked = text(&run(&at, &["check"]).stdout);
    assert!(checked.contains("profiles/acme/x1") && checked.contains("profiles/beta/x1"), "{checked}");
    let nothing = run(&checkout("none", &[]), &["check"]);
    assert_eq!(nothing.status.code(), Some(2));
}

#[test]
fn an_id_of_two_makers_is_asked_for_with_the_maker() {
    let at = checkout("two", &["acme/x1", "beta/x1"]);
    let ran = run(&at, &["check", "x1"]);
    let said = text(&ran.stderr);
    assert_eq!(ran.status.code(), Some(2));
    assert!(said.contains("acme/x1, beta/x1"), "{said}");
    assert_eq!(run(&at, &["check", "beta/x1"]).status.code(), Some(0));
    let counts: serde_json::Value =
        serde_json::from_slice(&run(&at, &["coverage", "--json"]).stdout).expect("JSON");
    assert!(counts.get("acme-x1").is_some() && counts.get("beta-x1").is_some(), "{counts}");
}

#[test]
fn lists_for_programs_are_json() {
    let at = checkout("json", &["acme/x1"]);
    let codes = text(&run(&at, &["lints", "--json"]).stdout);
    for line in codes.lines() {
        let code: serde_json::Value = serde_json::from_str(line).expect("JSON");
        assert!(code["code"].is_string() && code["severity"].is_string() && code["title"].is_string());
    }
    assert!(codes.lines().count() > 50);
}

#[test]
fn an_answer_for_programs_is_one_object() {
    let at = checkout("answers", &["acme/x1"]);
    let row = r#"{ at = "2000:00", name = "Speed", type = "u16", access = "rw", pdo = "no", src = "1 L1" }"#;
    fs::write(at.join("profiles/acme/x1/objects.toml"), format!("objects = [\n  {row},\n]\n"))
        .expect("a file");
    let object = |arguments: &[&str]| -> serde_json::Value {
        let asked = run(&at, arguments);
        assert_eq!(asked.status.code(), Some(0), "{arguments:?}: {}", text(&asked.stderr));
        serde_json::from_slice(&asked.stdout).expect("JSON")
    };
    for (code, severity) in [("E0602", "error"), ("e0001", "error"), ("W1001", "warning")] {
        let told = object(&["explain", code, "--json"]);
        assert_eq!(told["code"], code.to_uppercase());
        assert_eq!(told["severity"], severity);
        assert!(told["title"].is_string());
        assert_eq!(told["page"], text(&run(&at, &["explain", code]).stdout));
    }
    let told = object(&["explain", "x1", "2000h", "--json"]);
    assert_eq!((&told["drive"], &told["asked"]), (&"acme-x1".into(), &"2000h".into()));
    assert_eq!(told["page"], text(&run(&at, &["explain", "x1", "2000h"]).stdout));
    assert!(object(&["todo", "--json"])["acme-x1"].is_array());
    assert!(object(&["schema", "--json"]).is_object());
}

#[test]
fn what_cannot_be_json_is_refused() {
    let at = checkout("no-json", &["acme/x1"]);
    for arguments in [&["completions", "bash", "--json"][..], &["schema", "--format", "xsd", "--json"]] {
        let asked = run(&at, arguments);
        assert_eq!((asked.status.code(), text(&asked.stdout).as_str()), (Some(2), ""), "{arguments:?}");
        assert!(text(&asked.stderr).contains("leave out --json"));
    }
    let converted =
        run(&at, &["convert", "profiles/acme/x1/drive.toml", "--to", "xml", "--out", "drive.xml", "--json"]);
    assert_eq!((converted.status.code(), text(&converted.stdout).as_str()), (Some(0), ""));
    assert!(at.join("drive.xml").exists());
}

/// Nobody can hear it, and the exit code still says how it ended.
#[test]
fn a_full_standard_error_is_no_panic() {
    let Ok(full) = fs::OpenOptions::new().write(true).open("/dev/full") else {
        println!("skipped: this system has no /dev/full");
        return;
    };
    let at = checkout("full", &["acme/x1"]);
    let broken = at.join("profiles/acme/x1/drive.toml");
    for (arguments, wanted) in
        [(vec!["check", "nowhere"], 2), (vec!["explain", "E9999"], 2), (vec!["check"], 1)]
    {
        if wanted == 1 {
            fs::write(&broken, "[drive]\nformat = 99\n").expect("a file");
        }
        let mut program = Command::new(env!("CARGO_BIN_EXE_drivewright"));
        program.current_dir(&at).args(&arguments).stdout(Stdio::null());
        let ended = program.stderr(full.try_clone().expect("a handle")).status().expect("it runs");
        assert_eq!(ended.code(), Some(wanted), "{arguments:?}");
    }
}
