//! The drives of the repository.

#![allow(clippy::panic, reason = "a test without its data is no test")]

use std::fs;
use std::path::{Path, PathBuf};

/// The folder of every drive below `profiles/`, in path order.
///
/// # Panics
///
/// Where there is none, or the folders cannot be read.
pub fn all() -> Vec<PathBuf> {
    below(&[env!("CARGO_MANIFEST_DIR"), "..", "profiles"].iter().collect::<PathBuf>())
}

/// The same in another checkout.
///
/// # Panics
///
/// Where there is none, or the folders cannot be read.
pub fn below(profiles: &Path) -> Vec<PathBuf> {
    let vendors = folders(profiles).into_iter().filter(|v| !v.ends_with("standard"));
    let all: Vec<PathBuf> = vendors.flat_map(|vendor| folders(&vendor)).collect();
    assert!(!all.is_empty(), "no drive below {}", profiles.display());
    all
}

fn folders(of: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(of).unwrap_or_else(|e| panic!("{}: {e}", of.display()));
    let mut found: Vec<PathBuf> = entries.flatten().map(|e| e.path()).filter(|p| p.is_dir()).collect();
    found.sort();
    found
}
