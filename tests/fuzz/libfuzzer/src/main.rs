//! One target under libFuzzer: `DRIVEWRIGHT_TARGET` names it, or every input goes to all of them.
#![no_main]

use std::sync::LazyLock;

use drivewright_fuzz::targets::{Target, all};
use libfuzzer_sys::fuzz_target;

static TARGETS: LazyLock<Vec<Target>> = LazyLock::new(|| {
    let name = std::env::var("DRIVEWRIGHT_TARGET").ok();
    let asked: Vec<Target> =
        all().into_iter().filter(|t| name.as_ref().is_none_or(|n| *n == t.name)).collect();
    let known: Vec<String> = all().into_iter().map(|t| t.name).collect();
    assert!(!asked.is_empty(), "there is no target {name:?}; known: {known:?}");
    asked
});

fuzz_target!(|bytes: &[u8]| {
    for target in TARGETS.iter() {
        (target.function)(bytes);
    }
});
