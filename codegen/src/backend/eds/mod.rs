//! The CANopen electronic data sheet (CiA 306).

use super::Backend;
use crate::diag::Sink;
use crate::emit::FileSet;
use crate::model::Model;

/// The CANopen electronic data sheet (CiA 306).
pub struct Eds;

impl Backend for Eds {
    fn id(&self) -> &'static str {
        "eds"
    }

    fn emit(&self, _model: &Model, _out: &mut FileSet, _sink: &mut Sink) {}
}
