//! The typed `no_std` crate.

use super::Backend;
use crate::diag::Sink;
use crate::emit::FileSet;
use crate::model::Model;

/// The typed `no_std` crate.
pub struct Rust;

impl Backend for Rust {
    fn id(&self) -> &'static str {
        "rust"
    }

    fn emit(&self, _model: &Model, _out: &mut FileSet, _sink: &mut Sink) {}
}
