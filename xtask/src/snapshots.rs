//! Snapshots that no test looks at any more. insta writes down which it looked at; every other one is dead.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::outcome::Outcome;
use crate::tidy;

/// Where insta is told to write.
pub const VARIABLE: &str = "INSTA_SNAPSHOT_REFERENCES_FILE";

/// The file that insta writes: one path a line.
pub fn references(root: &Path) -> PathBuf {
    root.join("target").join("snapshots-in-use.txt")
}

/// Starts a new list.
pub fn forget(root: &Path) {
    // There is none before the first run.
    let _ = std::fs::remove_file(references(root));
}

/// Fails with the names of snapshots that no test of this run referred to.
pub fn unreferenced(root: &Path) -> Outcome {
    let used: BTreeSet<PathBuf> = std::fs::read_to_string(references(root))
        .unwrap_or_default()
        .lines()
        .filter_map(|l| Path::new(l).canonicalize().ok())
        .collect();
    let snapshots = tidy::tracked(root).into_iter().filter(|p| p.extension().is_some_and(|e| e == "snap"));
    let (mut count, mut dead) = (0, Vec::new());
    for path in snapshots {
        count += 1;
        if !root.join(&path).canonicalize().is_ok_and(|p| used.contains(&p)) {
            dead.push(path.display().to_string());
        }
    }
    match (dead.is_empty(), count) {
        (true, 0) => Outcome::Failed("git lists no snapshot, so nothing was looked at".to_owned()),
        (true, _) => Outcome::Passed,
        (false, _) => Outcome::Failed(format!("no test looks at {}; remove them", dead.join(", "))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_snapshot_at_all_is_a_failure() {
        assert!(matches!(unreferenced(Path::new("no/such/checkout")), Outcome::Failed(_)));
    }
}
