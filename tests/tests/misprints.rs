//! What other manuals print wrongly is found: golden cases that correct it by errata, without those errata.

#![allow(clippy::expect_used, reason = "a test fails by panicking")]

use drivewright_codegen::compile;
use drivewright_tests::cases::golden_cases;

/// The findings in the order of the rows: code and row.
fn found_without_errata(name: &str) -> Vec<String> {
    let case = golden_cases().into_iter().find(|case| case.name == name).expect("the case is there");
    let mut sources = case.sources;
    let with: usize = sources.iter().map(|s| s.text.len()).sum();
    for source in &mut sources {
        let end = source.text.find("\nerrata = [").unwrap_or(source.text.len());
        source.text.truncate(end);
    }
    assert!(sources.iter().map(|s| s.text.len()).sum::<usize>() < with, "{name} has no errata");
    let row = |message: &str| message.split('`').nth(1).unwrap_or("").to_owned();
    let findings = compile(sources).diagnostics;
    findings.iter().map(|d| format!("{} {}", d.code.id(), row(&d.message))).collect()
}

/// ELD2-CAN, 6.8.5: the far edge of the switch in one case, and a limit that the move does not reach in another.
#[test]
fn other_edge_and_other_limit() {
    assert_eq!(found_without_errata("homing-eld2-can"), ["E1103 homing 7.3", "E1104 homing 12.3"]);
}

/// SV3H-E, 3.4.3: the last step of method 30 is printed twice in all three cases.
#[test]
fn step_printed_twice() {
    let expected = ["E1102 homing 30.1", "E1102 homing 30.2", "E1102 homing 30.3"];
    assert_eq!(found_without_errata("homing-sv3h-e"), expected);
}
