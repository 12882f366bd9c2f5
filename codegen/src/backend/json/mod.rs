//! `model.json`: the whole model for other programs.

use super::Backend;
use crate::diag::Sink;
use crate::emit::FileSet;
use crate::model::Model;

/// `model.json`: the whole model for other programs.
pub struct Json;

impl Backend for Json {
    fn id(&self) -> &'static str {
        "json"
    }

    fn emit(&self, _model: &Model, _out: &mut FileSet, _sink: &mut Sink) {}
}
