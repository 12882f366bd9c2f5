//! What tests of the commands share that run a drive.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

/// The profile of the SDV3-E.
pub(crate) fn sdv3_e() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../profiles/savch/sdv3-e")
}

/// An empty folder of a test of these.
pub(crate) fn folder(tests: &str, name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(tests).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

pub(crate) fn out(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

pub(crate) fn err(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}
