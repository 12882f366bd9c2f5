//! Golden cases: small profiles, one feature each, in `tests/golden`.

#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::missing_panics_doc,
    clippy::disallowed_methods,
    reason = "helpers of tests read files and fail by panicking"
)]

use std::path::{Path, PathBuf};

use drivewright_codegen::model::Model;
use drivewright_codegen::source::Source;
use drivewright_codegen::{Compiled, compile};

/// A golden case: a small profile that shows one feature.
#[derive(Clone, Debug)]
pub struct Case {
    /// Name of its folder.
    pub name: String,
    /// `golden/<case>`.
    pub folder: PathBuf,
    /// Its files, with the drive that cases share where it has none.
    pub sources: Vec<Source>,
}

impl Case {
    /// Compiles it. It must be sound.
    pub fn compile(&self) -> Compiled {
        let compiled = compile(self.sources.clone());
        assert!(compiled.sound().is_some(), "{}: {:#?}", self.name, compiled.diagnostics);
        compiled
    }

    /// Its model.
    pub fn model(&self) -> Model {
        self.compile().sound().cloned().expect("it is sound")
    }
}

/// Every case of `tests/golden`, by name.
pub fn golden_cases() -> Vec<Case> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden");
    let shared = read(&root.join("drive.toml"));
    let cases: Vec<Case> = folders(&root).into_iter().map(|folder| case(folder, &shared)).collect();
    assert!(cases.len() >= 40, "only {} cases found", cases.len());
    cases
}

fn case(folder: PathBuf, shared: &Source) -> Case {
    let mut sources = toml_files(&folder.join("in"));
    if !sources.iter().any(|s| s.path == "drive.toml") {
        sources.push(shared.clone());
    }
    let name = folder.file_name().expect("a name").to_string_lossy().into_owned();
    Case { name, folder, sources }
}

/// The folders in `of`, by name.
pub fn folders(of: &Path) -> Vec<PathBuf> {
    let mut found = entries(of);
    found.retain(|path| path.is_dir());
    found
}

/// The `.toml` files in `of`, by name.
pub fn toml_files(of: &Path) -> Vec<Source> {
    files(of, "toml")
}

/// The files in `of` whose names end that way, by name.
pub fn files(of: &Path, extension: &str) -> Vec<Source> {
    entries(of).iter().filter(|p| p.extension().is_some_and(|e| e == extension)).map(|p| read(p)).collect()
}

/// Every profile below `profiles/`, bases included: its folder below that one, and its files.
pub fn profiles() -> Vec<(String, Vec<Source>)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../profiles");
    let found = folders(&root).into_iter().flat_map(|vendor| folders(&vendor));
    let profile = |folder: PathBuf| {
        let name = folder.strip_prefix(&root).expect("below it").to_string_lossy().replace('\\', "/");
        (name, toml_files(&folder))
    };
    let found: Vec<_> = found.map(profile).filter(|(_, files)| !files.is_empty()).collect();
    assert!(found.len() >= 4, "only {} profiles found", found.len());
    found
}

/// What `of` holds, by name.
pub fn entries(of: &Path) -> Vec<PathBuf> {
    let read = std::fs::read_dir(of).unwrap_or_else(|e| panic!("{}: {e}", of.display()));
    let mut found: Vec<PathBuf> = read.map(|entry| entry.expect("an entry").path()).collect();
    found.sort();
    found
}

fn read(path: &Path) -> Source {
    let text = std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    Source { path: path.file_name().expect("a name").to_string_lossy().into_owned(), text }
}
