//! Wrong use of a handle must not compile, must show under `cargo check`, and must say why in our words.
//!
//! `trybuild` runs `cargo check` over every case and compares what the compiler prints with the `.stderr` beside the
//! case. A case names its error codes and our own messages in `//~` lines; these must stand in the `.stderr`, so that
//! writing it anew with `TRYBUILD=overwrite` for another compiler cannot lose them.

// Helpers of tests: a missing file fails the test.
#![allow(clippy::unwrap_used, clippy::panic, clippy::disallowed_methods)]

use std::path::{Path, PathBuf};

#[test]
fn wrong_use_does_not_compile() {
    let cases = trybuild::TestCases::new();
    cases.pass("compile-fail/pass.rs");
    for case in wrong_uses() {
        // As seen from this crate's folder: `trybuild` prints line numbers only for such a path.
        cases.compile_fail(Path::new("compile-fail").join(case.file_name().unwrap()));
    }
}

#[test]
fn the_reason_is_in_our_words() {
    for case in wrong_uses() {
        let source = text(&case);
        let printed = text(&case.with_extension("stderr"));
        let expected: Vec<&str> = source.lines().filter_map(|l| l.strip_prefix("//~ ")).collect();
        assert!(expected.iter().any(|e| e.starts_with("error[E")), "{} names no error code", case.display());
        for line in expected {
            assert!(printed.contains(line), "{}: the compiler does not say: {line}", case.display());
        }
    }
}

/// Every case but the one that must compile, by name.
fn wrong_uses() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("compile-fail");
    let files = std::fs::read_dir(folder).unwrap().map(|f| f.unwrap().path());
    let mut cases: Vec<PathBuf> = files.filter(|f| f.extension().is_some_and(|e| e == "rs")).collect();
    cases.retain(|f| f.file_stem().is_some_and(|s| s != "pass"));
    cases.sort();
    assert!(cases.len() >= 18, "cases are missing: {cases:?}");
    cases
}

fn text(file: &Path) -> String {
    std::fs::read_to_string(file).unwrap_or_else(|e| panic!("{}: {e}", file.display()))
}
