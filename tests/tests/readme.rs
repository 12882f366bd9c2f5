//! The figures of the README and the tables of the profile language are those of the program.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "a test reads files")]

use std::fs;
use std::path::PathBuf;

use drivewright_codegen::check::LINTS;
use drivewright_codegen::coverage::{Count, coverage};
use drivewright_codegen::facts::{Table, Totals, facts};
use drivewright_codegen::rows::Rows;
use drivewright_codegen::{Compiled, compile, load};
use drivewright_tests::drives;

fn text(name: &str) -> String {
    let file: PathBuf = [env!("CARGO_MANIFEST_DIR"), "..", name].iter().collect();
    fs::read_to_string(file).expect("a file of the repository")
}

/// The line of the README's table that has the figures of a drive.
fn figures(drive: &Compiled) -> String {
    let model = drive.model.as_ref().expect("a model");
    let all = facts(model);
    let counts = coverage(&all);
    let of = |table: Table| counts.iter().find(|c| c.table == table).expect("a table of this drive");
    let objects: &Count = of(Table::Objects);
    let mut cells = vec![model.drive.id.clone(), objects.rows.to_string()];
    cells.extend(objects.with.iter().map(usize::to_string));
    cells.push(objects.cited.to_string());
    cells.extend([Table::Alarms, Table::Homing, Table::Errata].map(|table| of(table).rows.to_string()));
    let proved = drive.rows.audited.first().expect("an audit").proved.value;
    cells.push(format!("{proved} of {}", Totals::of(&all).facts()));
    format!("| {} |", cells.join(" | "))
}

#[test]
fn the_figures_of_the_drives_are_right() {
    let readme = text("README.md");
    for folder in drives::all() {
        let line = figures(&compile(load::folder(&folder).sources));
        assert!(readme.lines().any(|l| l == line), "README.md should have the line\n{line}");
    }
}

#[test]
fn the_number_of_lints_is_right() {
    let wanted = format!("[{} lints]", LINTS.len());
    assert!(text("README.md").contains(&wanted), "README.md should say {wanted}");
}

#[test]
fn every_table_of_the_language_is_described() {
    let page = text("profiles/README.md");
    let named: Vec<&str> = Rows::TABLES
        .iter()
        .map(|table| table.name)
        .filter(|name| !page.lines().any(|l| l.starts_with("| `") && l.contains(&format!("`{name}`"))))
        .collect();
    assert_eq!(named, Vec::<&str>::new(), "profiles/README.md has no line for these tables");
}
