//! `model.json`: the whole model for other programs.
//!
//! [`shape`] is the file as types, [`lower`] fills them from the model, [`write`] writes them in lines, and
//! [`schema`] describes it from the same types. The file is a format of its own: the model may change behind it.

mod behaviour;
mod ethercat;
mod known;
mod lower;
mod schema;
mod shape;
mod value;
mod write;

pub use schema::model_schema;

use super::Backend;
use crate::diag::Sink;
use crate::emit::FileSet;
use crate::model::Model;

/// `model.json`: the whole model for other programs.
pub struct Json;

/// Version of the format.
pub const FORMAT: u8 = 1;

/// The document as a value, for programs that compare models.
pub fn value(model: &Model) -> serde_json::Value {
    // What is written can be read.
    serde_json::from_str(&text(model)).unwrap_or_default()
}

impl Backend for Json {
    fn id(&self) -> &'static str {
        "json"
    }

    fn emit(&self, model: &Model, out: &mut FileSet, _sink: &mut Sink) {
        // The path is a literal that every RelPath rule allows.
        let _ = out.add("model.json", text(model));
    }
}

fn text(model: &Model) -> String {
    write::text(&lower::document(model))
}
