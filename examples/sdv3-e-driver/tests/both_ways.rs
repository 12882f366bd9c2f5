//! The generated crate and the one that `build.rs` compiles are the same drive.

use drivewright_runtime::pdo::ProcessData;
use sdv3_e_driver::compiled;

#[test]
fn both_ways_give_the_same_model() {
    assert_eq!(compiled::MODEL, savch_sdv3_e::MODEL);
    assert_eq!(compiled::alarms::ALARM_TEXTS, savch_sdv3_e::alarms::ALARM_TEXTS);
    assert_eq!(
        <compiled::pdo::Rx1 as ProcessData>::MAPPING,
        <savch_sdv3_e::pdo::Rx1 as ProcessData>::MAPPING
    );
}

/// The text too: handles and types are no data that a program could compare.
#[test]
fn both_ways_give_the_same_items() {
    let compiled = lines(include_str!(concat!(env!("OUT_DIR"), "/savch_sdv3_e.rs")));
    let modules = [
        include_str!("../../../generated/savch-sdv3-e/src/od.rs"),
        include_str!("../../../generated/savch-sdv3-e/src/pdo.rs"),
        include_str!("../../../generated/savch-sdv3-e/src/alarms.rs"),
    ];
    for module in modules {
        let module = lines(module);
        assert!(module.len() > 10 && compiled.windows(module.len()).any(|w| w == module));
    }
}

/// Lines of code and documentation, without the head of a file.
fn lines(text: &str) -> Vec<&str> {
    let head = |line: &&str| line.is_empty() || line.starts_with("//!") || line.starts_with("// ");
    text.lines().filter(|line| !head(line)).collect()
}
