//! `map.txt`: one sorted line for each fact.

use super::Backend;
use crate::diag::Sink;
use crate::emit::FileSet;
use crate::model::Model;

/// `map.txt`: one sorted line for each fact.
pub struct Map;

impl Backend for Map {
    fn id(&self) -> &'static str {
        "map"
    }

    fn emit(&self, _model: &Model, _out: &mut FileSet, _sink: &mut Sink) {}
}
