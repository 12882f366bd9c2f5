//! The runtime without std: built for this machine and, where the target is installed, for a microcontroller.

// Helpers of tests: a command that cannot start fails the test.
#![allow(clippy::unwrap_used)]

use drivewright_tests::bare::{MICROCONTROLLER, build, buildable};
use drivewright_tests::skipped;

#[test]
fn links_nothing_of_std_on_this_machine() {
    links(None);
}

#[test]
fn links_on_a_microcontroller() {
    links(Some(MICROCONTROLLER));
}

fn links(target: Option<&str>) {
    if let Err(why) = buildable(target) {
        return skipped(&format!("no_std on {}", target.unwrap_or("this machine")), &why);
    }
    let output = build("no-std", target, &["--release"]).unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
