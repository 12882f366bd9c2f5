//! The drives of the repository.

#![allow(clippy::panic, reason = "a test without its data is no test")]

use std::path::{Path, PathBuf};

use drivewright_codegen::load;

/// The folder of every drive below `profiles/`, in path order.
///
/// # Panics
///
/// Where there is none, or the folders cannot be read.
pub fn all() -> Vec<PathBuf> {
    let profiles = Path::new(env!("CARGO_MANIFEST_DIR")).join("../profiles");
    let all = load::drives(&profiles).unwrap_or_else(|e| panic!("{}: {e}", profiles.display()));
    assert!(!all.is_empty(), "no drive below {}", profiles.display());
    all
}
