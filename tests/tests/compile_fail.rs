//! Wrong use of a handle must not compile, must show under `cargo check`, and must say why in our words.
//!
//! A case names the errors that it must get in lines `//~ E0277: part of our message`; where the compiler alone speaks, as
//! of types that differ, `//~ E0308`, or with the name of a type behind it. How an error is printed changes with the
//! compiler's version; the code and our words do not. One `cargo check` looks at all cases.

// Helpers of tests: a missing file fails the test.
#![allow(clippy::unwrap_used, clippy::panic, clippy::disallowed_methods)]

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

/// An error, as a case expects it or as the compiler reports it: its code, and what is said.
#[derive(Clone, PartialEq, Eq, Debug)]
struct Error {
    code: String,
    text: String,
}

impl Error {
    fn new(code: &str, text: &str) -> Self {
        Self { code: code.to_owned(), text: text.to_owned() }
    }

    /// Whether `found` is what this case expects.
    fn is(&self, found: &Self) -> bool {
        self.code == found.code && found.text.contains(&self.text)
    }
}

/// Cases by name: their files, and the errors that they must get; none for the one that must compile.
fn cases() -> BTreeMap<String, (PathBuf, Vec<Error>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("compile-fail");
    let files = std::fs::read_dir(folder).unwrap().map(|f| f.unwrap().path());
    let case = |file: PathBuf| {
        let name = file.file_stem().unwrap().to_str().unwrap().to_owned();
        let wanted = expected(&std::fs::read_to_string(&file).unwrap());
        (name, (file, wanted))
    };
    files.map(case).collect()
}

/// The errors that the text of a case names.
fn expected(text: &str) -> Vec<Error> {
    let lines = text.lines().filter_map(|l| l.strip_prefix("//~ "));
    lines.map(|l| l.split_once(": ").unwrap_or((l, ""))).map(|(code, text)| Error::new(code, text)).collect()
}

/// What is wrong with a case; nothing if it gets every error that it names, and no other. The compiler may report one
/// more than once.
fn wrong(wanted: &[Error], found: &[Error]) -> Vec<String> {
    if found.len() < wanted.len() {
        return vec![format!("{} errors, not {}: {found:#?}", found.len(), wanted.len())];
    }
    let missing = wanted.iter().filter(|w| !found.iter().any(|f| w.is(f)));
    let others = found.iter().filter(|f| !wanted.iter().any(|w| w.is(f)));
    let missing = missing.map(|w| format!("the compiler does not say {}: {}", w.code, w.text));
    missing.chain(others.map(|f| format!("the compiler says {}: {}", f.code, f.text))).collect()
}

/// A crate with a program for each case.
fn krate(cases: &BTreeMap<String, (PathBuf, Vec<Error>)>) -> PathBuf {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("compile-fail");
    let runtime = Path::new(env!("CARGO_MANIFEST_DIR")).join("../runtime").display().to_string();
    let mut manifest = format!(
        "[package]\nname = \"compile-fail\"\nversion = \"0.0.0\"\nedition = \"2021\"\n\n[workspace]\n\n\
         [dependencies]\ndrivewright-runtime = {{ path = {runtime:?} }}\n"
    );
    for (name, (file, _)) in cases {
        let path = file.display().to_string();
        let _ = write!(manifest, "\n[[bin]]\nname = \"{name}\"\npath = {path:?}\n");
    }
    std::fs::create_dir_all(&root).unwrap();
    std::fs::write(root.join("Cargo.toml"), manifest).unwrap();
    root
}

fn cargo(root: &Path, arguments: &[&str]) -> Output {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(arguments).args(["--offline", "--quiet", "--target-dir"]).arg(root.join("target"));
    // Flags of the surrounding build would build everything anew.
    cargo.current_dir(root).env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    cargo.output().unwrap()
}

/// The errors of each program.
fn check(root: &Path) -> BTreeMap<String, Vec<Error>> {
    let output = cargo(root, &["check", "--bins", "--keep-going", "--message-format=json"]);
    let mut errors: BTreeMap<String, Vec<Error>> = BTreeMap::new();
    let lines: Vec<Value> =
        output.stdout.split(|b| *b == b'\n').filter_map(|l| serde_json::from_slice(l).ok()).collect();
    for line in &lines {
        if let (Some(target), Some(error)) = (line["target"]["name"].as_str(), error(&line["message"])) {
            errors.entry(target.to_owned()).or_default().push(error);
        }
    }
    let finished = lines.iter().any(|l| l["reason"] == "build-finished");
    assert!(finished, "{}", String::from_utf8_lossy(&output.stderr));
    errors
}

/// A message of the compiler, if it is an error; that it gives up because of errors is none.
fn error(message: &Value) -> Option<Error> {
    let counts = message["code"].is_null() && message["spans"].as_array().is_none_or(Vec::is_empty);
    let is_error = message["level"].as_str()?.starts_with("error") && !counts;
    is_error.then(|| Error::new(message["code"]["code"].as_str().unwrap_or("no code"), &words(message)))
}

/// All that a message says: versions of the compiler differ in where they put it.
fn words(message: &Value) -> String {
    let list = |key: &str| message[key].as_array().cloned().unwrap_or_default();
    let label = |span: &Value| span["label"].as_str().map(str::to_owned);
    let own = message["message"].as_str().map(str::to_owned);
    let labels: Vec<String> = list("spans").iter().filter_map(label).collect();
    let children: Vec<String> = list("children").iter().map(words).collect();
    own.into_iter().chain(labels).chain(children).collect::<Vec<_>>().join("\n")
}

#[test]
fn wrong_use_does_not_compile() {
    let cases = cases();
    assert!(cases.len() >= 20, "cases are missing: {:?}", cases.keys());
    let root = krate(&cases);
    let found = check(&root);
    let mut report = Vec::new();
    for (name, (_, wanted)) in &cases {
        assert_eq!(wanted.is_empty(), name == "pass", "{name} names no error");
        assert!(
            wanted.iter().all(|w| w.code == "E0308" || !w.text.is_empty()),
            "{name}: our words are missing"
        );
        let found = found.get(name).map_or(&[][..], Vec::as_slice);
        report.extend(wrong(wanted, found).into_iter().map(|what| format!("{name}: {what}")));
        // The other way round: without its mistake a case would be seen to compile.
        assert!(wanted.is_empty() || !wrong(wanted, &[]).is_empty(), "{name}");
    }
    assert!(report.is_empty(), "{}", report.join("\n"));
    let pass = cargo(&root, &["run", "--bin", "pass"]);
    assert!(pass.status.success(), "{}", String::from_utf8_lossy(&pass.stderr));
}

#[test]
fn a_case_that_gets_another_error_is_seen() {
    let wanted = expected("//! Text.\n//~ E0277: object is read-only\nuse x;\n");
    let right = Error::new("E0277", "object is read-only: the drive refuses");
    assert_eq!(wrong(&wanted, &[right.clone(), right.clone()]), Vec::<String>::new());
    let twice = expected("//~ E0308\n//~ E0308: Mode\n");
    assert!(!wrong(&twice, &[Error::new("E0308", "found Mode")]).is_empty());
    for found in [
        vec![],
        vec![Error::new("E0277", "object is write-only")],
        vec![Error::new("E0308", &right.text)],
        vec![right, Error::new("E0425", "cannot find value `x`")],
    ] {
        assert!(!wrong(&wanted, &found).is_empty(), "{found:?}");
    }
    assert!(!wrong(&[], &[Error::new("no code", "expected `;`")]).is_empty());
}
