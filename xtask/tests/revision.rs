//! A manual revision arrives, from the first row to the comment of a reviewer: a checkout of its own, a revision that is
//! made up here, and everything that a maintainer would see of it.
//!
//! The revision of the SDV3-E has two new objects, a raised limit, another default of 605Ah, a renamed alarm and a new
//! homing method, whose number an erratum of 6098h has to follow. None of it is in any manual.

#![allow(clippy::disallowed_methods, reason = "a test works on files")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn here() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
}

fn run(program: &str, at: &Path, arguments: &[&str], variables: &[(&str, &str)]) -> (i32, String, String) {
    let mut command = Command::new(program);
    // What the surrounding test run notes down is of this checkout.
    command
        .env_remove("INSTA_SNAPSHOT_REFERENCES_FILE")
        .env_remove("DRIVEWRIGHT_SKIPS")
        .env_remove("NO_COLOR");
    let output = command.current_dir(at).args(arguments).envs(variables.iter().copied()).output();
    let Output { status, stdout, stderr } = output.unwrap_or_else(|e| panic!("{program}: {e}"));
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (status.code().unwrap(), text(stdout), text(stderr))
}

fn git(at: &Path, arguments: &[&str]) -> String {
    let settings = ["-c", "user.name=a", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false"];
    let all: Vec<&str> = settings.iter().chain(arguments).copied().collect();
    let (code, out, err) = run("git", at, &all, &[]);
    assert_eq!(code, 0, "git {arguments:?}: {err}");
    out
}

/// Every file that git has or would take, in a repository of its own.
fn checkout() -> PathBuf {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("revision");
    let _ = fs::remove_dir_all(&root);
    let files = git(here(), &["ls-files", "-z", "--cached", "--others", "--exclude-standard"]);
    for file in files.split('\0').filter(|f| !f.is_empty() && here().join(f).is_file()) {
        fs::create_dir_all(root.join(file).parent().unwrap()).unwrap();
        fs::copy(here().join(file), root.join(file)).unwrap();
    }
    git(&root, &["init", "-q"]);
    git(&root, &["add", "."]);
    git(&root, &["commit", "-q", "-m", "before"]);
    root
}

const PROFILE: &str = "profiles/savch/sdv3-e";

/// In the row of `file` that has `row`, `old` becomes `new`; it must be there once.
fn edit(root: &Path, file: &str, row: &str, old: &str, new: &str) {
    let path = root.join(PROFILE).join(file);
    let text = fs::read_to_string(&path).unwrap();
    let mut found = 0;
    let edited: Vec<String> = text
        .lines()
        .map(|line| {
            let hit = line.contains(row) && line.contains(old);
            found += usize::from(hit);
            if hit { line.replacen(old, new, 1) } else { line.to_owned() }
        })
        .collect();
    assert_eq!(found, 1, "{file}: {row}: {old}");
    fs::write(path, edited.join("\n") + "\n").unwrap();
}

/// A row at the end of a list.
fn add(root: &Path, file: &str, rows: &str) {
    let path = root.join(PROFILE).join(file);
    let text = fs::read_to_string(&path).unwrap();
    let list = text.trim_end().strip_suffix(']').expect("a list");
    fs::write(path, format!("{list}{rows}]\n")).unwrap();
}

fn revise(root: &Path) {
    edit(root, "objects.toml", "at = \"605A:00\"", "default = 0", "default = 1");
    edit(root, "objects.toml", "at = \"6099:01\"", "max = 60000", "max = 65000");
    edit(root, "objects.toml", "at = \"6098:00\"", "max = 37", "max = 38");
    edit(root, "errata.toml", "id = \"E012\"", "was = 37", "was = 38");
    edit(root, "alarms.toml", "display = \"OS\"", "\"Over speed\"", "\"Overspeed of the motor\"");
    add(
        root,
        "homing.toml",
        "  { method = 38, start = \"positive\", reference = \"home\", when = \"home off\", moves = \"+ slow until home on; latch\", src = \"4.4 L596\" },\n",
    );
    add(
        root,
        "objects.toml",
        "  { at = \"60B1:00\", name = \"Velocity Offset\", type = \"i32\", access = \"rw\", pdo = \"rx\", unit = \"0.1 rpm\", min = -60000, max = 60000, default = 0, src = \"6.2 T6-2 L1249\" },\n\
         \u{20} { at = \"4010:00\", name = \"Fan Hours\", type = \"u32\", access = \"ro\", pdo = \"no\", unit = \"h\", src = \"6.2 T6-2 L1250\" },\n",
    );
}

fn regen(root: &Path, more: &[&str]) -> (i32, String) {
    let path = root.to_string_lossy();
    let mut arguments = vec!["regen", "--root", path.as_ref()];
    arguments.extend(more);
    // What a format cannot express is said on standard error, with every run.
    let (code, out, _) = run(env!("CARGO_BIN_EXE_xtask"), root, &arguments, &[]);
    (code, out)
}

fn cargo(at: &Path, arguments: &[&str], variables: &[(&str, &str)]) -> (i32, String, String) {
    let manifest = here().join("Cargo.toml");
    let manifest = manifest.to_string_lossy();
    let (command, rest) = arguments.split_first().unwrap();
    let all: Vec<&str> = [*command, "--quiet", "--manifest-path", manifest.as_ref()]
        .into_iter()
        .chain(rest.iter().copied())
        .collect();
    run(env!("CARGO"), at, &all, variables)
}

fn diff(root: &Path, more: &[&str]) -> (i32, String) {
    let all: Vec<&str> = ["run", "-p", "drivewright", "--", "diff"].iter().chain(more).copied().collect();
    let (code, out, err) = cargo(root, &all, &[]);
    assert_eq!(err, "", "{more:?}");
    (code, out)
}

/// What git sees as changed or new.
fn touched(root: &Path) -> BTreeSet<String> {
    git(root, &["status", "--porcelain", "-uall"]).lines().map(|line| line[3..].to_owned()).collect()
}

const REPORT: &str = "\
savch-sdv3-e 0.1.0 -> 0.1.0: 3 axis, 4 new, 3 documentation
version 0.1.0 is too low: raise `crate_version` in drive.toml from 0.1.0 to at least 0.2.0 (minor): code may not compile or an axis may do something else, and nobody may get that by `cargo update`; Cargo takes 0.y as incompatible with the y before

Values that move axes (6)
  ~ object 605A:00 default: 0 -> 1
      axis, option code: The drive starts with another value where nobody writes one. (default_changed)
      manual: 6.2 T6-2 L1211 -> 6.2 T6-2 L1211
  ~ object 6098:00 max: 37 -> 38
      axis, homing: The drive takes values that it refused. (range_widened)
      manual: 6.2 T6-2 L1243 [E012] -> 6.2 T6-2 L1243 [E012]
  ~ object 6099:01 max: 60000 -> 65000
      axis, homing: The drive takes values that it refused. (range_widened)
      manual: 6.2 T6-2 L1245 -> 6.2 T6-2 L1245
  + object 60B1:00: name Velocity Offset, kind var, type i32, access rw, pdo rx, unit 0.1 rpm, min -60000, max 60000, default 0
      new, target: There was no such entry. (entry_added)
      manual: 6.2 T6-2 L1249
  + homing 38: status supported, reference home, start positive
      new, homing: There was no such method. (homing_method_added)
      manual: 4.4 L596
  + homing 38.1: when home off, moves + slow until home on; latch
      new, homing: There was no such method. (homing_method_added)
      manual: 4.4 L596

New (1)
  + object 4010:00: name Fan Hours, kind var, type u32, access ro, pdo no, unit h
      new: There was no such entry. (entry_added)
      manual: 6.2 T6-2 L1250

Documentation (3)
  ~ alarm OS 0x03 name: Over speed -> Overspeed of the motor
      documentation: Alarms are found by display, number and code: their names are texts. (alarm_renamed)
      manual: 5.1 T5-1 L849 -> 5.1 T5-1 L849
  ~ alarm OS 0x03 handle: over_speed -> overspeed_of_the_motor
      documentation: Alarms are found by display, number and code: their names are texts. (alarm_renamed)
      manual: 5.1 T5-1 L849 -> 5.1 T5-1 L849
  ~ erratum E012 was: 37 -> 38
      documentation: Manuals, abort codes, examples and errata explain; values that they change are differences of their own. (sources_and_reasons)
      manual: 6.2 T6-2 L1243, 4.4 L535 -> 6.2 T6-2 L1243, 4.4 L535
";

/// The rows of a text snapshot that a reviewer is asked about: those of the new one that the old one does not have.
fn asked(root: &Path, name: &str) -> Vec<String> {
    let folder = root.join("tests/tests/snapshots/drives");
    let old = fs::read_to_string(folder.join(format!("{name}.snap"))).unwrap();
    let new = fs::read_to_string(folder.join(format!("{name}.snap.new"))).unwrap();
    let body = |text: &str| text.splitn(3, "---\n").nth(2).unwrap().to_owned();
    let known: Vec<String> = body(&old).lines().map(str::to_owned).collect();
    body(&new).lines().filter(|line| !known.iter().any(|k| k == line)).map(str::to_owned).collect()
}

#[test]
fn a_manual_revision_arrives() {
    let root = checkout();
    assert_eq!(regen(&root, &["--check", "--quiet"]), (0, String::new()), "the checkout is fresh");
    revise(&root);
    let (code, out) = regen(&root, &["sdv3-e"]);
    assert_eq!(code, 0, "{out}");

    only_what_follows_from_it_is_touched(&root);
    assert_eq!(diff(&root, &["--base", "HEAD", "sdv3-e"]), (0, REPORT.to_owned()));
    assert_eq!(diff(&root, &["HEAD:profiles/savch/sdv3-e", "sdv3-e"]), (0, REPORT.to_owned()));
    assert_eq!(diff(&root, &["--base", "HEAD", "sdv3-e", "--fail-on", "version"]).0, 1, "0.1.0 is too low");
    reviewers_see_lines(&root);

    edit(&root, "drive.toml", "crate_version", "0.1.0", "0.2.0");
    assert_eq!(regen(&root, &[]).0, 0);
    assert_eq!(diff(&root, &["--base", "HEAD", "sdv3-e", "--fail-on", "version"]).0, 0);
    a_second_regen_changes_nothing(&root);
}

fn only_what_follows_from_it_is_touched(root: &Path) {
    let all = touched(root);
    let mine: Vec<&str> = all.iter().filter_map(|f| f.strip_prefix(PROFILE)).collect();
    assert_eq!(mine, ["/alarms.toml", "/errata.toml", "/homing.toml", "/objects.toml"]);
    let made: BTreeSet<&str> = all.iter().filter_map(|f| f.strip_prefix("generated/savch-sdv3-e/")).collect();
    assert_eq!(all.len(), mine.len() + made.len(), "files of others: {all:?}");
    for file in [
        "map.txt",
        "model.json",
        "eds/savch-sdv3-e.eds",
        "src/alarms.rs",
        "src/homing.rs",
        "src/od.rs",
        "src/table.rs",
    ] {
        assert!(made.contains(file), "{file} should follow: {made:?}");
    }
    for file in ["src/bits.rs", "src/enums.rs", "src/pdo.rs", "src/lib.rs", "Cargo.toml"] {
        assert!(!made.contains(file), "{file} says nothing of it");
    }
}

/// `cargo insta review` shows text, one row a line; each asks about the rows of its side and no others.
fn reviewers_see_lines(root: &Path) {
    let path = root.to_string_lossy();
    let variables =
        [("DRIVEWRIGHT_CHECKOUT", path.as_ref()), ("INSTA_UPDATE", "new"), ("INSTA_FORCE_PASS", "1")];
    let (code, out, err) = cargo(root, &["test", "-p", "drivewright-tests", "--test", "drives"], &variables);
    assert_eq!(code, 0, "{out}{err}");
    let api = asked(root, "sdv3-e.api");
    let keys: Vec<&str> = api.iter().filter_map(|line| line.split_once(": ")).map(|(key, _)| key).collect();
    assert_eq!(
        keys,
        ["object 4010:00", "object 6098:00", "object 6099:01", "object 60B1:00", "alarm OS 0x03"]
    );
    assert_eq!(api[0], "object 4010:00: handle fan_hours, type u32, access ro, pdo no, unit h");
    let axis = asked(root, "sdv3-e.axis");
    assert_eq!(axis[0], "object 605A:00: allow 0 1 5, default 1, values quick stop option");
    assert_eq!(axis[axis.len() - 1], "homing 38.1: when home off, moves + slow until home on; latch");
    assert_eq!(axis.len(), 6, "{axis:#?}");
}

fn a_second_regen_changes_nothing(root: &Path) {
    git(root, &["add", "."]);
    git(root, &["commit", "-q", "-m", "after"]);
    let (code, out) = regen(root, &[]);
    assert!(code == 0 && out.lines().any(|l| l.starts_with("sdv3-e") && l.ends_with("up to date")), "{out}");
    assert_eq!(touched(root), BTreeSet::new());
    assert_eq!(regen(root, &["--check", "--quiet"]), (0, String::new()));
    assert_eq!(diff(root, &["--base", "HEAD"]), (0, "no drive has changed\n".to_owned()));
}
