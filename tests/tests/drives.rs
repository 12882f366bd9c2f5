//! What users of each drive rely on, one row a line, for those who review a change: `NAME.api` has names, types and ranges
//! of code, `NAME.axis` the values that make an axis move, stop or refuse.
//!
//! `cargo insta review` shows a revision as lines that differ. To accept it without that program:
//! `INSTA_UPDATE=always cargo test -p drivewright-tests --test drives`. `DRIVEWRIGHT_CHECKOUT` names another checkout,
//! whose profiles and snapshots are taken.

#![allow(clippy::expect_used, clippy::disallowed_methods, reason = "a test reads files and its variable")]

use std::path::{Path, PathBuf};

use drivewright_codegen::diff::{Listing, Row};
use drivewright_codegen::{compile, load};

fn root() -> PathBuf {
    let here = || Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    std::env::var_os("DRIVEWRIGHT_CHECKOUT").map_or_else(here, PathBuf::from)
}

/// Fields of which code is made.
const API: &[&str] = &[
    "handle", "type", "access", "pdo", "unit", "min", "max", "allow", "values", "bits", "width", "entry",
    "byte",
];

/// Fields that say nothing about what an axis does.
const ASIDE: &[&str] = &[
    "name",
    "object name",
    "handle",
    "kind",
    "type",
    "access",
    "pdo",
    "parameter",
    "objects",
    "text",
    "note",
    "deviation",
    "also",
];

fn line(row: &Row, wanted: impl Fn(&str) -> bool) -> Option<String> {
    let facts = row.facts.iter().filter(|(field, _)| wanted(field));
    let told: Vec<String> = facts.map(|(field, said)| format!("{field} {}", said.text)).collect();
    (!told.is_empty()).then(|| format!("{}: {}\n", row.key, told.join(", ")))
}

#[test]
fn what_users_rely_on() {
    let root = root();
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root.join("tests/tests/snapshots/drives"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for folder in load::drives(&root.join("profiles")).expect("drives") {
        let model = compile(load::folder(&folder).sources).model.expect("a model");
        let rows = Listing::of(&model).expect("rows").rows;
        let api: String = rows
            .iter()
            .filter(|row| row.fact("handle").is_some() || row.table == "pdos")
            .filter_map(|row| line(row, |field| API.contains(&field)))
            .collect();
        let axis: String = rows
            .iter()
            .filter(|row| row.axis.is_some())
            .filter_map(|row| line(row, |field| !ASIDE.contains(&field)))
            .collect();
        settings.bind(|| {
            insta::assert_snapshot!(format!("{}.api", model.drive.id), api);
            insta::assert_snapshot!(format!("{}.axis", model.drive.id), axis);
        });
    }
}
