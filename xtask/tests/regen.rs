//! `regen` on a small checkout of its own: what it writes, names and refuses.

#![allow(clippy::disallowed_methods, reason = "a test works on files")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const OBJECTS: &str = r#"
objects = [
  { at = "2000:00", name = "Speed", type = "u16", access = "rw", pdo = "no", default = 5, src = "1 L2" },
]
"#;

/// A profile with one object.
fn drive() -> String {
    format!("{OBJECTS}{}", include_str!("../../codegen/tests/fixtures/drive.toml"))
}

fn checkout(name: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&root);
    fs::create_dir_all(root.join("profiles/acme/x1")).unwrap();
    fs::create_dir_all(root.join("codegen")).unwrap();
    fs::write(root.join("profiles/acme/x1/drive.toml"), drive()).unwrap();
    root
}

fn regen(root: &Path, arguments: &[&str]) -> (i32, String, String) {
    let Output { status, stdout, stderr } = Command::new(env!("CARGO_BIN_EXE_xtask"))
        .arg("regen")
        .arg("--root")
        .arg(root)
        .args(arguments)
        .output()
        .unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (status.code().unwrap(), text(stdout), text(stderr))
}

#[test]
fn writes_once_and_then_finds_all_up_to_date() {
    let root = checkout("once");
    let (code, out, _) = regen(&root, &[]);
    assert_eq!(code, 0);
    let lines: Vec<&str> = out.lines().filter(|l| l.starts_with("x1")).collect();
    assert_eq!(lines.len(), 1, "one line a drive: {out}");
    assert!(root.join("generated/acme-x1/src/od.rs").exists());
    let (code, out, _) = regen(&root, &[]);
    assert!(code == 0 && out.contains("up to date"), "{out}");
    assert_eq!(regen(&root, &["--check"]).0, 0);
    assert_eq!(regen(&root, &["--check", "--quiet"]).1, "");
}

#[test]
fn check_names_every_difference_and_the_command_and_writes_nothing() {
    let root = checkout("differs");
    assert_eq!(regen(&root, &[]).0, 0);
    let crate_ = root.join("generated/acme-x1");
    fs::write(crate_.join("src/od.rs"), "edited\n").unwrap();
    fs::remove_file(crate_.join("map.txt")).unwrap();
    fs::write(crate_.join("extra.txt"), "").unwrap();
    fs::create_dir_all(root.join("generated/acme-gone/src")).unwrap();
    fs::write(root.join("generated/acme-gone/src/lib.rs"), "").unwrap();
    let (code, out, _) = regen(&root, &["--check"]);
    assert_eq!(code, 1);
    for line in [
        "changed: generated/acme-x1/src/od.rs (first in line 1)",
        "missing: generated/acme-x1/map.txt",
        "orphaned: generated/acme-x1/extra.txt",
        "orphaned: generated/acme-gone/ (no profile makes it)",
        "run `cargo xtask regen` and commit the result",
    ] {
        assert!(out.lines().any(|l| l == line), "{line}\nnot in\n{out}");
    }
    assert!(!crate_.join("map.txt").exists() && crate_.join("extra.txt").exists());
    let (code, out, _) = regen(&root, &["--diff"]);
    assert!(code == 0 && out.contains("-edited") && !crate_.join("map.txt").exists(), "{out}");
    assert_eq!(regen(&root, &[]).0, 0);
    assert!(!crate_.join("extra.txt").exists() && !root.join("generated/acme-gone").exists());
    assert_eq!(regen(&root, &["--check"]).0, 0);
}

#[test]
fn a_profile_with_errors_changes_nothing() {
    let root = checkout("errors");
    assert_eq!(regen(&root, &[]).0, 0);
    let before = fs::read(root.join("generated/acme-x1/map.txt")).unwrap();
    fs::write(root.join("profiles/acme/x1/drive.toml"), drive().replace("default = 5", "default = 70000"))
        .unwrap();
    let (code, out, err) = regen(&root, &[]);
    assert!(code == 1 && err.contains("error[E0402]") && err.contains("nothing was written"), "{out}{err}");
    assert_eq!(fs::read(root.join("generated/acme-x1/map.txt")).unwrap(), before);
}

/// What an unreadable profile makes is not known: nothing below `generated/` may be called a stray then.
#[test]
fn a_profile_that_cannot_be_read_does_not_lose_its_crate() {
    let breaks: [fn(&Path); 3] = [
        |folder| fs::write(folder.join("drive.toml"), drive().replace("format = 1", "format = = 1")).unwrap(),
        |folder| fs::remove_file(folder.join("drive.toml")).unwrap(),
        |folder| fs::write(folder.join("drive.toml"), [0xFF]).unwrap(),
    ];
    for (number, break_) in breaks.iter().enumerate() {
        let root = checkout(&format!("unreadable-{number}"));
        assert_eq!(regen(&root, &[]).0, 0);
        break_(&root.join("profiles/acme/x1"));
        let (code, out, err) = regen(&root, &["--check"]);
        assert!(code == 1 && !out.contains("orphaned"), "{number}: {out}{err}");
        let (code, out, err) = regen(&root, &[]);
        assert!(code == 1 && err.contains("no folder is removed"), "{number}: {out}{err}");
        assert!(root.join("generated/acme-x1/src/od.rs").exists(), "{number}: {out}{err}");
    }
}

/// Two profiles of one package would overwrite each other, and the last would win in silence.
#[test]
fn a_profile_stands_where_its_ids_say_and_alone() {
    let root = checkout("copied");
    fs::create_dir_all(root.join("profiles/acme/x2")).unwrap();
    fs::write(root.join("profiles/acme/x2/drive.toml"), drive()).unwrap();
    let (code, out, err) = regen(&root, &[]);
    assert!(code == 1 && err.contains("profiles/acme/x2 describes `acme` `x1`"), "{out}{err}");
    assert!(err.contains("profiles/acme/x1 and profiles/acme/x2 both make generated/acme-x1"), "{out}{err}");
    assert!(!root.join("generated").exists(), "{out}");
    // The ids of these differ, and the package that they make does not.
    let root = checkout("joined");
    for (vendor, id) in [("a", "b-c"), ("a-b", "c")] {
        let folder = root.join("profiles").join(vendor).join(id);
        fs::create_dir_all(&folder).unwrap();
        let text =
            drive().replace("\"acme\"", &format!("\"{vendor}\"")).replace("\"x1\"", &format!("\"{id}\""));
        fs::write(folder.join("drive.toml"), text).unwrap();
    }
    let (code, out, err) = regen(&root, &["--check"]);
    assert!(code == 1 && !err.contains("describes"), "{out}{err}");
    assert!(err.contains("profiles/a/b-c and profiles/a-b/c both make generated/a-b-c"), "{out}{err}");
}

/// Outside of a checkout there is nothing to look at, and that is no reason to be content.
#[test]
fn tidy_without_files_is_not_content() {
    let root = checkout("no-git");
    let output =
        Command::new(env!("CARGO_BIN_EXE_xtask")).args(["tidy", "--root"]).arg(&root).output().unwrap();
    let out = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.code() == Some(1) && out.contains("git lists no file"), "{out}");
}

#[test]
fn an_unknown_drive_is_wrong_usage() {
    let root = checkout("unknown");
    let (code, _, err) = regen(&root, &["x2"]);
    assert!(code == 2 && err.contains("known: x1"), "{err}");
}

/// A generated manifest that cargo cannot read must not stop the command that would repair it.
#[test]
fn a_broken_generated_manifest_stops_nothing() {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("broken");
    let _ = fs::remove_dir_all(&root);
    let here = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    for folder in ["xtask", "codegen", "runtime", "cli", "profiles/standard", "tests"] {
        copy_manifest(here, &root, folder);
    }
    fs::copy(here.join("Cargo.toml"), root.join("Cargo.toml")).unwrap();
    fs::copy(here.join("xtask/Cargo.lock"), root.join("xtask/Cargo.lock")).unwrap();
    fs::create_dir_all(root.join("generated/acme-x1")).unwrap();
    fs::write(root.join("generated/acme-x1/Cargo.toml"), "this is [[ no manifest").unwrap();
    let metadata = |manifest: &str| {
        let arguments = ["metadata", "--format-version", "1", "--offline", "--manifest-path"];
        Command::new(env!("CARGO")).args(arguments).arg(root.join(manifest)).output().unwrap()
    };
    let workspace = metadata("xtask/Cargo.toml");
    assert!(workspace.status.success(), "{}", String::from_utf8_lossy(&workspace.stderr));
    assert!(!metadata("Cargo.toml").status.success(), "the manifest is not broken: this test proves nothing");
}

fn copy_manifest(from: &Path, to: &Path, folder: &str) {
    fs::create_dir_all(to.join(folder).join("src")).unwrap();
    fs::copy(from.join(folder).join("Cargo.toml"), to.join(folder).join("Cargo.toml")).unwrap();
    for source in ["lib.rs", "main.rs"] {
        if from.join(folder).join("src").join(source).exists() {
            fs::write(to.join(folder).join("src").join(source), "").unwrap();
        }
    }
}
