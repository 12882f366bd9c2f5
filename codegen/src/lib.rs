//! Compiles servo-drive profiles.
//!
//! `load → parse → merge → resolve → check → emit → sink`, one way: see `ARCHITECTURE.md`.

pub mod audit;
pub mod backend;
mod build;
pub mod check;
pub mod configuration;
pub mod convert;
pub mod coverage;
pub mod dcf;
pub mod diag;
pub mod diff;
pub mod emit;
pub mod facts;
pub mod limits;
pub mod live;
pub mod load;
pub mod merge;
pub mod model;
pub mod name;
pub mod raw;
pub mod resolve;
pub mod rows;
pub mod schema;
pub mod sink;
pub mod source;
pub mod todo;

use std::path::{Path, PathBuf};

pub use build::{Build, BuildError, build};

use backend::Backend;
use diag::{Diagnostic, Sink};
use emit::FileSet;
use model::Model;
use source::{Source, SourceMap, Span};

/// The result of [`compile`].
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The drive; `None` when the profile has no usable `drive` row. With errors in `diagnostics` it is incomplete and
    /// must not be emitted.
    pub model: Option<Model>,
    /// The rows of the profile, errata applied: what the audit needs to know besides the model.
    pub rows: rows::Rows,
    /// Every finding, in the order of places.
    pub diagnostics: Vec<Diagnostic>,
    /// The texts that the findings point into.
    pub sources: SourceMap,
}

impl Compiled {
    /// The model, if nothing stands against emitting it.
    pub fn sound(&self) -> Option<&Model> {
        let errors = self.diagnostics.iter().any(|d| d.severity() == diag::Severity::Error);
        self.model.as_ref().filter(|_| !errors)
    }
}

/// Compiles the texts of one profile, as [`load::folder`] reads them. Touches no file; all findings come in one run.
pub fn compile(profile: Vec<Source>) -> Compiled {
    let (mut sources, mut sink) = (SourceMap::default(), Sink::default());
    let files = merge::add_sources(profile, &mut sources);
    let profile = merge::merge(&files, &mut sources, &mut sink);
    let model = resolve::resolve(&profile, &mut sink);
    if let Some(model) = &model {
        check::run(model, &profile.rows.allow, &mut sink);
    }
    Compiled { model, rows: profile.rows, diagnostics: sink.into_sorted(&sources), sources }
}

/// Reads and compiles the profile in `folder`. Also gives every file and folder that was looked at: a build must run again
/// when one of them changes.
pub fn compile_folder(folder: &Path) -> (Compiled, Vec<PathBuf>) {
    let loaded = load::folder(folder);
    let mut compiled = if loaded.sources.is_empty() && !loaded.diagnostics.is_empty() {
        // Without any text the missing `drive` is no finding of its own.
        Compiled {
            model: None,
            rows: rows::Rows::default(),
            diagnostics: Vec::new(),
            sources: SourceMap::default(),
        }
    } else {
        compile(loaded.sources)
    };
    compiled.diagnostics.splice(0..0, loaded.diagnostics);
    (compiled, loaded.read)
}

/// The files of `model` in every format of `backends`, and what those formats cannot express. An error among the findings
/// is one of the backends, and the files must not be written.
pub fn emit(model: &Model, backends: &[&dyn Backend]) -> (FileSet, Vec<Diagnostic>) {
    let (mut files, mut sink) = (FileSet::default(), Sink::default());
    for backend in backends {
        backend.emit(model, &mut files, &mut sink);
    }
    for path in files.taken() {
        let text = format!("`{path}` is written by two backends, or twice by one");
        sink.push(
            Diagnostic::new(diag::code::WRITTEN_TWICE, Span::nowhere(), text)
                .why(
                    "this is an error of drivewright, not of the profile: one of the two texts would be lost",
                )
                .help("report it, with the profile"),
        );
    }
    (files, sink.into_sorted(&SourceMap::default()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Writes what another one writes.
    struct Twin;

    impl Backend for Twin {
        fn id(&self) -> &'static str {
            "twin"
        }

        fn emit(&self, _model: &Model, out: &mut FileSet, _sink: &mut Sink) {
            let _ = out.add("a.txt", "");
        }
    }

    #[test]
    fn two_backends_of_one_path_are_an_error() {
        let text = include_str!("../tests/fixtures/drive.toml").to_owned();
        let model = compile(vec![Source { path: "drive.toml".into(), text }]).model.unwrap();
        assert!(emit(&model, &[&Twin]).1.is_empty());
        let (_, findings) = emit(&model, &[&Twin, &Twin]);
        assert_eq!(findings.iter().map(|d| d.code.id()).collect::<Vec<_>>(), ["E0010"]);
    }
}
