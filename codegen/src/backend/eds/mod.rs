//! The CANopen electronic data sheet (CiA 306 v1.3) in the flavour on which its readers agree.
//!
//! What that flavour is: ASCII, CR/LF, every key of `FileInfo` and `DeviceInfo`, the access words `ro rw wo const`,
//! signed numbers in decimal, and no default where readers disagree about its form. [`lower`] decides what the sheet
//! says, [`write`] prints it, [`comments`] tells the reader what is [`assumed`] or lost. What the format cannot hold is a
//! [`loss`]: a warning and a comment in the file.
//!
//! What the manual states stands: `1600:00` counts what is mapped by default, not the mapping's sub-indexes. Only
//! zencan-eds demands the highest sub-index there, too, and refuses such a file.
//!
//! It writes no DCF: a configuration is a choice of the user, not a fact about the drive.

mod assumed;
mod comments;
mod loss;
mod lower;
mod names;
mod value;
mod write;

pub use loss::{LIMITS, PLACE, SHAPE, TEXT, VALUE};

use super::Backend;
use crate::diag::{Code, Diagnostic, Sink};
use crate::emit::FileSet;
use crate::model::Model;
use crate::source::Span;

/// The CANopen electronic data sheet (CiA 306).
pub struct Eds;

impl Backend for Eds {
    fn id(&self) -> &'static str {
        "eds"
    }

    fn codes(&self) -> &'static [Code] {
        &[VALUE, LIMITS, PLACE, SHAPE, TEXT]
    }

    fn emit(&self, model: &Model, out: &mut FileSet, sink: &mut Sink) {
        let sheet = lower::lower(model);
        let comments = comments::lines(model, &sheet);
        sheet.losses.report(sink);
        if let Err(error) = out.add(path(model), write::sheet(model, &sheet, &comments)) {
            sink.push(
                Diagnostic::new(PLACE, Span::nowhere(), error.to_string())
                    .why("the file is named after the package")
                    .help("correct `id` and `vendor_id` of the drive"),
            );
        }
    }
}

/// What the sheet of a drive assumes, in sentences.
pub(super) fn assumptions(model: &Model) -> Vec<String> {
    assumed::sentences(model, &lower::lower(model))
}

fn path(model: &Model) -> String {
    format!("eds/{}.eds", model.drive.package)
}
