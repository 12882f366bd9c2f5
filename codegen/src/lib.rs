//! Compiles servo-drive profiles.
//!
//! `load → parse → merge → resolve → check → emit → sink`, one way: see `ARCHITECTURE.md`.

pub mod audit;
pub mod backend;
mod build;
pub mod check;
pub mod coverage;
pub mod diag;
pub mod emit;
pub mod facts;
pub mod limits;
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

pub use build::{Build, BuildError, build};

use backend::Backend;
use diag::{Diagnostic, Sink};
use emit::FileSet;
use model::Model;
use source::{Source, SourceMap};

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

/// The files of `model` in every format of `backends`, and what those formats cannot express.
pub fn emit(model: &Model, backends: &[&dyn Backend]) -> (FileSet, Vec<Diagnostic>) {
    let (mut files, mut sink) = (FileSet::default(), Sink::default());
    for backend in backends {
        backend.emit(model, &mut files, &mut sink);
    }
    (files, sink.into_sorted(&SourceMap::default()))
}
