//! `drivewright diff` as a user calls it: every way to name a side, formats, exit codes.

#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::disallowed_methods,
    reason = "a test runs the program on files"
)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn drive(default: u32, version: &str) -> String {
    let row = format!(
        "objects = [\n  {{ at = \"2000:00\", name = \"Speed\", type = \"u16\", access = \"rw\", default = {default}, src = \"1 L2\" }},\n]\n"
    );
    let fixture = include_str!("../../codegen/tests/fixtures/drive.toml");
    format!(
        "{row}{}",
        fixture.replace("crate_version = \"0.1.0\"", &format!("crate_version = \"{version}\""))
    )
}

fn run(at: &Path, arguments: &str) -> (i32, String, String) {
    let program =
        Command::new(env!("CARGO_BIN_EXE_drivewright")).current_dir(at).args(arguments.split(' ')).output();
    let Output { status, stdout, stderr } = program.expect("the program runs");
    let text = |bytes| String::from_utf8(bytes).expect("a text");
    (status.code().expect("a code"), text(stdout), text(stderr))
}

fn git(at: &Path, arguments: &[&str]) {
    let settings = ["-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false"];
    let status =
        Command::new("git").current_dir(at).args(settings).args(arguments).status().expect("git runs");
    assert!(status.success(), "git {arguments:?}");
}

/// A repository with a drive in its first commit, and another default in the work tree.
fn repository(name: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("diff").join(name);
    let _ = fs::remove_dir_all(&root);
    fs::create_dir_all(root.join("profiles/acme/x1")).expect("a folder");
    fs::write(root.join("profiles/acme/x1/drive.toml"), drive(5, "0.1.0")).expect("a file");
    git(&root, &["init", "-q"]);
    git(&root, &["add", "."]);
    git(&root, &["commit", "-qm", "one"]);
    fs::write(root.join("profiles/acme/x1/drive.toml"), drive(6, "0.1.0")).expect("a file");
    root
}

const CHANGE: &str = "  ~ object 2000:00 default: 5 -> 6\n      axis: The drive starts with another value where nobody writes one. (default_changed)\n      manual: 1 L2 -> 1 L2\n";

#[test]
fn every_way_to_name_a_side_gives_the_same() {
    let root = repository("sides");
    fs::create_dir_all(root.join("old")).expect("a folder");
    fs::write(root.join("old/drive.toml"), drive(5, "0.1.0")).expect("a file");
    assert_eq!(run(&root, "build old --out built --only json").0, 0);
    let (code, wanted, _) = run(&root, "diff old profiles/acme/x1");
    assert!(code == 0 && wanted.contains(CHANGE) && !wanted.contains('\u{1b}'), "{wanted}");
    for arguments in [
        "diff old x1",
        "diff built/model.json x1",
        "diff HEAD:profiles/acme/x1 x1",
        "diff HEAD:./profiles/acme/x1/ ./profiles/acme/x1",
        "diff --base HEAD x1",
        "diff --base HEAD profiles/acme/x1",
        "diff --base HEAD",
    ] {
        assert_eq!(run(&root, arguments), (0, wanted.clone(), String::new()), "{arguments}");
    }
    assert_eq!(run(&root, "diff x1 x1").1, "acme-x1 0.1.0 -> 0.1.0: no difference\n");
}

#[test]
fn what_was_generated_is_what_users_had() {
    let root = repository("generated");
    assert_eq!(run(&root, "build x1 --out generated/acme-x1").0, 0);
    git(&root, &["add", "generated"]);
    git(&root, &["commit", "-qm", "generated with the new default, beside the old profile"]);
    assert_eq!(run(&root, "diff --base HEAD").1, "no drive has changed\n");
}

#[test]
fn drives_come_and_go() {
    let root = repository("come-and-go");
    fs::rename(root.join("profiles/acme/x1"), root.join("profiles/acme/x2")).expect("a folder");
    let text = drive(5, "0.1.0").replace("id = \"x1\"", "id = \"x2\"");
    fs::write(root.join("profiles/acme/x2/drive.toml"), text).expect("a file");
    let (code, out, err) = run(&root, "diff --base HEAD");
    assert!(code == 0 && err.is_empty(), "{err}");
    assert!(
        out.starts_with("acme-x2 0.1.0: 3 new, 1 documentation\nversion 0.1.0: the drive is new")
            || out.contains("the drive is new"),
        "{out}"
    );
    assert!(
        out.contains("(drive_added)") && out.contains("(drive_removed)") && out.contains("the drive is gone"),
        "{out}"
    );
}

#[test]
fn a_difference_is_a_finding_only_if_asked() {
    let root = repository("codes");
    for (what, code) in [("breaking", 0), ("axis", 1), ("any", 1), ("version", 1)] {
        assert_eq!(run(&root, &format!("diff --base HEAD --fail-on {what}")).0, code, "{what}");
    }
    fs::write(root.join("profiles/acme/x1/drive.toml"), drive(6, "0.2.0")).expect("a file");
    assert_eq!(run(&root, "diff --base HEAD --fail-on version").0, 0);
    assert_eq!(run(&root, "diff x1 x1 --fail-on any").0, 0);
}

#[test]
fn what_cannot_be_compared_is_said() {
    let root = repository("wrong");
    for (arguments, code, words) in [
        ("diff x1", 2, "OLD and NEW"),
        ("diff x1 nowhere", 2, "no drive or folder"),
        ("diff nope:profiles/acme/x1 x1", 2, "no revision `nope`"),
        ("diff HEAD:profiles/acme/x7 x1", 2, "nothing at HEAD:profiles/acme/x7"),
        ("diff --base nope x1", 2, "no revision"),
        ("diff --base=--output=stolen x1", 2, "no revision"),
        ("diff x1 profiles/acme/x1/drive.toml", 1, "no JSON"),
    ] {
        let (found, out, err) = run(&root, arguments);
        assert!(found == code && out.is_empty() && err.contains(words), "{arguments}: {found} {err}");
    }
    assert!(!root.join("stolen").exists() && !root.join("profiles/acme/x1/stolen").exists());
    fs::write(root.join("later.json"), r#"{"format": 9}"#).expect("a file");
    let (code, _, err) = run(&root, "diff later.json x1");
    assert!(code == 1 && err.contains("`format` is 9"), "{err}");
    fs::write(root.join("profiles/acme/x1/drive.toml"), drive(70_000, "0.1.0")).expect("a file");
    let (code, _, err) = run(&root, "diff HEAD:profiles/acme/x1 x1");
    assert!(code == 1 && err.contains("error[E0402]") && err.contains("x1: it has 1 error"), "{err}");
}

#[test]
fn for_programs_and_for_a_comment() {
    let root = repository("formats");
    let json: serde_json::Value =
        serde_json::from_str(&run(&root, "diff --base HEAD --format json").1).expect("JSON");
    assert_eq!(json["format"], 1);
    let drive = &json["drives"][0];
    assert_eq!((&drive["package"], &drive["verdict"]["needs"]), (&"acme-x1".into(), &"0.2.0".into()));
    let change = &drive["changes"][0];
    for (key, value) in
        [("key", "object 2000:00"), ("field", "default"), ("effect", "axis"), ("rule", "default_changed")]
    {
        assert_eq!(change[key], value);
    }
    assert_eq!((&change["old"]["value"], &change["new"]["value"]), (&5.into(), &6.into()));
    assert_eq!(change["new"]["cite"], "1 L2");
    let (_, page, _) = run(&root, "diff --base HEAD --format markdown");
    assert!(page.contains("| object 2000:00 default | 5 | 6 | 1 L2 | **axis**: The drive starts"), "{page}");
    git(&root, &["commit", "-qam", "two"]);
    assert_eq!(run(&root, "diff --base HEAD --format markdown").1, "No drive has changed.\n");
}
