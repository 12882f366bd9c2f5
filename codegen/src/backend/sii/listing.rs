//! The listing of an image: where each byte lies, what it means, and who says it.

use std::fmt::Write;

use super::image::{Field, Image};
use super::loss::Losses;
use crate::backend::ethercat::Device;
use crate::emit::escape::plain_line;
use crate::model::Model;

const PREAMBLE: &str = "\
# It serves a virtual drive. It is not the maker's, and must never be written to the EEPROM of a real drive: a slave
# controller with another configuration than its own no longer starts.
# Written by drivewright with `cargo xtask regen`. Edit the profile, not this file.
#
# Each line: offset in bytes, the bytes, who says it, what it means. Numbers are little-endian.
# profile: a fact of the profile. assumed: see below. format: ETG.2010 demands it, whatever the drive is.
# below: who says a text is said where its number stands.
# An EEPROM holds FFh behind the end of the categories.
";
const LOST: &str = "An SII has no dictionary: names, limits, units, defaults and alarms are in the ESI and in model.json. \
    It also does not say which PDOs exclude each other, and whether SDO transfers can be segmented.";

/// The text of the file. Lines are not wrapped: a changed text is a changed line.
pub(super) fn text(model: &Model, device: &Device<'_>, image: &Image<'_>, losses: &Losses) -> String {
    let drive = &model.drive;
    let name = plain_line(&format!("{} {}", drive.vendor, drive.name));
    let mut out = format!("# SII image of {name}: sii/{}.bin, generated from the manual.\n", drive.package);
    out.push_str(PREAMBLE);
    let assumed = device.assumed.sentences();
    let lost = [LOST.to_owned()].into_iter().chain(losses.sentences());
    paragraph("What ETG.2010 or the virtual drive needs and the manual does not state:", assumed, &mut out);
    paragraph("What the image does not hold:", lost, &mut out);
    out.push('\n');
    let mut at = 0;
    for field in image.fields() {
        line(at, field, &mut out);
        at += field.bytes.len();
    }
    out
}

fn paragraph(title: &str, sentences: impl IntoIterator<Item = String>, out: &mut String) {
    out.extend(["#\n# ", title, "\n"]);
    for sentence in sentences {
        out.extend(["# - ", &plain_line(&sentence), "\n"]);
    }
}

/// Eight bytes are shown; what is longer is text, which stands behind them, or reserved.
fn line(at: usize, field: &Field, out: &mut String) {
    const SHOWN: usize = 8;
    let hex: Vec<String> = field.bytes.iter().take(SHOWN).map(|byte| format!("{byte:02X}")).collect();
    let more = if field.bytes.len() > SHOWN { ".." } else { "" };
    // Writing to a String cannot fail.
    let _ = writeln!(
        out,
        "{at:04X}  {:<25}  {:<7}  {}",
        hex.join(" ") + more,
        field.source,
        plain_line(&field.what)
    );
}
