//! The EtherCAT slave information (ETG.2000) of a drive that is on EtherCAT.
//!
//! [`lower`] decides what the dictionary says, with its [`types`], [`value`]s and [`units`]; [`dictionary`], [`device`] and
//! [`alarms`] write it as [`xml`]. Addresses, mailbox and synchronization come from [`super::ethercat`], which an SII image
//! shares. The file is valid for the schemas 1.14 and 1.17, in UTF-8. What is assumed stands in a [comment](comments), and
//! what the format cannot hold is a [`loss`].
//!
//! Two readers cannot be served at once where a drive can choose between PDOs: one that is not active by default has no
//! attribute `Sm`, which masters need to get the length of process data right; the crate ethercat-esi demands it.

mod alarms;
mod comments;
mod device;
mod dictionary;
mod loss;
mod lower;
mod types;
mod units;
mod value;
mod xml;

pub use loss::{LENGTH, MEMORY, PLACE, UNIT, VALUE};

use super::Backend;
use super::ethercat::Device;
use crate::diag::{Code, Diagnostic, Sink};
use crate::emit::FileSet;
use crate::model::Model;
use crate::source::Span;
use lower::Dictionary;
use xml::{Xml, hex};

/// The EtherCAT slave information (ETG.2000).
pub struct Esi;

impl Backend for Esi {
    fn id(&self) -> &'static str {
        "esi"
    }

    fn codes(&self) -> &'static [Code] {
        &[VALUE, PLACE, LENGTH, UNIT, MEMORY]
    }

    fn emit(&self, model: &Model, out: &mut FileSet, sink: &mut Sink) {
        let Some(device) = Device::of(model) else { return };
        let (bytes, dictionary) = document(model, &device);
        dictionary.losses.report(sink);
        if let Err(error) = out.add(format!("esi/{}.xml", model.drive.package), bytes) {
            sink.push(
                Diagnostic::new(PLACE, Span::nowhere(), error.to_string())
                    .why("the file is named after the package")
                    .help("correct `id` and `vendor_id` of the drive"),
            );
        }
    }
}

/// What the file assumes, in sentences; nothing for a drive that has no ESI.
pub(super) fn assumptions(model: &Model) -> Vec<String> {
    Device::of(model).map(|device| comments::assumptions(model, &device)).unwrap_or_default()
}

fn document(model: &Model, device: &Device<'_>) -> (Vec<u8>, Dictionary) {
    let mut dictionary = lower::lower(model);
    device::lose(model, device, &mut dictionary.losses);
    let mut xml = Xml::new();
    xml.comment(&comments::lines(model, device, &dictionary));
    let root = [
        ("xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"),
        ("xsi:noNamespaceSchemaLocation", "EtherCATInfo.xsd"),
        ("Version", "1.2"),
    ];
    xml.element("EtherCATInfo", &root, |xml| {
        xml.element("Vendor", &[("FileVersion", &model.drive.eds_version.to_string())], |xml| {
            xml.text("Id", hex(device.identity[0], 8));
            xml.text("Name", &model.drive.vendor);
            xml.text("Comment", comments::NOT_THE_MAKERS);
        });
        xml.group("Descriptions", |xml| {
            xml.group("Groups", |xml| {
                xml.group("Group", |xml| {
                    xml.text("Type", device.group);
                    xml.english("Name", device.group);
                });
            });
            xml.group("Devices", |xml| device::write(model, device, &dictionary, xml));
        });
    });
    (xml.finish(), dictionary)
}
