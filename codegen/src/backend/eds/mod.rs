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
//! A DCF is the same sheet with what a user has chosen: see [`Commissioning`] and [`crate::dcf`].

mod assumed;
mod comments;
mod loss;
mod lower;
mod names;
mod value;
mod write;

pub use loss::{LIMITS, PLACE, SHAPE, TEXT, VALUE};

use std::collections::BTreeMap;

use super::Backend;
use crate::diag::{Code, Diagnostic, Sink};
use crate::emit::FileSet;
use crate::model::{Address, Model};
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
        if let Err(error) = out.add(path(model), write::sheet(model, &sheet, &comments, None)) {
            sink.push(
                Diagnostic::new(PLACE, Span::nowhere(), error.to_string())
                    .why("the file is named after the package")
                    .help("correct `id` and `vendor_id` of the drive"),
            );
        }
    }
}

/// What makes a sheet a device configuration file: the choices of a user, which are no facts about the drive.
pub(crate) struct Commissioning<'a> {
    /// Name of the file.
    pub(crate) file: &'a str,
    /// Node-ID.
    pub(crate) node_id: u8,
    /// Name of the node.
    pub(crate) name: &'a str,
    /// Bit rate in kbit/s.
    pub(crate) bit_rate: Option<u16>,
    /// Number of the network.
    pub(crate) network: Option<u32>,
    /// Serial number of the drive.
    pub(crate) serial: Option<u32>,
    /// What the objects hold.
    pub(crate) values: BTreeMap<Address, i128>,
}

/// The text of a device configuration file (CiA 306).
pub(crate) fn configured(model: &Model, commissioning: &Commissioning<'_>) -> String {
    let sheet = lower::lower(model);
    let comments = comments::of_configuration(model, &sheet);
    write::sheet(model, &sheet, &comments, Some(commissioning))
}

/// What the sheet of a drive assumes, in sentences.
pub(super) fn assumptions(model: &Model) -> Vec<String> {
    assumed::sentences(model)
}

fn path(model: &Model) -> String {
    format!("eds/{}.eds", model.drive.package)
}
