//! The sink against a real disk: what it writes, sees and leaves behind, also when it is killed.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "a test works on files")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

use drivewright_codegen::emit::FileSet;
use drivewright_codegen::sink::{self, State};

/// A folder below cargo's own for tests, empty at first.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("sink").join(name);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).expect("a folder");
    path
}

fn set(files: &[(&str, &str)]) -> FileSet {
    let mut set = FileSet::default();
    for (path, text) in files {
        set.add(*path, *text).expect("a path");
    }
    set
}

fn states(found: &[sink::Difference]) -> Vec<(&str, State, Option<usize>)> {
    found.iter().map(|d| (d.path.as_str(), d.state, d.line)).collect()
}

#[test]
fn check_names_missing_changed_and_orphaned_files_and_writes_nothing() {
    let folder = folder("check");
    fs::write(folder.join("changed.txt"), "one\nTWO\nthree\n").expect("a file");
    fs::create_dir(folder.join("old")).expect("a folder");
    fs::write(folder.join("old/orphan.txt"), "").expect("a file");
    let set = set(&[("changed.txt", "one\ntwo\nthree\n"), ("new/missing.txt", "x")]);
    let found = sink::check(&set, &folder).expect("a comparison");
    let expected = [
        ("changed.txt", State::Changed, Some(2)),
        ("new/missing.txt", State::Missing, None),
        ("old/orphan.txt", State::Orphaned, None),
    ];
    assert_eq!(states(&found), expected);
    assert!(!folder.join("new").exists() && folder.join("old/orphan.txt").exists());
    assert_eq!(fs::read_to_string(folder.join("changed.txt")).expect("a text"), "one\nTWO\nthree\n");
}

#[test]
fn write_makes_the_folder_equal_and_touches_nothing_twice() {
    let folder = folder("write");
    fs::create_dir(folder.join("old")).expect("a folder");
    fs::write(folder.join("old/orphan.txt"), "").expect("a file");
    fs::create_dir(folder.join("target")).expect("cargo's folder");
    fs::write(folder.join("target/kept"), "").expect("a file of cargo's");
    let set = set(&[("a.txt", "a"), ("deep/er/b.txt", "b")]);
    assert_eq!(sink::write(&set, &folder).expect("written").len(), 3);
    assert!(sink::check(&set, &folder).expect("a comparison").is_empty());
    assert!(!folder.join("old").exists() && folder.join("target/kept").exists());
    let time = |path: &str| fs::metadata(folder.join(path)).and_then(|m| m.modified()).expect("a time");
    let before = time("a.txt");
    assert!(sink::write(&set, &folder).expect("written").is_empty());
    assert_eq!(time("a.txt"), before);
}

#[test]
fn a_missing_folder_has_everything_missing() {
    let folder = folder("none").join("not-there");
    let found = sink::check(&set(&[("a", "")]), &folder).expect("a comparison");
    assert_eq!(states(&found), [("a", State::Missing, None)]);
}

#[cfg(unix)]
#[test]
fn links_are_never_followed() {
    let (outside, folder) = (folder("outside"), folder("links"));
    fs::write(outside.join("kept.txt"), "kept").expect("a file");
    std::os::unix::fs::symlink(&outside, folder.join("link")).expect("a link");
    let found = sink::write(&set(&[("a", "")]), &folder).expect("written");
    assert_eq!(states(&found), [("a", State::Missing, None), ("link", State::Orphaned, None)]);
    assert!(outside.join("kept.txt").exists() && !folder.join("link").exists());
}

/// A link in the place of a file is another thing than the file, whatever it leads to.
#[cfg(unix)]
#[test]
fn a_link_is_no_file() {
    let (outside, folder) = (folder("outside-file"), folder("link-to-file"));
    fs::write(outside.join("kept.txt"), "same").expect("a file");
    let set = set(&[("a.txt", "same")]);
    std::os::unix::fs::symlink(outside.join("kept.txt"), folder.join("a.txt")).expect("a link");
    assert_eq!(states(&sink::check(&set, &folder).expect("a comparison")), [("a.txt", State::Changed, None)]);
    sink::write(&set, &folder).expect("written");
    assert!(fs::symlink_metadata(folder.join("a.txt")).expect("a file").is_file());
    assert!(sink::check(&set, &folder).expect("a comparison").is_empty());
    assert!(fs::symlink_metadata(outside.join("kept.txt")).expect("a file").is_file());
}

/// Names the folder in the child that is to be killed.
const CHILD: &str = "DRIVEWRIGHT_SINK_CHILD";

fn version(of: char) -> FileSet {
    let mut set = FileSet::default();
    for n in 0..60 {
        set.add(format!("f{n:02}.txt"), of.to_string().repeat(20_000)).expect("a path");
    }
    set
}

/// Not a test by itself: the process that [`a_killed_write_leaves_each_file_old_or_new`] kills.
#[test]
fn child_that_is_killed() {
    let Ok(folder) = std::env::var(CHILD) else { return };
    loop {
        sink::write(&version('b'), Path::new(&folder)).expect("written");
        sink::write(&version('a'), Path::new(&folder)).expect("written");
    }
}

#[test]
fn a_killed_write_leaves_each_file_old_or_new() {
    let folder = folder("killed");
    sink::write(&version('a'), &folder).expect("written");
    let mut mixed = 0;
    let kills = std::env::var("DRIVEWRIGHT_KILLS").ok().and_then(|n| n.parse().ok()).unwrap_or(40);
    for round in 0..kills {
        let exe = std::env::current_exe().expect("this test");
        let mut child = Command::new(exe)
            .args(["--exact", "child_that_is_killed"])
            .env(CHILD, &folder)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("a child");
        std::thread::sleep(Duration::from_millis(15 + round % 40 * 3));
        child.kill().expect("killed");
        child.wait().expect("gone");
        mixed += usize::from(old_and_new(&folder));
    }
    assert!(mixed > 0, "no kill fell between two files: the test proves nothing");
    sink::write(&version('a'), &folder).expect("repaired");
    assert!(
        sink::check(&version('a'), &folder).expect("a comparison").is_empty(),
        "a next run repairs, leftovers included"
    );
}

/// Asserts that each file is whole; whether both versions are there.
fn old_and_new(folder: &Path) -> bool {
    let (mut old, mut new) = (0, 0);
    for n in 0..60 {
        let text = fs::read_to_string(folder.join(format!("f{n:02}.txt"))).expect("each file is there");
        let first = text.chars().next().expect("no file is empty");
        assert!(text.len() == 20_000 && text.chars().all(|c| c == first), "file {n} is half written");
        if first == 'a' { old += 1 } else { new += 1 }
    }
    old > 0 && new > 0
}
