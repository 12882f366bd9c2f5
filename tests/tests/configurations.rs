//! Configurations of drives: those that are right with what is written for them, and every mistake with its finding.
//!
//! `configurations/good/*.toml` give a DCF and a concise DCF in `configurations/out`, which foreign programs read too;
//! `configurations/bad/<code>-<slug>.toml` show a code each. The drive `x1` is the golden case `canopen`.
//!
//! To accept a change: `INSTA_UPDATE=always cargo test -p drivewright-tests --test configurations`, then read the diff.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use drivewright_codegen::configuration::{self, Configuration};
use drivewright_codegen::diag::{Diagnostic, Severity, code, page, render};
use drivewright_codegen::model::{Address, Model};
use drivewright_codegen::source::{Source, SourceMap};
use drivewright_codegen::{Compiled, compile, dcf, load};
use drivewright_tests::cases::{entries, golden_cases, toml_files};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("configurations").join(name)
}

/// The drives that configurations are of, by id.
fn drives() -> BTreeMap<&'static str, Compiled> {
    let canopen = golden_cases().into_iter().find(|case| case.name == "canopen").expect("the case");
    let sdv3_e = Path::new(env!("CARGO_MANIFEST_DIR")).join("../profiles/savch/sdv3-e");
    BTreeMap::from([("x1", canopen.compile()), ("sdv3-e", compile(load::folder(&sdv3_e).sources))])
}

struct Read {
    model: Model,
    configuration: Option<Configuration>,
    findings: Vec<Diagnostic>,
    sources: SourceMap,
}

fn read(drives: &BTreeMap<&str, Compiled>, source: Source) -> Read {
    let id = if source.text.contains("\"sdv3-e\"") { "sdv3-e" } else { "x1" };
    let compiled = drives[id].clone();
    let (model, mut sources) = (compiled.sound().expect("it is sound").clone(), compiled.sources);
    let (configuration, findings) = configuration::read(source, &model, &mut sources);
    Read { model, configuration, findings, sources }
}

fn stem(source: &Source) -> String {
    source.path.strip_suffix(".toml").expect("a TOML file").to_owned()
}

#[test]
fn good_ones_are_written() {
    let drives = drives();
    for source in toml_files(&folder("good")) {
        let name = stem(&source);
        let read = read(&drives, source);
        assert_eq!(read.findings, [], "{name}");
        let configuration = read.configuration.expect("it is right");
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path(folder("out"));
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        let file = format!("{name}.dcf");
        settings.bind(|| {
            let text = dcf::file(&read.model, &configuration, &file);
            insta::assert_binary_snapshot!(&file, text.into_bytes());
            insta::assert_binary_snapshot!(&format!("{name}-concise.bin"), dcf::concise(&configuration));
        });
    }
}

#[test]
fn bad_ones_are_refused() {
    let drives = drives();
    let mut failed = Vec::new();
    for source in toml_files(&folder("bad")) {
        let name = stem(&source);
        let Read { configuration, findings, sources, .. } = read(&drives, source);
        let code = name.split('-').next().expect("a code");
        let codes: BTreeSet<&str> = findings.iter().map(|d| d.code.id()).collect();
        let errors = findings.iter().any(|d| d.severity() == Severity::Error);
        let whole = |d: &Diagnostic| [&d.message, &d.why, &d.help].iter().all(|text| !text.is_empty());
        let text = render::text(&findings, &sources, render::Style::default());
        let shown = std::panic::catch_unwind(|| {
            let mut settings = insta::Settings::clone_current();
            settings.set_prepend_module_to_snapshot(false);
            settings.set_omit_expression(true);
            settings.set_snapshot_path("snapshots/configurations");
            settings.bind(|| insta::assert_snapshot!(name.as_str(), text));
        });
        let right = codes == BTreeSet::from([code]) && errors == configuration.is_none();
        if !right || !findings.iter().all(whole) || shown.is_err() {
            failed.push(format!("{name}: {codes:?}"));
        }
    }
    assert!(failed.is_empty(), "failed cases: {failed:#?}");
}

#[test]
fn every_code_has_a_case_and_a_page() {
    let names: Vec<String> = toml_files(&folder("bad")).iter().map(stem).collect();
    for code in configuration::code::ALL {
        assert!(names.iter().any(|name| name.starts_with(code.id())), "{} has no case", code.id());
        assert!(page::text(*code).is_some(), "{} has no page", code.id());
        assert!(code::ALL.iter().all(|other| other.id()[1..] != code.id()[1..]), "{} is taken", code.id());
    }
}

/// A snapshot that no case writes any more would be read as if it held.
#[test]
fn no_snapshot_is_left_over() {
    let name = |path: &PathBuf| path.file_name().expect("a name").to_string_lossy().into_owned();
    let found = |at: &Path| entries(at).iter().map(name).collect::<BTreeSet<String>>();
    let bad: BTreeSet<String> =
        toml_files(&folder("bad")).iter().map(|source| format!("{}.snap", stem(source))).collect();
    let snapshots = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/snapshots/configurations");
    assert_eq!(found(&snapshots), bad);
    let good = toml_files(&folder("good")).len();
    assert_eq!(found(&folder("out")).len(), 4 * good, "a text and bytes each, two files a snapshot");
}

/// Every mistake of a file is found in one run.
#[test]
fn mistakes_do_not_hide_one_another() {
    let text = r#"
        axis = { format = 1, drive = "x2", node_id = 0, baudrate = 100 }
        values = [ { at = "6041:00", value = 1 }, { at = "6082:00", value = 1 }, { at = "6081:00", value = -1 } ]
        pdo = [ { map = 0x1600, entry = "6041:00" }, { map = 0x1602, entry = "6040:00" }, { map = 0x1605, entry = "6040:00" } ]
        communication = [ { map = 0x1600, cob_id = 0x7FF } ]
    "#;
    let read = read(&drives(), Source { path: "axis.toml".into(), text: text.into() });
    let codes: BTreeSet<&str> = read.findings.iter().map(|d| d.code.id()).collect();
    let wanted = ["E2002", "E2003", "E2004", "E2006", "E2007", "E2008", "E2011", "E2012", "E2013", "E2016"];
    assert_eq!(codes, BTreeSet::from(wanted));
    assert!(read.configuration.is_none());
}

/// What a master writes, by hand from CiA 301: off (bit 31), emptied, mapped, counted, on again; single values last, and
/// 2001:00 after 2002:00, since 200 is above the default 100 that R1 compares it with.
#[test]
fn the_order_is_that_of_the_standard() {
    let good = toml_files(&folder("good"));
    let axis = good.into_iter().find(|source| source.path == "axis.toml").expect("the configuration");
    let writes = read(&drives(), axis).configuration.expect("it is right").writes;
    let shown: Vec<(String, i128)> = writes.iter().map(|w| (w.address.to_string(), w.value)).collect();
    let at = |address: &str, value| (address.to_owned(), value);
    assert_eq!(
        shown[..8],
        [
            at("1400:01", 0x8000_0205),
            at("1400:02", 1),
            at("1600:00", 0),
            at("1600:01", 0x6040_0010),
            at("1600:02", 0x6060_0008),
            at("1600:03", 0x60FF_0020),
            at("1600:00", 3),
            at("1400:01", 0x205),
        ]
    );
    let place = |address| writes.iter().position(|w| w.address == address).expect("a write");
    assert!(place(Address::new(0x2002, 0)) < place(Address::new(0x2001, 0)));
    assert!(place(Address::new(0x1800, 1)) < place(Address::new(0x6081, 0)));
    // 150.0 rpm at 0.1 rpm a count.
    assert!(shown.contains(&at("6081:00", 1_500)));
}

/// What is cut off or changed anywhere gives findings or another configuration, and never a panic.
#[test]
fn nothing_panics_on_broken_texts() {
    let drives = drives();
    let good = toml_files(&folder("good")).into_iter().find(|source| source.path == "axis.toml");
    let text = good.expect("the configuration").text;
    let places = (0..text.len()).step_by(7).filter(|at| text.is_char_boundary(*at));
    for at in places {
        for broken in [
            text[..at].to_owned(),
            format!("{}9{}", &text[..at], &text[at..]),
            format!("{}\"{}", &text[..at], &text[at..]),
        ] {
            let Read { configuration, findings, .. } =
                read(&drives, Source { path: "axis.toml".into(), text: broken.clone() });
            let errors = findings.iter().any(|d| d.severity() == Severity::Error);
            assert_eq!(configuration.is_none(), errors, "{broken}");
        }
    }
}

/// A name of a file is one line, whatever it holds.
#[test]
fn the_name_of_a_file_opens_no_section() {
    let good = toml_files(&folder("good")).remove(0);
    let read = read(&drives(), good);
    let text =
        dcf::file(&read.model, &read.configuration.expect("it is right"), "a\r\n[6040]\r\nx=1\u{202E}");
    assert_eq!(text.lines().nth(1), Some("FileName=a [6040] x=1"));
    assert!(text.is_ascii() && text.lines().all(|line| line.len() <= 255));
}
