//! Output formats. A new one is a folder here and a line in [`ALL`].

pub mod eds;
pub mod json;
pub mod map;
pub mod rust;

use crate::diag::Sink;
use crate::emit::FileSet;
use crate::model::Model;

/// An output format. It sees the model and nothing before it, writes paths below the drive's folder, and reports what
/// the format cannot express as a warning: nothing is dropped in silence.
pub trait Backend: Sync {
    /// Short name, as options and reports use it.
    fn id(&self) -> &'static str;
    /// Adds the files of `model` to `out`. A model without errors can always be emitted.
    fn emit(&self, model: &Model, out: &mut FileSet, sink: &mut Sink);
}

/// Every backend, in the order of output.
pub const ALL: &[&dyn Backend] = &[&rust::Rust, &eds::Eds, &json::Json, &map::Map];
