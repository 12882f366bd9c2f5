//! Runs the examples of every lint page: the failing one gives exactly this lint's finding, the passing one none at all.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeSet;

use drivewright_codegen::check::{LINTS, Lint};
use drivewright_codegen::diag::{Code, Diagnostic, Severity, code, page};
use drivewright_codegen::source::Source;
use drivewright_codegen::{Compiled, backend, compile, configuration};

/// What a page leaves out: the keys that every drive has.
const DRIVE: &str = r#"
format = 1
id = "x1"
vendor = "Acme"
vendor_id = "acme"
name = "X1"
crate_version = "0.1.0"
eds_version = 1
eds_revision = 0
date = "2026-01-01"
"#;

const MANUALS: &str = r#"manuals = [
  { id = "m1", title = "T", version = "1", sha256 = "0000000000000000000000000000000000000000000000000000000000000000", lines = 10 },
]
"#;

/// The example below a heading.
fn example<'a>(lint: &'a Lint, heading: &str) -> &'a str {
    let (_, below) =
        lint.page.split_once(heading).unwrap_or_else(|| panic!("{}: no {heading}", lint.code.id()));
    let (_, block) = below.split_once("```toml\n").expect("a TOML block");
    block.split_once("```").expect("the block ends").0
}

fn run(example: &str) -> Compiled {
    let drive = if example.contains("[drive]") { DRIVE.to_owned() } else { format!("[drive]\n{DRIVE}") };
    let text = format!("{MANUALS}{example}\n{drive}");
    compile(vec![Source { path: "drive.toml".into(), text }])
}

fn codes(compiled: &Compiled) -> Vec<&'static str> {
    compiled.diagnostics.iter().map(|d| d.code.id()).collect()
}

/// The first row of a new profile is often written before its manual.
#[test]
fn a_citation_without_a_manual_asks_for_the_manual() {
    let row = r#"{ at = "2000:00", name = "Speed", type = "u16", access = "rw", pdo = "no", src = "1 L1" }"#;
    let help = |manuals: &str| {
        let text = format!("{manuals}objects = [ {} ]\n[drive]\n{DRIVE}", row.replace("L1", "L11"));
        let found = compile(vec![Source { path: "drive.toml".into(), text }]).diagnostics;
        found.iter().find(|d| d.code.id() == "E0902").map(|d| d.help.clone()).expect("a finding")
    };
    assert!(help("").contains("no row in `manuals`") && !help(MANUALS).contains("no row"));
}

#[test]
fn failing_examples_fail_with_their_lint_alone() {
    for lint in LINTS {
        let compiled = run(example(lint, "## Fails"));
        let found = codes(&compiled);
        assert!(
            !found.is_empty() && found.iter().all(|c| *c == lint.code.id()),
            "{}: {found:?}",
            lint.code.id()
        );
        assert_eq!(
            compiled.sound().is_some(),
            lint.code.severity() == Severity::Warning,
            "{}",
            lint.code.id()
        );
    }
}

#[test]
fn passing_examples_pass() {
    for lint in LINTS {
        let compiled = run(example(lint, "## Passes"));
        assert_eq!(codes(&compiled), Vec::<&str>::new(), "{}: {:#?}", lint.code.id(), compiled.diagnostics);
        assert!(compiled.sound().is_some());
    }
}

#[test]
fn pages_have_their_parts() {
    for lint in LINTS {
        let id = lint.code.id();
        assert!(lint.page.starts_with(&format!("# {id}: {}\n", lint.code.title())), "{id}: title");
        assert!(lint.page.contains(&format!("Severity: {}.", lint.code.severity().word())), "{id}: severity");
        for part in ["## Why", "## Fails", "## Passes", "## What to do"] {
            assert!(lint.page.contains(part), "{id}: {part}");
        }
    }
}

#[test]
fn every_other_code_has_a_page_too() {
    let others: Vec<Code> = code::ALL
        .iter()
        .chain(backend::ALL.iter().flat_map(|b| b.codes()))
        .chain(configuration::code::ALL)
        .copied()
        .collect();
    let ids: Vec<&str> = others.iter().map(|code| code.id()).collect();
    assert_eq!(
        page::ids().collect::<Vec<_>>(),
        ids,
        "one page a code, in their order, and no page left over"
    );
    for code in others {
        let text = page::text(code).expect("a page");
        assert!(text.starts_with(&format!("# {}: {}\n", code.id(), code.title())), "{text}");
        for part in ["## Why\n\n", "## What to do\n\n"] {
            let (_, below) = text.split_once(part).expect("the part");
            assert!(below.starts_with(|c: char| c.is_ascii_uppercase()) && below.contains('.'), "{text}");
        }
    }
    assert!(LINTS.iter().all(|lint| page::text(lint.code).is_none()), "the page of a lint stands beside it");
}

#[test]
fn codes_ascend() {
    let numbers: Vec<&str> = LINTS.iter().map(|l| &l.code.id()[1..]).collect();
    assert!(numbers.windows(2).all(|w| w[0] < w[1]), "{numbers:?}");
}

/// Whoever reads a finding can allow it: its message has the row between backquotes, and the allowance names that row.
#[test]
fn every_finding_of_a_lint_can_be_allowed() {
    for lint in LINTS {
        let fails = example(lint, "## Fails");
        let allow = |d: &Diagnostic| {
            let row = d.row.as_deref().unwrap_or_else(|| panic!("{}: no row", d.message));
            assert!(d.message.contains(&format!("`{row}`")), "{}: {row}", d.message);
            format!("{{ lint = \"{}\", at = \"{row}\", why = \"as printed\" }},\n", d.code.id())
        };
        let rows: BTreeSet<String> = run(fails).diagnostics.iter().map(allow).collect();
        let allow = format!("allow = [\n{}]\n", rows.into_iter().collect::<Vec<_>>().concat());
        let compiled = run(&format!("{allow}{fails}"));
        assert_eq!(codes(&compiled), Vec::<&str>::new(), "{}: {allow}", lint.code.id());
    }
}

#[test]
fn an_accepted_finding_is_not_reported_and_an_idle_allowance_is() {
    let fails =
        r#"objects = [ { at = "2000:00", name = "1st gain", type = "u16", access = "rw", src = "1 L1" } ]"#;
    let allow = |at: &str| {
        format!("{fails}\nallow = [ {{ lint = \"W0903\", at = \"{at}\", why = \"as printed\" }} ]")
    };
    assert_eq!(codes(&run(&allow("2000:00"))), Vec::<&str>::new());
    let idle = codes(&run(&allow("2001:00")));
    assert!(idle.contains(&"E0210") && idle.contains(&"W0903"), "{idle:?}");
}
