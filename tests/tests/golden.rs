//! Every backend runs every golden case. What it gives lies in `golden/<case>/out`, where people read it.
//!
//! To accept a change: `INSTA_UPDATE=always cargo test -p drivewright-tests --test golden`, then read the diff.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};

use drivewright_codegen::diag::render;
use drivewright_codegen::{backend, emit};
use drivewright_tests::cases::{Case, entries, golden_cases};

/// Runs `check` on every case, and fails with the names of those that failed.
fn each(check: impl Fn(&Case)) {
    let cases = golden_cases();
    let failed: Vec<&str> = cases
        .iter()
        .filter(|case| catch_unwind(AssertUnwindSafe(|| check(case))).is_err())
        .map(|case| case.name.as_str())
        .collect();
    assert!(failed.is_empty(), "failed cases: {failed:?}");
}

/// The name of a snapshot for the output at `path`.
fn flat(path: &str) -> String {
    path.replace('/', "-")
}

#[test]
fn outputs() {
    each(|case| {
        let compiled = case.compile();
        let (files, losses) = emit(compiled.sound().expect("sound"), backend::ALL);
        let findings: Vec<_> = compiled.diagnostics.iter().chain(&losses).cloned().collect();
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path(case.folder.join("out"));
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        settings.bind(|| {
            for (path, bytes) in files.iter() {
                insta::assert_binary_snapshot!(&flat(path.as_str()), bytes.to_vec());
            }
            let text = render::text(&findings, &compiled.sources, render::Style::default());
            insta::assert_snapshot!("findings", text);
        });
    });
}

/// A snapshot that no backend writes any more would be read as if it held.
#[test]
fn no_snapshot_is_left_over() {
    each(|case| {
        let (files, _) = emit(&case.model(), backend::ALL);
        let mut wanted: BTreeSet<String> = BTreeSet::from(["findings.snap".to_owned()]);
        for (path, _) in files.iter() {
            let name = flat(path.as_str());
            let (stem, extension) = name.rsplit_once('.').expect("every output has an extension");
            wanted.extend([format!("{stem}.snap"), format!("{stem}.snap.{extension}")]);
        }
        let found: BTreeSet<String> = entries(&case.folder.join("out"))
            .iter()
            .map(|p| p.file_name().expect("a name").to_string_lossy().into_owned())
            .collect();
        assert_eq!(found, wanted);
    });
}
