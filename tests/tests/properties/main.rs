//! What holds for every profile, tried on the profiles of this repository and on many made by chance.
//!
//! Chance is the same in every run. `PROPTEST_CASES=5000 PROPTEST_RNG_SEED=7 cargo test -p drivewright-tests --test
//! properties` tries more and others.

#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::disallowed_methods,
    reason = "tests read files and fail by panicking"
)]

mod convert;
mod eds;
mod hostile;
mod judge;
mod order;
/// Reads an EDS and shares no code with its writer.
#[path = "../../../codegen/tests/eds/reader.rs"]
mod reader;
mod values;

use drivewright_codegen::diag::Diagnostic;
use drivewright_codegen::emit::FileSet;
use drivewright_codegen::source::Source;
use drivewright_codegen::{backend, compile, emit};
use proptest::test_runner::{Config, RngSeed};

/// A drive without rows.
const DRIVE: &str = include_str!("../../../codegen/tests/fixtures/drive.toml");

/// `n` cases, the same in every run, unless the environment asks for others.
fn cases(n: u32) -> Config {
    let asked = Config::default();
    let cases = if std::env::var_os("PROPTEST_CASES").is_some() { asked.cases } else { n };
    let rng_seed = if asked.rng_seed == RngSeed::Random { RngSeed::Fixed(402) } else { asked.rng_seed };
    Config { cases, rng_seed, failure_persistence: None, ..asked }
}

/// What comes of a profile: the files of every backend, none where it is not sound, and what is found.
#[derive(Clone, Debug)]
struct Outcome {
    files: FileSet,
    findings: Vec<String>,
}

fn run(sources: Vec<Source>) -> Outcome {
    let compiled = compile(sources);
    let (files, losses) = compiled.sound().map(|m| emit(m, backend::ALL)).unwrap_or_default();
    let mut findings: Vec<String> = compiled.diagnostics.iter().chain(&losses).map(without_place).collect();
    findings.sort();
    Outcome { files, findings }
}

/// All of a finding but where it stands.
fn without_place(d: &Diagnostic) -> String {
    let mut related: Vec<&str> = d.related.iter().map(|r| r.text.as_str()).collect();
    related.sort_unstable();
    [d.code.id(), &d.message, &d.label, &related.join("; "), &d.why, &d.help].join(" | ")
}

/// Where two results differ first.
fn difference(a: &Outcome, b: &Outcome) -> Option<String> {
    if a.findings != b.findings {
        return Some(format!("findings: {:#?}\nnot {:#?}", a.findings, b.findings));
    }
    let paths = |r: &Outcome| r.files.iter().map(|(path, _)| path.to_string()).collect::<Vec<_>>();
    if paths(a) != paths(b) {
        return Some(format!("files: {:?}, not {:?}", paths(a), paths(b)));
    }
    a.files.iter().zip(b.files.iter()).find(|(a, b)| a.1 != b.1).map(|(a, b)| {
        let (left, right) = (String::from_utf8_lossy(a.1), String::from_utf8_lossy(b.1));
        let line = left.lines().zip(right.lines()).find(|(l, r)| l != r);
        format!("{}: {line:?}", a.0)
    })
}

fn source(path: &str, text: impl Into<String>) -> Source {
    Source { path: path.into(), text: text.into() }
}

#[test]
fn one_changed_byte_is_a_difference() {
    let (one, mut other) = (run(hostile::calm()), run(hostile::calm()));
    assert!(!one.files.is_empty(), "{:#?}", one.findings);
    assert_eq!(difference(&one, &other), None);
    for (changed, _) in one.files.iter() {
        other.files = FileSet::default();
        for (path, bytes) in one.files.iter() {
            let mut bytes = bytes.to_vec();
            if path == changed {
                *bytes.last_mut().expect("a byte") ^= 1;
            }
            other.files.add(path.as_str(), bytes).expect("a path");
        }
        assert!(difference(&one, &other).is_some(), "{changed}");
    }
    other.files = one.files.clone();
    other.findings.push("W0001".into());
    assert!(difference(&one, &other).is_some());
}
