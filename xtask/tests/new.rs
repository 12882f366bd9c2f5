//! `new` on a small checkout: what it makes compiles, states nothing, and is never written over.

#![allow(clippy::disallowed_methods, reason = "a test works on files")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn checkout(name: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("new").join(name);
    let _ = fs::remove_dir_all(&root);
    fs::create_dir_all(root.join("profiles")).unwrap();
    fs::create_dir_all(root.join("codegen")).unwrap();
    root
}

fn xtask(root: &Path, arguments: &[&str]) -> (i32, String, String) {
    let output =
        Command::new(env!("CARGO_BIN_EXE_xtask")).args(arguments).arg("--root").arg(root).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

#[test]
fn a_new_drive_compiles_and_says_what_it_lacks() {
    let root = checkout("made");
    let (code, out, err) = xtask(&root, &["new", "acme/x9"]);
    assert_eq!((code, err.as_str()), (0, ""));
    let at = |text: &str| out.find(text).unwrap_or_else(|| panic!("{text} is not in\n{out}"));
    assert!(at("to enable\n") < at("6040h Controlword") && at("6040h Controlword") < at("to commission\n"));
    assert!(at("to commission\n") < at("605Ah Quick stop option code") && at("605Ah Quick") < at("nice\n"));
    let (code, out, _) = xtask(&root, &["regen"]);
    assert!(code == 0 && out.contains("x9         0 objects, 0 entries"), "{out}");
    let map = fs::read_to_string(root.join("generated/acme-x9/map.txt")).unwrap();
    assert!(map.ends_with("# 0 facts: 0 stated, 0 inferred, 0 standard, 0 assumed. 9 own.\n"), "{map}");
    let objects = fs::read_to_string(root.join("profiles/acme/x9/objects.toml")).unwrap();
    assert!(objects.starts_with("# ") && objects.ends_with("objects = [\n]\n"), "{objects}");
}

#[test]
fn a_drive_that_is_there_is_left_alone() {
    let root = checkout("twice");
    assert_eq!(xtask(&root, &["new", "acme/x9"]).0, 0);
    fs::write(root.join("profiles/acme/x9/objects.toml"), "years of work").unwrap();
    let (code, _, err) = xtask(&root, &["new", "acme/x9"]);
    assert!(code == 2 && err.contains("there already"), "{err}");
    assert_eq!(fs::read_to_string(root.join("profiles/acme/x9/objects.toml")).unwrap(), "years of work");
}

#[test]
fn names_that_are_no_ids_are_refused() {
    let root = checkout("names");
    for name in [
        "acme",
        "acme/",
        "/x9",
        "Acme/x9",
        "acme/x 9",
        "acme/../x9",
        "../x9",
        "acme/x9/y",
        "9acme/x",
        "standard/x9",
        "acme/x\u{e9}",
    ] {
        let (code, _, err) = xtask(&root, &["new", name]);
        assert!(code == 2 && err.contains("is no VENDOR/DRIVE"), "{name}: {err}");
    }
    assert_eq!(xtask(&root, &["new"]).0, 2);
    assert_eq!(fs::read_dir(root.join("profiles")).unwrap().count(), 0, "nothing is made");
}
