//! Output is a function of the input bytes: not of the place of the profile, the current folder, or the environment.

#![allow(clippy::expect_used, clippy::disallowed_methods, reason = "a test runs the program on files")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Every file below a folder.
type Files = BTreeMap<PathBuf, Vec<u8>>;

/// What a run gives: the files it writes, and its findings as JSON.
type Run = (Files, Vec<u8>);

fn profile() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../profiles/savch/sdv3-e")
}

/// An empty folder with a copy of the profile in `below`.
fn copy(name: &str, below: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("same-bytes").join(name);
    let _ = fs::remove_dir_all(&root);
    fs::create_dir_all(root.join(below)).expect("a folder");
    for (path, bytes) in files(&profile()) {
        fs::write(root.join(below).join(path), bytes).expect("a file");
    }
    root
}

fn files(root: &Path) -> Files {
    let (mut folders, mut found) = (vec![root.to_owned()], Files::new());
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder").map(|e| e.expect("an entry").path()) {
            if entry.is_dir() {
                folders.push(entry);
            } else {
                let path = entry.strip_prefix(root).expect("below").to_owned();
                found.insert(path, fs::read(entry).expect("a file"));
            }
        }
    }
    found
}

/// Builds the profile `from` to `to`, both as seen from the folder `at`.
fn run(at: &Path, from: &Path, to: &Path, environment: &[(&str, &str)]) -> Run {
    let program = |arguments: &[&str], paths: &[&Path]| -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_drivewright"));
        command.current_dir(at).args(arguments).args(paths).envs(environment.iter().copied());
        command.output().expect("the program runs")
    };
    let built = program(&["build", "--out"], &[to, from]);
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    let checked = program(&["check", "--format", "json"], &[from]);
    (files(&at.join(to)), checked.stdout)
}

#[test]
fn place_folder_and_environment_change_nothing() {
    let (near, far) = (copy("near", "p"), copy("far", "deep/er/Ünïcode dir"));
    let wanted = run(&near, Path::new("p"), Path::new("out"), &[]);
    assert!(wanted.0.len() > 8, "only {:?}", wanted.0.keys());
    assert_eq!(run(&near, Path::new("p"), Path::new("again"), &[]), wanted, "a second run");
    let other = run(&far, &far.join("deep/er/Ünïcode dir"), Path::new("o/u/t"), &[]);
    assert_eq!(other, wanted, "another place");
    let environment = [
        ("TZ", "Pacific/Kiritimati"),
        ("LANG", "tr_TR.UTF-8"),
        ("LC_ALL", "tr_TR.UTF-8"),
        ("HOME", "/nowhere"),
        ("USER", "nobody"),
        ("SOURCE_DATE_EPOCH", "1"),
        ("RUST_LOG", "trace"),
        ("COLUMNS", "20"),
        ("CLICOLOR_FORCE", "1"),
    ];
    assert_eq!(run(&near, Path::new("p"), Path::new("env"), &environment), wanted, "another environment");
}

#[test]
fn a_changed_byte_of_the_input_is_seen() {
    let root = copy("changed", "p");
    let wanted = run(&root, Path::new("p"), Path::new("out"), &[]);
    let path = root.join("p/objects.toml");
    let text = fs::read_to_string(&path).expect("a text");
    fs::write(&path, text.replacen("Profile Velocity", "Profile velocity", 1)).expect("a file");
    assert_ne!(run(&root, Path::new("p"), Path::new("other"), &[]).0, wanted.0);
}
