//! Which drive this is: 1018h, device type, names and versions, against the profile.
//!
//! A drive is told by vendor, product and revision, never by a name. The upper half of a revision number tells what the
//! drive does, the lower half versions that do the same (CiA 301, 1018:03); so a drive whose revision differs in the lower
//! half only is compatible.

use core::fmt;

use crate::address::Address;
use crate::client::message::{Clean, Explain, Lines, Severity};
use crate::client::object::{received, AccessError, Action, Cause};
use crate::model::{DefaultValue, DriveModel};
use crate::procedure::{Answer, Ask, Procedure};
use crate::time::Instant;
use crate::wire::Wire;

/// The most bytes of a text that are kept.
pub const TEXT_BYTES: usize = 32;

/// A text of the drive: as much of it as there is room for.
#[derive(Clone, Copy, PartialEq, Eq, Default)]
pub struct Label {
    bytes: [u8; TEXT_BYTES],
    used: usize,
}

impl Label {
    fn new(text: &[u8]) -> Self {
        let mut label = Self::default();
        for (place, byte) in label.bytes.iter_mut().zip(text) {
            *place = *byte;
        }
        label.used = text.len().min(TEXT_BYTES);
        label
    }

    /// The bytes, padding included.
    pub fn bytes(&self) -> &[u8] {
        self.bytes.get(..self.used).unwrap_or(&[])
    }
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Clean(self.bytes()).fmt(f)
    }
}

impl fmt::Debug for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Clean(self.bytes()).fmt(f)
    }
}

/// A number that was read, or why not; `None` where it was not read because the profile has no such entry.
pub type Reading = Option<Result<u32, AccessError>>;

/// What a drive says about itself.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[non_exhaustive]
pub struct Identification {
    /// Vendor id, 1018:01.
    pub vendor_id: Reading,
    /// Product code, 1018:02.
    pub product_code: Reading,
    /// Revision number, 1018:03.
    pub revision: Reading,
    /// Serial number, 1018:04.
    pub serial: Reading,
    /// Device type, 1000h: number of the device profile in the lower half.
    pub device_type: Reading,
    /// Device name, 1008h; empty where it was not read.
    pub name: Label,
    /// Hardware version, 1009h.
    pub hardware: Label,
    /// Software version, 100Ah.
    pub software: Label,
}

const ENTRIES: [Address; 8] = [
    Address::new(0x1018, 1),
    Address::new(0x1018, 2),
    Address::new(0x1018, 3),
    Address::new(0x1018, 4),
    Address::new(0x1000, 0),
    Address::new(0x1008, 0),
    Address::new(0x1009, 0),
    Address::new(0x100A, 0),
];

/// Reads what a drive says about itself, as far as its profile has the entries. What cannot be read is part of the result.
#[derive(Clone, Copy, Debug)]
pub struct Identify<'m> {
    model: &'m DriveModel<'m>,
    step: usize,
    found: Identification,
}

impl<'m> Identify<'m> {
    /// The identification of a drive that should be the one of `model`.
    pub fn new(model: &'m DriveModel<'m>) -> Self {
        Self { model, step: 0, found: Identification::default() }
    }

    /// Keeps the answer to the read of `address`.
    fn keep(&mut self, address: Address, answer: Answer<'_>) {
        let found = &mut self.found;
        let number = match (address.index(), address.sub()) {
            (0x1018, 1) => &mut found.vendor_id,
            (0x1018, 2) => &mut found.product_code,
            (0x1018, 3) => &mut found.revision,
            (0x1018, _) => &mut found.serial,
            (0x1000, _) => &mut found.device_type,
            (index, _) => return found.keep_text(index, answer),
        };
        let wire = |error| AccessError { address, action: Action::Read, cause: Cause::Wire(error) };
        *number = Some(received(address, answer).and_then(|bytes| u32::decode(bytes).map_err(wire)));
    }
}

impl Identification {
    fn keep_text(&mut self, index: u16, answer: Answer<'_>) {
        let label = match index {
            0x1008 => &mut self.name,
            0x1009 => &mut self.hardware,
            _ => &mut self.software,
        };
        if let Answer::Data(text) = answer {
            *label = Label::new(text);
        }
    }
}

impl Procedure for Identify<'_> {
    type Output = Identification;

    fn next(&mut self, _: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        if let (Some(asked), false) = (self.step.checked_sub(1), answer == Answer::Begin) {
            if let Some(address) = ENTRIES.get(asked) {
                self.keep(*address, answer);
            }
        }
        while let Some(address) = ENTRIES.get(self.step) {
            self.step = self.step.saturating_add(1);
            if self.model.object(*address).is_some_and(|object| object.access().reads()) {
                return Ask::Upload(*address);
            }
        }
        Ask::Done(self.found)
    }
}

/// One thing in which drive and profile differ.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct Difference {
    /// What: `vendor`, `product`, `rev` or `type`.
    pub what: &'static str,
    /// What the profile says; `None` where its manual does not print it.
    pub expected: Option<u32>,
    /// What the drive says.
    pub found: Reading,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.found {
            Some(Ok(found)) => write!(f, "device {found:08X}h")?,
            Some(Err(error)) => write!(f, "device {}", Failed(error.cause))?,
            None => f.write_str("not read")?,
        }
        match self.expected {
            Some(expected) => write!(f, ", profile {expected:08X}h"),
            None => f.write_str(", profile does not state it"),
        }
    }
}

/// Why a number could not be read, in few words.
struct Failed(Cause);

impl fmt::Display for Failed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Cause::Abort(code) => write!(f, "refuses [{code}]"),
            Cause::Wire(error) => write!(f, "gives {error}"),
            _ => f.write_str("gives no answer"),
        }
    }
}

/// In what drive and profile differ.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Differences([Option<Difference>; 4]);

impl Differences {
    /// The differences: vendor, product, revision, device type.
    pub fn iter(&self) -> impl Iterator<Item = &Difference> {
        self.0.iter().flatten()
    }
}

/// Whether a drive is the one of the profile.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(clippy::large_enum_variant)] // Lives for one report on the stack; there is no heap.
pub enum ProfileMatch {
    /// Vendor, product and revision are those of the profile.
    Exact,
    /// What the profile states fits; the lower half of the revision differs, or the profile does not state everything.
    Compatible(Differences),
    /// It is another drive, or it does not say which one.
    Mismatch(Differences),
}

/// How a number of the drive relates to that of the profile.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Fit {
    Exact,
    Compatible,
    Mismatch,
}

/// `mask` are the bits that must agree.
fn fit(expected: Option<u32>, found: Reading, mask: u32) -> Fit {
    match (expected, found) {
        (None, _) => Fit::Compatible,
        (Some(expected), Some(Ok(found))) if expected == found => Fit::Exact,
        (Some(expected), Some(Ok(found))) if expected & mask == found & mask => Fit::Compatible,
        _ => Fit::Mismatch,
    }
}

const ALL: u32 = u32::MAX;
const UPPER_HALF: u32 = 0xFFFF_0000;
const LOWER_HALF: u32 = 0x0000_FFFF;

impl Identification {
    /// Whether this is the drive of `model`.
    ///
    /// The device type is compared by the number of its device profile: manuals print it without the kind of drive.
    pub fn against(&self, model: &DriveModel<'_>) -> ProfileMatch {
        let identity = model.identity();
        let rows = [
            ("vendor", identity.vendor_id(), self.vendor_id, ALL),
            ("product", identity.product_code(), self.product_code, ALL),
            ("rev", identity.revision(), self.revision, UPPER_HALF),
            ("type", device_type(model), self.device_type, LOWER_HALF),
        ];
        let fits = rows.map(|(what, expected, found, mask)| {
            // A device type is no part of the identity: one that is not known says nothing, and its kind of drive is free.
            let free =
                what == "type" && (expected.is_none() || fit(expected, found, mask) == Fit::Compatible);
            let fit = if free { Fit::Exact } else { fit(expected, found, mask) };
            (fit, (fit != Fit::Exact).then_some(Difference { what, expected, found }))
        });
        let differences = Differences(fits.map(|(_, difference)| difference));
        match fits.iter().map(|(fit, _)| *fit).max() {
            Some(Fit::Mismatch) => ProfileMatch::Mismatch(differences),
            Some(Fit::Compatible) => ProfileMatch::Compatible(differences),
            _ => ProfileMatch::Exact,
        }
    }
}

fn device_type(model: &DriveModel<'_>) -> Option<u32> {
    match model.default_of(model.object(Address::new(0x1000, 0))?) {
        DefaultValue::Int(value) => u32::try_from(value).ok(),
        _ => None,
    }
}

/// A [`ProfileMatch`] as a message.
#[derive(Clone, Copy, Debug)]
pub struct Verdict<'v, 'm> {
    model: &'v DriveModel<'m>,
    found: &'v Identification,
    outcome: ProfileMatch,
}

impl<'v, 'm> Verdict<'v, 'm> {
    /// The message about a drive that should be the one of `model`.
    pub fn new(model: &'v DriveModel<'m>, found: &'v Identification) -> Self {
        Self { model, found, outcome: found.against(model) }
    }

    /// What it says.
    pub const fn outcome(&self) -> ProfileMatch {
        self.outcome
    }
}

impl Explain for Verdict<'_, '_> {
    fn severity(&self) -> Severity {
        match self.outcome {
            ProfileMatch::Exact => Severity::Note,
            ProfileMatch::Compatible(_) => Severity::Warning,
            ProfileMatch::Mismatch(_) => Severity::Error,
        }
    }

    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("IDENTITY")
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.outcome {
            ProfileMatch::Exact => "the drive is the one of profile ",
            ProfileMatch::Compatible(_) => "the drive is compatible with profile ",
            ProfileMatch::Mismatch(_) => "the drive is not the one of profile ",
        })?;
        let identity = self.model.identity();
        write!(
            f,
            "{} ({} {})",
            Clean(identity.id().as_bytes()),
            Clean(identity.vendor().as_bytes()),
            Clean(identity.product().as_bytes())
        )
    }

    fn details(&self, lines: &mut Lines<'_, '_>) -> fmt::Result {
        if let ProfileMatch::Compatible(differences) | ProfileMatch::Mismatch(differences) = &self.outcome {
            differences.iter().try_for_each(|difference| lines.line(difference.what, difference))?;
        }
        let Identification { name, hardware, software, .. } = self.found;
        let any = [name, hardware, software].iter().any(|label| !label.bytes().is_empty());
        if any {
            let text = format_args!("\"{name}\", hardware \"{hardware}\", software \"{software}\"");
            lines.line("device", text)?;
        }
        match self.found.serial {
            Some(Ok(serial)) if serial != 0 => lines.line("serial", format_args!("{serial:08X}h")),
            _ => Ok(()),
        }
    }

    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.outcome {
            ProfileMatch::Mismatch(_) => {
                "use the profile of this drive; if only the firmware differs, compare device and profile first"
            }
            _ => "",
        })
    }
}

#[cfg(test)]
mod tests;
