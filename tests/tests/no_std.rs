//! The runtime without std: built for this machine and, where the target is installed, for a microcontroller.

// Helpers of tests: a command that cannot start fails the test.
#![allow(clippy::unwrap_used)]

use std::process::{Command, Output};

use drivewright_tests::skipped;

const MICROCONTROLLER: &str = "thumbv7em-none-eabihf";

#[test]
fn links_nothing_of_std_on_this_machine() {
    if !cfg!(target_os = "linux") {
        skipped("no_std on this machine", "the linker flags are those of Linux");
        return;
    }
    // Without start files there is no `main`; `memcpy` and its kin still come from the C library.
    succeeds(&build(&[
        "--release",
        "--config",
        "build.rustflags = ['-Clink-arg=-nostartfiles', '-Clink-arg=-lc']",
    ]));
}

#[test]
fn links_on_a_microcontroller() {
    if !installed(MICROCONTROLLER) {
        let why = format!("target {MICROCONTROLLER} is not installed (rustup target add {MICROCONTROLLER})");
        skipped("no_std on a microcontroller", &why);
        return;
    }
    succeeds(&build(&["--release", "--target", MICROCONTROLLER]));
}

/// Builds the crate beside this one that has a panic handler of its own, with everything kept out of its folder.
fn build(arguments: &[&str]) -> Output {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/no-std");
    let target = concat!(env!("CARGO_TARGET_TMPDIR"), "/no-std");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--offline", "--manifest-path"]).arg(format!("{folder}/Cargo.toml"));
    cargo.args(["--target-dir", target]).args(arguments);
    // Flags of the surrounding build, such as coverage, would ask for std.
    cargo.env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    cargo.output().unwrap()
}

fn succeeds(output: &Output) {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Whether the standard library of a target is there, asked of the compiler itself.
fn installed(target: &str) -> bool {
    let rustc = std::env!("CARGO").replace("cargo", "rustc");
    let output = Command::new(rustc).args(["--print", "target-libdir", "--target", target]).output();
    output.is_ok_and(|o| std::path::Path::new(String::from_utf8_lossy(&o.stdout).trim()).exists())
}
