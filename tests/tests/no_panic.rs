//! No panic is reachable: a program whose panic handler calls a function that does not exist links all the same.

// Helpers of tests: a command that cannot start fails the test.
#![allow(clippy::unwrap_used)]

use drivewright_tests::bare::{MICROCONTROLLER, build, buildable};
use drivewright_tests::skipped;

/// The function that does not exist.
const SYMBOL: &str = "something_in_the_runtime_can_panic";
/// Everything, the virtual drive included.
const ALL: &[&str] = &["--release", "--features", "drive"];
/// All but the virtual drive; overflows are panics, as in a debug build.
const CHECKED: &[&str] = &["--profile", "checked"];

#[test]
fn nothing_can_panic_on_this_machine() {
    assert_eq!(linked(None, ALL).unwrap_or(Ok(())), Ok(()));
    assert_eq!(linked(None, CHECKED).unwrap_or(Ok(())), Ok(()));
}

#[test]
fn nothing_can_panic_on_a_microcontroller() {
    assert_eq!(linked(Some(MICROCONTROLLER), ALL).unwrap_or(Ok(())), Ok(()));
    assert_eq!(linked(Some(MICROCONTROLLER), CHECKED).unwrap_or(Ok(())), Ok(()));
}

/// The negative control: an index from outside, and the linker names the function.
#[test]
fn an_index_from_outside_is_seen() {
    for profile in ["release", "checked"] {
        let Some(linked) = linked(None, &["--profile", profile, "--features", "planted"]) else { return };
        let why = linked.unwrap_err();
        assert!(why.contains("undefined") && why.contains(SYMBOL), "{why}");
    }
}

/// What the linker says; `None` where it cannot be asked.
fn linked(target: Option<&str>, arguments: &[&str]) -> Option<Result<(), String>> {
    if let Err(why) = buildable(target) {
        skipped(&format!("no reachable panic on {}", target.unwrap_or("this machine")), &why);
        return None;
    }
    let output = build("no-panic", target, arguments).unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    Some(if output.status.success() { Ok(()) } else { Err(said) })
}
