//! The program as a user calls it: exit codes, formats, and where text goes.

#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::disallowed_methods,
    reason = "a test runs the program on files"
)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const OBJECTS: &str = r#"
objects = [
  { at = "2000:00", name = "Speed", type = "u16", access = "rw", pdo = "no", default = 5, src = "1 L2" },
]
"#;

/// A profile with one object, in the third line of its file.
fn drive() -> String {
    format!("{OBJECTS}{}", include_str!("../../codegen/tests/fixtures/drive.toml"))
}

fn folder(name: &str, text: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cli").join(name);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(path.join("profile")).expect("a folder");
    fs::write(path.join("profile/drive.toml"), text).expect("a file");
    path
}

fn run(at: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_drivewright"))
        .current_dir(at)
        .args(arguments)
        .output()
        .expect("the program runs")
}

fn out(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn err(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn code(output: &Output) -> i32 {
    output.status.code().expect("an exit code")
}

#[test]
fn a_sound_profile_is_checked_and_built() {
    let at = folder("sound", &drive());
    let checked = run(&at, &["check", "profile"]);
    assert_eq!((code(&checked), err(&checked).as_str()), (0, ""));
    assert!(out(&checked).contains("1 object, 1 entry, 0 PDOs") && out(&checked).contains("no findings"));
    assert_eq!(out(&run(&at, &["check", "profile", "--quiet"])), "");
    assert_eq!(code(&run(&at, &["build", "profile", "--out", "o", "--check"])), 1, "all is missing");
    assert!(!at.join("o").exists());
    assert_eq!(code(&run(&at, &["build", "profile", "--out", "o"])), 0);
    assert!(at.join("o/map.txt").exists() && at.join("o/eds/acme-x1.eds").exists());
    assert_eq!(code(&run(&at, &["build", "profile", "--out", "o", "--check"])), 0);
    fs::write(at.join("o/map.txt"), "edited by hand\n").expect("a file");
    let checked = run(&at, &["build", "profile", "--out", "o", "--check"]);
    assert_eq!((code(&checked), out(&checked).lines().next()), (1, Some("changed: o/map.txt")));
    let diff = run(&at, &["build", "profile", "--out", "o", "--diff"]);
    assert!(code(&diff) == 0 && out(&diff).contains("-edited by hand"));
}

#[test]
fn only_the_formats_asked_for_are_built() {
    let at = folder("only", &drive());
    assert_eq!(code(&run(&at, &["build", "profile", "--out", "o", "--only", "map"])), 0);
    assert!(at.join("o/map.txt").exists() && !at.join("o/eds").exists());
    assert_eq!(code(&run(&at, &["build", "profile", "--out", "o", "--only", "mpa"])), 2);
}

#[test]
fn other_files_stay_unless_pruning_is_asked_for() {
    let at = folder("prune", &drive());
    fs::create_dir(at.join("o")).expect("a folder");
    fs::write(at.join("o/thesis.txt"), "years of work").expect("a file");
    assert_eq!(code(&run(&at, &["build", "profile", "--out", "o"])), 0);
    assert_eq!(code(&run(&at, &["build", "profile", "--out", "o", "--check"])), 0);
    assert!(at.join("o/thesis.txt").exists());
    let checked = run(&at, &["build", "profile", "--out", "o", "--check", "--prune"]);
    assert_eq!((code(&checked), out(&checked).lines().next()), (1, Some("orphaned: o/thesis.txt")));
    assert_eq!(code(&run(&at, &["build", "profile", "--out", "o", "--prune"])), 0);
    assert!(!at.join("o/thesis.txt").exists() && at.join("o/map.txt").exists());
}

#[test]
fn pruning_never_takes_the_profile() {
    let at = folder("prune-profile", &drive());
    for out in ["profile", ".", "profile/out"] {
        fs::create_dir_all(at.join(out)).expect("a folder");
        assert_eq!(code(&run(&at, &["build", "profile", "--out", out, "--prune"])), 2, "{out}");
        assert!(at.join("profile/drive.toml").exists() && !at.join(out).join("map.txt").exists());
    }
}

#[test]
fn findings_have_their_place_in_every_format() {
    let at = folder("unsound", &drive().replace("default = 5", "default = 70000"));
    let human = run(&at, &["check", "profile"]);
    assert_eq!((code(&human), out(&human).as_str()), (1, ""));
    assert!(err(&human).contains("error[E0402]") && err(&human).contains("drive.toml:3:"), "{}", err(&human));
    assert!(!err(&human).contains('\u{1b}'), "no colour in a pipe");
    let json = run(&at, &["check", "profile", "--format", "json"]);
    assert!(
        code(&json) == 1
            && out(&json).starts_with(r#"{"folder":"profile","code":"E0402","severity":"error""#),
        "{}",
        out(&json)
    );
    assert!(out(&json).contains(r#""path":"drive.toml","line":3"#));
    assert_eq!(out(&run(&at, &["check", "profile", "--json"])), out(&json), "--json is short for it");
    let github = run(&at, &["check", "profile", "--format", "github"]);
    assert!(out(&github).starts_with("::error file=profile/drive.toml,line=3,col="), "{}", out(&github));
    assert_eq!(code(&run(&at, &["build", "profile", "--out", "o"])), 1);
    assert!(!at.join("o").exists(), "nothing is half written");
}

#[test]
fn what_is_not_there_is_the_disk_and_what_is_not_meant_is_usage() {
    let at = folder("missing", &drive());
    assert_eq!(code(&run(&at, &["check", "nowhere"])), 2, "neither a drive nor a folder");
    fs::create_dir(at.join("empty")).expect("a folder");
    assert_eq!(code(&run(&at, &["check", "empty"])), 3);
    assert_eq!(code(&run(&at, &["chekc", "profile"])), 2);
    assert_eq!(code(&run(&at, &["explain", "E9999"])), 2);
    assert_eq!(code(&run(&at, &["--help"])), 0);
}

#[test]
fn codes_are_listed_and_explained() {
    let at = folder("codes", &drive());
    assert!(out(&run(&at, &["lints"])).contains("E0602  error"));
    assert!(out(&run(&at, &["explain", "e0602"])).contains("## Fails"));
    assert!(out(&run(&at, &["explain", "E0101"])).contains("## What to do"));
    assert!(out(&run(&at, &["explain", "W1001"])).contains("an EDS cannot state a value"));
    assert!(out(&run(&at, &["schema"])).contains("draft-07"));
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        assert!(out(&run(&at, &["completions", shell])).contains("drivewright"), "{shell}");
    }
}

/// What a program reads on standard output is findings and nothing else.
#[test]
fn a_summary_for_people_is_not_among_the_findings_of_a_program() {
    let at = folder("summary", &drive());
    for format in ["json", "github"] {
        let built = run(&at, &["build", "profile", "--out", "o", "--only", "map", "--format", format]);
        assert_eq!((code(&built), out(&built).as_str()), (0, ""), "{format}");
        assert!(err(&built).contains("o: 1 file"), "{}", err(&built));
    }
}

#[test]
fn a_full_disk_is_said_and_ends_with_its_code() {
    let Ok(full) = fs::OpenOptions::new().write(true).open("/dev/full") else {
        println!("skipped: this system has no /dev/full");
        return;
    };
    let at = folder("full", &drive());
    let unsound = folder("full-unsound", &drive().replace("default = 5", "default = 70000"));
    for (at, arguments) in [
        (&at, "check profile"),
        (&at, "build profile --out o"),
        (&at, "build profile --out p --check"),
        (&at, "coverage profile"),
        (&at, "lints"),
        (&unsound, "check profile --format json"),
        (&unsound, "check profile --format github"),
    ] {
        let mut program = Command::new(env!("CARGO_BIN_EXE_drivewright"));
        program.current_dir(at).args(arguments.split(' ')).stdout(full.try_clone().expect("a handle"));
        let ended = program.output().expect("the program runs");
        assert_eq!(code(&ended), 3, "{arguments}: {}", err(&ended));
        assert!(err(&ended).contains("error: "), "{arguments}: {}", err(&ended));
    }
}
