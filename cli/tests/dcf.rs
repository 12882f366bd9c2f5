//! `drivewright dcf` as a user calls it: what it writes, what it refuses, and its exit codes.

#![allow(clippy::expect_used, clippy::disallowed_methods, reason = "a test runs the program on files")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const GOOD: &str = r#"
axis = { format = 1, drive = "x1", node_id = 5 }
values = [ { at = "6081:00", value = "150.0 rpm" } ]
"#;

fn folder(name: &str, configuration: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("dcf").join(name);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).expect("a folder");
    fs::write(path.join("axis.toml"), configuration).expect("a file");
    path
}

/// The exit code, standard output and standard error of `drivewright dcf` for the drive `x1`.
fn run(at: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let drive = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/golden/canopen/in");
    let mut program = Command::new(env!("CARGO_BIN_EXE_drivewright"));
    let done =
        program.current_dir(at).args(["dcf", drive]).args(arguments).output().expect("the program runs");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (done.status.code(), text(&done.stdout), text(&done.stderr))
}

#[test]
fn a_configuration_is_written_checked_and_printed() {
    let at = folder("good", GOOD);
    let files = ["--config", "axis.toml", "--out", "out/lift.dcf", "--concise", "axis.bin"];
    let check = [&files[..], &["--check"]].concat();
    let (code, out, _) = run(&at, &check);
    assert_eq!((code, out.as_str()), (Some(1), "missing: out/lift.dcf\nmissing: axis.bin\n"));
    assert!(!at.join("out").exists(), "a check writes nothing");
    assert_eq!(run(&at, &["--config", "axis.toml", "--check"]).0, Some(2), "there is no file to compare");
    let (code, out, err) = run(&at, &files);
    assert_eq!(
        (code, out.as_str(), err.as_str()),
        (Some(0), "out/lift.dcf, axis.bin: written, 1 write for node 5\n", "")
    );
    let dcf = fs::read_to_string(at.join("out/lift.dcf")).expect("a file");
    assert!(dcf.contains("FileName=lift.dcf\r\n") && dcf.contains("NodeID=5\r\n"));
    // 150.0 rpm are 1500 (05DCh) counts of 0.1 rpm.
    let concise = [1, 0, 0, 0, 0x81, 0x60, 0, 4, 0, 0, 0, 0xDC, 0x05, 0, 0];
    assert_eq!(fs::read(at.join("axis.bin")).expect("a file"), concise);
    assert_eq!(run(&at, &check).0, Some(0));
    fs::write(at.join("axis.bin"), b"edited").expect("a file");
    assert_eq!((run(&at, &check).0, run(&at, &check).1.as_str()), (Some(1), "changed: axis.bin\n"));
    let (code, printed, _) = run(&at, &["--config", "axis.toml"]);
    assert_eq!((code, printed), (Some(0), dcf.replace("lift.dcf", "axis.dcf")));
}

#[test]
fn mistakes_have_their_place_and_nothing_is_written() {
    let at = folder("bad", &GOOD.replace("150.0", "150.05").replace("node_id = 5", "node_id = 128"));
    let files = ["--config", "axis.toml", "--out", "axis.dcf"];
    let (code, out, err) = run(&at, &files);
    assert_eq!((code, out.as_str()), (Some(1), ""));
    assert!(err.contains("error[E2003]") && err.contains("axis.toml:2:46"), "{err}");
    assert!(
        err.contains("error[E2010]")
            && err.contains("axis.toml: 2 errors")
            && err.contains("nothing was written")
    );
    assert!(!at.join("axis.dcf").exists());
    let (_, json, _) = run(&at, &[&files[..], &["--format", "json"]].concat());
    assert!(json.starts_with(r#"{"code":"E2003","severity":"error""#) && json.lines().count() == 2, "{json}");
    let (_, github, _) = run(&at, &[&files[..], &["--format", "github"]].concat());
    assert!(github.starts_with("::error file=axis.toml,line=2,col=46,"), "{github}");
}

#[test]
fn a_warning_stops_nothing() {
    let text = format!(
        "{GOOD}pdo = [ {{ map = 0x1600, entry = \"6040:00\" }}, {{ map = 0x1600, entry = \"60FF:00\" }} ]"
    );
    let at = folder("warning", &text.replace("6081", "60FF"));
    let (code, _, err) = run(&at, &["--config", "axis.toml", "--out", "axis.dcf"]);
    assert!(code == Some(0) && err.contains("warning[W2018]") && at.join("axis.dcf").exists(), "{err}");
}

#[test]
fn what_cannot_be_read_or_is_not_meant_is_said() {
    let at = folder("missing", GOOD);
    let (code, _, err) = run(&at, &["--config", "nowhere.toml"]);
    assert!(code == Some(3) && err.contains("error[E0001]") && err.contains("nowhere.toml"), "{err}");
    assert_eq!(run(&at, &[]).0, Some(2), "no configuration is named");
    let (code, out, err) = run(&at, &["--config", "axis.toml", "--json"]);
    assert!(code == Some(2) && out.is_empty() && err.contains("--out or --concise"), "{err}");
    fs::write(at.join("axis.toml"), b"axis = \"\xFC\"").expect("a file");
    assert_eq!(run(&at, &["--config", "axis.toml"]).0, Some(1), "it is not UTF-8");
    // A folder stands where the file should go.
    let at = folder("taken", GOOD);
    fs::create_dir(at.join("axis.dcf")).expect("a folder");
    let (code, _, err) = run(&at, &["--config", "axis.toml", "--out", "axis.dcf"]);
    assert!(code == Some(3) && err.contains("error: "), "{err}");
}
