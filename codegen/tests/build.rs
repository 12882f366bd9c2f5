//! `build` as cargo sees it: what it reads, writes and says. Each run is a process of its own, since the words go to its
//! standard output.

#![allow(clippy::expect_used, clippy::disallowed_methods, reason = "a test works on files")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const DRIVE: &str = include_str!("fixtures/drive.toml");
const OBJECTS: &str = r#"objects = [
  { at = "2000:00", name = "Speed", type = "u16", access = "rw", pdo = "no", default = 5, src = "1 L2" },
]
"#;

/// Names the profile in the child that builds.
const CHILD: &str = "DRIVEWRIGHT_BUILD_CHILD";

/// Not a test by itself: the build script that the others run.
#[test]
fn child_that_builds() {
    let Some(folder) = std::env::var_os(CHILD) else { return };
    drivewright_codegen::build(Path::new(&folder));
}

/// A package with a profile, and an empty `out`.
fn package(name: &str, objects: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("build").join(name);
    let _ = fs::remove_dir_all(&root);
    fs::create_dir_all(root.join("profile")).expect("a folder");
    fs::create_dir_all(root.join("out")).expect("a folder");
    fs::write(root.join("profile/drive.toml"), DRIVE).expect("a file");
    fs::write(root.join("profile/objects.toml"), objects).expect("a file");
    root
}

/// Runs the build script in the package; whether it succeeded, and its lines for cargo.
fn build(root: &Path, profile: &str, out: bool) -> (bool, Vec<String>) {
    let mut child = Command::new(std::env::current_exe().expect("this test"));
    child.args(["--exact", "child_that_builds", "--nocapture", "--quiet"]).current_dir(root);
    child.env(CHILD, profile).env_remove("OUT_DIR");
    if out {
        child.env("OUT_DIR", root.join("out"));
    }
    let output = child.output().expect("a child");
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    let lines = text.lines().filter(|l| l.starts_with("cargo::")).map(str::to_owned).collect();
    (output.status.success(), lines)
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let name =
        |e: std::io::Result<fs::DirEntry>| e.expect("an entry").file_name().to_string_lossy().into_owned();
    let mut names: Vec<String> = entries.map(name).collect();
    names.sort();
    names
}

#[test]
fn names_every_file_and_folder_that_it_reads_and_nothing_else() {
    let root = package("reads", OBJECTS);
    fs::write(root.join("profile/notes.md"), "not read").expect("a file");
    let (ok, lines) = build(&root, "profile", true);
    assert!(ok);
    let expected = [
        "cargo::rerun-if-changed=profile",
        "cargo::rerun-if-changed=profile/drive.toml",
        "cargo::rerun-if-changed=profile/objects.toml",
    ];
    assert_eq!(lines, expected);
}

#[test]
fn writes_one_file_below_out_dir_and_touches_it_only_when_it_changes() {
    let root = package("writes", OBJECTS);
    assert!(build(&root, "profile", true).0);
    assert_eq!(names(&root.join("out")), ["acme_x1.rs"]);
    assert_eq!((names(&root), names(&root.join("profile")).len()), (vec!["out".into(), "profile".into()], 2));
    let file = root.join("out/acme_x1.rs");
    let text = fs::read_to_string(&file).expect("a text");
    assert!(syn::parse_file(&text).is_ok() && text.contains("pub const SPEED"), "{text}");
    let time = || fs::metadata(&file).and_then(|m| m.modified()).expect("a time");
    let before = time();
    assert!(build(&root, "profile", true).0);
    assert_eq!(time(), before);
    fs::write(root.join("profile/objects.toml"), OBJECTS.replace("Speed", "Ramp")).expect("a file");
    assert!(build(&root, "profile", true).0);
    assert!(fs::read_to_string(&file).expect("a text").contains("pub const RAMP"));
}

#[test]
fn findings_are_errors_of_cargo_and_nothing_is_written() {
    let root = package("errors", &OBJECTS.replace("default = 5", "default = 70000"));
    let (ok, lines) = build(&root, "profile", true);
    assert!(!ok && names(&root.join("out")).is_empty());
    let errors: Vec<&String> = lines.iter().filter(|l| l.starts_with("cargo::error=")).collect();
    assert!(errors[0].starts_with("cargo::error=profile/objects.toml:2:88: E0402: "), "{errors:#?}");
    assert!(errors[0].contains(" Why: ") && errors[0].contains(" To do: "), "{errors:#?}");
    assert_eq!(
        errors.last().map(|l| l.as_str()),
        Some("cargo::error=a profile has an error; nothing was written")
    );
}

#[test]
fn what_is_missing_is_said() {
    let root = package("missing", OBJECTS);
    let (ok, lines) = build(&root, "profiles", true);
    assert!(!ok && lines.iter().any(|l| l.starts_with("cargo::error=E0001: profiles: ")), "{lines:#?}");
    let (ok, lines) = build(&root, "profile", false);
    assert!(!ok && lines.iter().any(|l| l.starts_with("cargo::error=OUT_DIR is not set")), "{lines:#?}");
}

#[test]
fn two_profiles_of_one_file_are_refused_before_anything_is_written() {
    let root = package("same-file", OBJECTS);
    let other = root.join("other");
    fs::create_dir_all(&other).expect("a folder");
    let with = |vendor: &str, id: &str| {
        let text = DRIVE.replace("vendor_id = \"acme\"", &format!("vendor_id = \"{vendor}\""));
        text.replace("id = \"x1\"", &format!("id = \"{id}\""))
    };
    fs::write(root.join("profile/drive.toml"), with("acme", "x-y1")).expect("a file");
    fs::write(other.join("drive.toml"), with("acme-x", "y1")).expect("a file");
    fs::write(other.join("objects.toml"), OBJECTS).expect("a file");
    let both = drivewright_codegen::Build::new().profile(root.join("profile")).profile(&other);
    let error = both.out_dir(root.join("out")).run().expect_err("one file for two profiles").to_string();
    assert!(
        error.contains("acme_x_y1.rs") && error.contains("profile") && error.contains("other"),
        "{error}"
    );
    assert!(names(&root.join("out")).is_empty());
}
