//! The slave information interface (ETG.1000.6, ETG.2010) of a drive that is on EtherCAT: the image of its EEPROM, and a
//! listing of the same bytes that people can read.
//!
//! [`header`] has the 64 words that every slave has, [`categories`] what follows them, `image` the bytes with their
//! meaning, from which both files come. The image serves a virtual drive. It ends with the end marker; an EEPROM has ones
//! behind it. A binary file cannot say that it is not the maker's and must not be written to hardware: the [`listing`] does.
//!
//! Addresses, mailbox and synchronization come from [`super::ethercat`], which an ESI shares. All PDOs of a direction are
//! in one category, since some masters read the first category of a kind only.

mod categories;
mod header;
mod image;
mod listing;
mod loss;
mod strings;

pub use loss::{PLACE, SIZE, TEXT, VALUE};

use super::Backend;
use super::ethercat::Device;
use crate::diag::{Code, Diagnostic, Sink};
use crate::emit::FileSet;
use crate::model::Model;
use crate::source::Span;
use image::Image;
use loss::{Loss, Losses};
use strings::Strings;

/// The slave information interface (ETG.2010).
pub struct Sii;

impl Backend for Sii {
    fn id(&self) -> &'static str {
        "sii"
    }

    fn codes(&self) -> &'static [Code] {
        &[VALUE, PLACE, SIZE, TEXT]
    }

    fn emit(&self, model: &Model, out: &mut FileSet, sink: &mut Sink) {
        let Some(device) = Device::of(model) else { return };
        let (image, losses) = image(model, &device);
        losses.report(sink);
        let files = [
            (".bin", image.bytes()),
            ("-listing.txt", listing::text(model, &device, &image, &losses).into_bytes()),
        ];
        for (ending, bytes) in files {
            if let Err(error) = out.add(format!("sii/{}{ending}", model.drive.package), bytes) {
                sink.push(
                    Diagnostic::new(PLACE, Span::nowhere(), error.to_string())
                        .why("the file is named after the package")
                        .help("correct `id` and `vendor_id` of the drive"),
                );
            }
        }
    }
}

/// What the parts of an image share.
struct Parts<'m> {
    model: &'m Model,
    device: &'m Device<'m>,
    strings: Strings,
    losses: Losses,
}

fn image<'m>(model: &'m Model, device: &'m Device<'m>) -> (Image<'m>, Losses) {
    let mut parts = Parts { model, device, strings: Strings::default(), losses: Losses::default() };
    let header = header::write(&mut parts);
    let categories = categories::write(&mut parts);
    let mut image = Image::new(&device.assumed);
    image.append(header);
    image.append(categories::strings(&parts));
    image.append(categories);
    image.word(image::Said::Format, "End of the categories", 0xFFFF);
    if image.len() > usize::try_from(device.eeprom_bytes).unwrap_or(usize::MAX) {
        parts.losses.add_of_drive(Loss::TooLong);
    }
    (image, parts.losses)
}

#[cfg(test)]
mod tests;
