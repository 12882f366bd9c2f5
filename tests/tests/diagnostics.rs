//! Every code with a small profile that shows it, and what a person reads then.
//!
//! `diagnostics/<code>-<slug>.toml` and `.xml` are the profiles; lints take the failing example of their page. A file that does not
//! mention `[drive]` is joined with `diagnostics/shared/drive.toml`.
//!
//! To accept a change: `INSTA_UPDATE=always cargo test -p drivewright-tests --test diagnostics`, then read the diff.

#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::disallowed_methods,
    reason = "a test makes folders, and fails by panicking"
)]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use drivewright_codegen::check::{LINTS, Lint};
use drivewright_codegen::convert::convert;
use drivewright_codegen::diag::{Diagnostic, code, github, json, render};
use drivewright_codegen::source::{Format, Source, SourceMap};
use drivewright_codegen::{Compiled, backend, compile, compile_folder, emit, limits, rows};
use drivewright_tests::cases::{entries, files};

const DRIVE: &str = include_str!("../diagnostics/shared/drive.toml");

/// Of drivewright itself, which no profile shows. A unit test of the compiler has backends that do it.
const OF_BUGS: &[&str] = &["E0010"];

struct Case {
    code: String,
    /// Name of the snapshot.
    name: String,
    sources: Vec<Source>,
    /// Whether other codes come with it. Of those a snapshot holds none.
    company: bool,
    /// Whether the findings are those of a conversion to XML.
    converts: bool,
    /// A folder that is no profile, in the place of sources.
    folder: Option<&'static Path>,
}

impl Case {
    fn new(name: &str, text: String) -> Self {
        let shared = Source { path: "drive.toml".into(), text: DRIVE.into() };
        let own = Source { path: "case.toml".into(), text };
        let sources = if own.text.contains("[drive]") { vec![own] } else { vec![own, shared] };
        let code = name.split('-').next().expect("a code").to_owned();
        Self { code, name: name.to_owned(), sources, company: false, converts: false, folder: None }
    }

    /// The findings of the compiler, and of a sound model what formats lose.
    fn findings(&self) -> (Vec<Diagnostic>, SourceMap) {
        if self.converts {
            let mut sources = SourceMap::default();
            let Source { path, text } = &self.sources[0];
            let file = sources.add(path.clone(), text.clone());
            let found = convert(file, &sources, rows::shape, Format::Xml).expect_err("XML cannot hold it");
            return (found, sources);
        }
        let compiled = match self.folder {
            Some(folder) => elsewhere(compile_folder(folder).0, folder),
            None => compile(self.sources.clone()),
        };
        let losses = compiled.sound().map(|model| emit(model, backend::ALL).1).unwrap_or_default();
        let is_its = |d: &Diagnostic| d.code.id() == self.code;
        let rest: Vec<&str> =
            compiled.diagnostics.iter().filter(|d| !is_its(d)).map(|d| d.code.id()).collect();
        assert!(self.company || rest.is_empty(), "{}: also {rest:?}", self.name);
        let all = compiled.diagnostics.into_iter().chain(losses);
        (all.filter(is_its).collect(), compiled.sources)
    }
}

/// The findings as if the folder were `x1`: its path is one of this machine.
fn elsewhere(mut compiled: Compiled, folder: &Path) -> Compiled {
    let path = folder.display().to_string();
    for finding in &mut compiled.diagnostics {
        finding.message = finding.message.replace(&path, "x1");
    }
    compiled
}

/// Folders that cannot be read as a profile. They are made once: tests run side by side.
fn folders() -> Vec<Case> {
    static FOLDERS: OnceLock<Vec<(&str, PathBuf)>> = OnceLock::new();
    let made = FOLDERS.get_or_init(|| {
        let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("diagnostics");
        let _ = fs::remove_dir_all(&root);
        UNREADABLE.iter().map(|(name, fill)| (*name, folder(&root, name, *fill))).collect()
    });
    let case = |(name, folder): &'static (&str, PathBuf)| Case {
        folder: Some(folder.as_path()),
        sources: Vec::new(),
        ..Case::new(name, String::new())
    };
    made.iter().map(case).collect()
}

fn folder(root: &Path, name: &str, fill: Fill) -> PathBuf {
    let folder = root.join(name);
    fs::create_dir_all(&folder).expect("a folder");
    fill(&folder);
    folder
}

/// Puts into a folder what makes it unreadable.
type Fill = fn(&Path);

/// Names of cases, and what makes the folder of each.
const UNREADABLE: &[(&str, Fill)] = &[
    ("E0001-no-file", |_| {}),
    ("E0002-too-large", |folder| {
        let length = u64::try_from(limits::FILE_BYTES).expect("a length") + 1;
        fs::File::create(folder.join("a.toml")).and_then(|file| file.set_len(length)).expect("a file");
    }),
    ("E0003-not-utf8", |folder| fs::write(folder.join("a.toml"), b"a = \"\xFC\"").expect("a file")),
    ("E0004-too-many-files", |folder| {
        (0..=limits::FILES).for_each(|n| fs::write(folder.join(format!("{n}.toml")), "").expect("a file"));
    }),
    #[cfg(unix)]
    ("E0005-link-leads-out", |folder| {
        let outside = folder.with_extension("txt");
        fs::write(&outside, "").expect("a file");
        std::os::unix::fs::symlink(outside, folder.join("a.toml")).expect("a link");
    }),
    #[cfg(unix)]
    ("E0009-pipe", |folder| {
        let made = std::process::Command::new("mkfifo").arg(folder.join("a.toml")).status();
        assert!(made.expect("mkfifo").success());
    }),
];

/// The profiles in `diagnostics`.
fn written() -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("diagnostics");
    let case = |source: Source| {
        let (name, extension) = source.path.rsplit_once('.').expect("a profile");
        let mut case = Case::new(name, source.text);
        case.sources[0].path = format!("case.{extension}");
        case
    };
    let found = files(&folder, "toml").into_iter().chain(files(&folder, "xml"));
    found.map(case).chain(converted()).collect()
}

/// Files that the other format cannot hold.
fn converted() -> Vec<Case> {
    let case = |(name, text): (&str, &str)| Case { converts: true, ..Case::new(name, text.to_owned()) };
    let texts = [
        ("E0128-character", "objects = [\n  { at = \"2000:00\", name = \"Speed\\u0000\" },\n]\n"),
        ("E0128-name", "objects = [\n  { \"a key\" = 1 },\n]\n"),
        ("E0128-date", "[drive]\ndate = 2026-11-24\n"),
        ("E0128-comment", "# \u{FFFF}\nobjects = []\n"),
    ];
    texts.into_iter().map(case).collect()
}

/// The failing example of a lint's page.
fn of_lint(lint: &Lint) -> Case {
    let (_, below) = lint.page.split_once("## Fails").expect("the page has an example");
    let (_, block) = below.split_once("```toml\n").expect("a TOML block");
    let example = block.split_once("```").expect("the block ends").0;
    let Some((tables, drive)) = example.split_once("[drive]") else {
        return Case::new(lint.code.id(), example.to_owned());
    };
    let (manuals, shared) = DRIVE.split_once("[drive]").expect("a drive");
    Case::new(lint.code.id(), format!("{tables}{manuals}[drive]{shared}{drive}"))
}

/// Profiles too large to keep as files.
fn made() -> Vec<Case> {
    let findings = limits::FINDINGS + 1;
    let name = |n: usize| {
        format!(
            "{{ at = \"{n:04X}:00\", name = \"{n} gain\", type = \"u8\", access = \"rw\", src = \"L1\" }},"
        )
    };
    let ranges: String = (0..392).map(|n| name(0x2000 + n).replace(":00", ":00..FF")).collect();
    let object = "objects = [\n{ at = \"2000:00\", name = \"Gain\", type = \"u64\", access = \"rw\", pdo = \"rx\", src = \"L1\" },\n]";
    let pdo = |count: usize| -> String {
        let row = |n: usize| {
            format!(
                "{{ map = 0x1600, dir = \"rx\", pos = {}, entry = \"2000:00\", bits = 64, src = \"L1\" }},\n",
                n % 256
            )
        };
        (1..=count).map(row).collect()
    };
    let pdos: String = (0..=limits::PDOS).map(|n| pdo(1).replace("0x1600", &n.to_string())).collect();
    let keys: Vec<String> = (0..=limits::KEYS).map(|n| format!("k{n} = {n}")).collect();
    let case = |name: &str, table: &str, rows: &str| Case {
        company: true,
        ..Case::new(name, format!("{table} = [\n{rows}\n]\n"))
    };
    vec![
        case("E0007-too-many-errors", "enums", &"{},".repeat(findings)),
        case("W0008-too-many-warnings", "objects", &(0..findings).map(name).collect::<String>()),
        case("E0109-too-many-rows", "objects", &"{},".repeat(limits::ROWS + 1)),
        Case::new(
            "E0119-too-many-tables",
            (0..=limits::TABLES).map(|n| format!("[a{n}]\n")).collect::<Vec<_>>().concat(),
        ),
        case("E0120-too-many-keys", "objects", &format!("{{{}}},", keys.join(", "))),
        case("E0310-too-many-entries", "objects", &ranges),
        case("E0313-too-many-entries", &format!("{object}\npdo"), &pdo(255)),
        case("E0314-too-many-bytes", &format!("{object}\npdo"), &pdo(186)),
        case("E0315-too-many-pdos", &format!("{object}\npdo"), &pdos),
    ]
}

fn cases() -> Vec<Case> {
    let mut cases = written();
    assert!(cases.len() >= 60, "only {} cases found", cases.len());
    cases.extend(LINTS.iter().map(of_lint));
    cases.extend(made());
    cases.extend(folders());
    cases
}

fn settings() -> insta::Settings {
    let mut settings = insta::Settings::clone_current();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_snapshot_path("snapshots/diagnostics");
    settings
}

#[test]
fn texts() {
    let mut failed = Vec::new();
    for case in cases() {
        let shown = std::panic::catch_unwind(|| {
            let (findings, sources) = case.findings();
            assert!(!findings.is_empty(), "{} is not found", case.name);
            let text = render::text(&findings, &sources, render::Style::default());
            settings().bind(|| insta::assert_snapshot!(case.name.as_str(), text));
        });
        if shown.is_err() {
            failed.push(case.name);
        }
    }
    assert!(failed.is_empty(), "failed cases: {failed:#?}");
}

/// The formats for programs: every case, in one file a format.
#[test]
fn other_formats() {
    let (mut lines, mut commands) = (String::new(), String::new());
    for case in cases() {
        let (findings, sources) = case.findings();
        lines += &json::lines(&findings, &sources, "");
        commands += &github::commands(&findings, &sources, "profiles/x1");
    }
    settings().bind(|| {
        insta::assert_snapshot!("json", lines);
        insta::assert_snapshot!("github", commands);
    });
}

/// A finding without a reason or without advice leaves its reader alone.
#[test]
fn every_finding_says_why_and_what_to_do() {
    for case in cases() {
        let (findings, _) = case.findings();
        assert!(!findings.is_empty(), "{} is not found", case.name);
        for d in findings {
            assert!(
                [&d.message, &d.why, &d.help].iter().all(|text| !text.is_empty()),
                "{}: {d:#?}",
                case.name
            );
        }
    }
}

/// A snapshot that no case writes any more would be read as if it held.
#[test]
fn no_snapshot_is_left_over() {
    let names = cases().into_iter().map(|c| c.name).chain(["github".to_owned(), "json".to_owned()]);
    let wanted: BTreeSet<String> = names.map(|name| format!("{name}.snap")).collect();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/snapshots/diagnostics");
    let name = |path: &PathBuf| path.file_name().expect("a name").to_string_lossy().into_owned();
    let found: BTreeSet<String> = entries(&folder).iter().map(name).collect();
    assert_eq!(found, wanted);
}

#[test]
fn every_code_has_a_case() {
    let losses = backend::ALL.iter().flat_map(|b| b.codes());
    let all = code::ALL.iter().chain(LINTS.iter().map(|l| &l.code)).chain(losses);
    let wanted: BTreeSet<&str> = all.map(|c| c.id()).filter(|id| !OF_BUGS.contains(id)).collect();
    let cases = cases();
    let shown: BTreeSet<&str> = cases.iter().map(|c| c.code.as_str()).collect();
    assert_eq!(shown, wanted);
}
