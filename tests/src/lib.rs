//! Helpers of the cross-crate tests.

#![allow(
    clippy::print_stdout,
    clippy::disallowed_methods,
    reason = "what a test could not do must reach whoever runs it"
)]

pub mod bare;
pub mod cases;
pub mod drives;
pub mod esi;
pub mod formats;
pub mod random;

use std::fs::OpenOptions;
use std::io::Write;

/// Says that a test could not do its work on this machine, and why. `cargo xtask test` lists it at its end: a test that
/// passes prints nothing, so the words go to the file that it names.
pub fn skipped(what: &str, why: &str) {
    println!("skipped: {what}: {why}");
    let Some(path) = std::env::var_os("DRIVEWRIGHT_SKIPS") else { return };
    if let Ok(mut file) = OpenOptions::new().append(true).create(true).open(path) {
        // Without the file the line above is all that is said.
        let _ = writeln!(file, "{what}: {why}");
    }
}
