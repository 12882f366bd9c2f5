//! The fuzzer finds what is planted, and nothing where nothing is.

use std::time::Duration;

use drivewright_fuzz::behaviour;
use drivewright_fuzz::input::Inputs;
use drivewright_fuzz::run::{Plan, Report, run};
use drivewright_fuzz::targets::{Kind, Reached, Target, targets};

fn fuzz(targets: Vec<Target>, patience: Duration) -> Report {
    let targets = targets.into_iter().map(|t| (t, 1)).collect();
    run(Inputs::new(), Plan { targets, numbers: 0..3_000, threads: 2, patience, notes: None })
}

fn target(name: &str, function: impl Fn(&[u8]) -> Reached + Send + Sync + 'static) -> Target {
    Target { name: name.into(), kind: Kind::Text, function: Box::new(function) }
}

fn holds(bytes: &[u8], text: &str) -> bool {
    String::from_utf8_lossy(bytes).contains(text)
}

/// An hour: nothing here depends on how fast the machine is.
const LONG: Duration = Duration::from_secs(3600);

#[test]
fn a_planted_panic_is_found_and_named() {
    let planted = target("planted", |bytes| {
        assert!(!holds(bytes, "340282366920938463463374607431768211456"), "planted");
        Reached::default()
    });
    let report = fuzz(vec![planted], LONG);
    let first = report.failures.first().expect("it is found");
    assert_eq!((first.target.as_str(), first.why.as_str()), ("planted", "planted"));
    assert!(holds(&Inputs::new().get(first.number), "340282366920938463463374607431768211456"));
}

#[test]
fn an_input_that_does_not_end_is_named() {
    let planted = target("planted", |bytes| {
        while holds(bytes, "340282366920938463463374607431768211456") {
            std::thread::park();
        }
        Reached::default()
    });
    let report = fuzz(vec![planted], Duration::from_secs(1));
    assert!(report.failures[0].why.starts_with("does not end"), "{:?}", report.failures);
}

#[test]
fn nothing_is_found_in_the_compiler_and_much_is_reached() {
    let report = fuzz(targets(), LONG);
    assert_eq!(report.failures, []);
    assert_eq!(report.counts.iter().map(|c| c.inputs).sum::<u64>(), 3_000);
    for count in &report.counts {
        assert!(count.sound > 10 && count.codes.len() > 10, "{count:?}");
    }
}

#[test]
fn nothing_is_found_in_client_and_drive_and_both_operate() {
    let report = fuzz(behaviour::targets(), LONG);
    assert_eq!(report.failures, []);
    for count in &report.counts {
        assert!(count.sound > 100 && count.codes.len() > 1, "{count:?}");
    }
}
