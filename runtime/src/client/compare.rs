//! A drive against its profile, entry by entry: what is missing, what has another length, what differs from the default.
//!
//! Findings go to a function of the caller one by one, so that no list is needed. Write-only entries cannot be read; they
//! are named as skipped. Nothing is written to the drive.
//!
//! ```
//! use drivewright_runtime::client::compare::{Compare, Kind};
//! use drivewright_runtime::prelude::*;
//! use drivewright_runtime::procedure::{Answer, Ask, Procedure};
//! use drivewright_runtime::time::Instant;
//! use drivewright_runtime::AbortCode;
//!
//! static OBJECTS: [ObjectDesc<'static>; 1] =
//!     [ObjectDesc::new(Address::new(0x6081, 0), DataType::UNSIGNED32, Access::Rw, Mapping::RxTx, "Profile velocity")];
//! let model = DriveModel::new(Identity::new("acme-x3", "Acme", "X3")).with_objects(&OBJECTS);
//!
//! let mut missing = 0;
//! let mut compare = Compare::new(&model, |finding| missing += usize::from(matches!(finding.kind, Kind::Missing(_))));
//! assert_eq!(compare.next(Instant::START, Answer::Begin), Ask::Upload(Address::new(0x6081, 0)));
//! compare.next(Instant::START, Answer::Abort(AbortCode::NO_OBJECT));
//! assert_eq!(missing, 1);
//! ```

use core::fmt;

use crate::abort::AbortCode;
use crate::access::Access;
use crate::client::message::{displays, Clean, Explain, Severity};
use crate::client::object::{received, AccessError, Cause, Content, Shown};
use crate::data_type::DataType;
use crate::model::{DriveModel, ObjectDesc};
use crate::procedure::{Answer, Ask, Procedure};
use crate::time::Instant;
use crate::wire::WireError;

/// After so many reads without an answer, one after the other, the drive is taken for gone.
pub const SILENT_READS: u8 = 3;

/// What was found at an entry.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Kind<'b> {
    /// The drive has no such entry.
    Missing(AbortCode),
    /// The entry has another length than its type.
    Length(WireError),
    /// The read was refused for another reason, or had no answer.
    Refused(Cause),
    /// A constant is another one: the profile is that of other firmware.
    Constant(Content<'b>),
    /// A setting or a constant holds a value that the profile excludes.
    Excluded(Content<'b>),
    /// A setting is not at its default.
    Setting(Content<'b>),
    /// A value that the drive reports is not the one that it ships with.
    Reported(Content<'b>),
    /// The entry is write-only: nobody can compare it.
    Skipped,
}

/// An entry at which drive and profile differ, or that was not compared.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct Finding<'m, 'b> {
    /// The entry.
    pub object: &'m ObjectDesc<'m>,
    /// What was found.
    pub kind: Kind<'b>,
}

/// How a comparison went, in numbers of entries.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Summary {
    /// As the profile says, or read without a default to compare with.
    pub as_stated: u32,
    /// Settings and reported values that are not at their default.
    pub changed: u32,
    /// Where drive and profile contradict each other: missing, other lengths, other constants, excluded values.
    pub contradictions: u32,
    /// Refused or without an answer.
    pub refused: u32,
    /// Write-only.
    pub skipped: u32,
}

/// Compares a drive with its profile.
#[derive(Debug)]
pub struct Compare<'m, F> {
    model: &'m DriveModel<'m>,
    sink: F,
    asked: Option<&'m ObjectDesc<'m>>,
    place: usize,
    silent: u8,
    summary: Summary,
}

impl<'m, F: FnMut(Finding<'m, '_>)> Compare<'m, F> {
    /// The comparison of a drive with `model`; every finding goes to `sink`.
    pub fn new(model: &'m DriveModel<'m>, sink: F) -> Self {
        Self { model, sink, asked: None, place: 0, silent: 0, summary: Summary::default() }
    }

    fn tell(&mut self, object: &'m ObjectDesc<'m>, kind: Kind<'_>) {
        self.summary.count(kind);
        (self.sink)(Finding { object, kind });
    }

    /// Looks at what became of a read.
    fn look(&mut self, object: &'m ObjectDesc<'m>, answer: Answer<'_>) -> Result<(), AccessError> {
        let content = received(object.address(), answer).and_then(|bytes| Content::decode(object, bytes));
        let silent = matches!(content, Err(AccessError { cause: Cause::NoAnswer, .. }));
        self.silent = if silent { self.silent.saturating_add(1) } else { 0 };
        match content {
            Err(error) if self.silent >= SILENT_READS => return Err(error),
            Err(error) => self.tell(object, failed(error.cause)),
            Ok(content) => match judge(self.model, object, content) {
                Some(kind) => self.tell(object, kind),
                None => self.summary.as_stated = self.summary.as_stated.saturating_add(1),
            },
        }
        Ok(())
    }

    /// The next entry that can be read; those before it are skipped.
    fn advance(&mut self) -> Option<&'m ObjectDesc<'m>> {
        loop {
            let object = self.model.objects().get(self.place)?;
            self.place = self.place.saturating_add(1);
            if object.access().reads() {
                return Some(object);
            }
            self.tell(object, Kind::Skipped);
        }
    }
}

impl Summary {
    fn count(&mut self, kind: Kind<'_>) {
        let of = match kind {
            Kind::Missing(_) | Kind::Length(_) | Kind::Constant(_) | Kind::Excluded(_) => {
                &mut self.contradictions
            }
            Kind::Refused(_) => &mut self.refused,
            Kind::Setting(_) | Kind::Reported(_) => &mut self.changed,
            Kind::Skipped => &mut self.skipped,
        };
        *of = of.saturating_add(1);
    }
}

fn failed(cause: Cause) -> Kind<'static> {
    match cause {
        Cause::Abort(code) if cause.is_missing() => Kind::Missing(code),
        Cause::Wire(error) => Kind::Length(error),
        cause => Kind::Refused(cause),
    }
}

/// What there is to say about a value; `None`: nothing.
fn judge<'b>(model: &DriveModel<'_>, object: &ObjectDesc<'_>, content: Content<'b>) -> Option<Kind<'b>> {
    let (writes, constant) = (object.access().writes(), is_constant(model, object));
    let number = content.number().filter(|_| writes || constant);
    if number.is_some_and(|number| !takes(model, object, number)) {
        return Some(Kind::Excluded(content));
    }
    if content.is(model.default_of(object))? {
        return None;
    }
    Some(match writes {
        true => Kind::Setting(content),
        false if constant => Kind::Constant(content),
        false => Kind::Reported(content),
    })
}

fn takes(model: &DriveModel<'_>, object: &ObjectDesc<'_>, number: i128) -> bool {
    let listed = model.allowed_of(object);
    object.accepts(number)
        && listed.map_or(true, |list| list.iter().any(|value| i128::from(*value) == number))
}

/// Whether an entry that cannot be written never changes. Manuals print `ro` for what CiA 301 and 402 call constant: device
/// type, names and versions, identity, supported modes, and the number of sub-indexes. A serial number is of one drive.
fn is_constant(model: &DriveModel<'_>, object: &ObjectDesc<'_>) -> bool {
    let address = object.address();
    match (address.index(), address.sub()) {
        (0x1018, 4) => false,
        (0x1000 | 0x1008..=0x100A | 0x1018 | 0x6502, _) => true,
        (_, 0) if object.data_type() == DataType::UNSIGNED8 => model.entries_of(address).len() > 1,
        _ => object.access() == Access::Const,
    }
}

impl<'m, F: FnMut(Finding<'m, '_>)> Procedure for Compare<'m, F> {
    /// [`Err`] once the drive does not answer any more.
    type Output = Result<Summary, AccessError>;

    fn next(&mut self, _: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        if let Some(object) = self.asked.take() {
            if let Err(error) = self.look(object, answer) {
                return Ask::Done(Err(error));
            }
        }
        self.asked = self.advance();
        match self.asked {
            Some(object) => Ask::Upload(object.address()),
            None => Ask::Done(Ok(self.summary)),
        }
    }
}

/// A [`Finding`] as a message.
#[derive(Clone, Copy, Debug)]
pub struct Told<'f, 'm> {
    model: &'f DriveModel<'m>,
    object: &'f ObjectDesc<'m>,
    kind: Kind<'f>,
}

impl<'m> Finding<'m, '_> {
    /// The message, with names and units of the model.
    pub const fn with<'f>(&'f self, model: &'f DriveModel<'m>) -> Told<'f, 'm> {
        Told { model, object: self.object, kind: self.kind }
    }
}

impl Explain for Told<'_, '_> {
    fn severity(&self) -> Severity {
        match self.kind {
            Kind::Setting(_) | Kind::Reported(_) | Kind::Skipped => Severity::Note,
            _ => Severity::Warning,
        }
    }

    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("DIFF")
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} \"{}\" ", self.object.address(), Clean(self.object.name().as_bytes()))?;
        match self.kind {
            Kind::Missing(code) => write!(f, "is missing on the device [{code}]"),
            Kind::Length(error) => write!(f, "has another length: {error} ({})", self.object.data_type()),
            Kind::Refused(Cause::Abort(code)) => write!(f, "cannot be read [{code}]"),
            Kind::Refused(Cause::TooLong) => f.write_str("is longer than there is room for"),
            Kind::Refused(_) => f.write_str("gave no answer"),
            Kind::Skipped => f.write_str("is write-only and was not compared"),
            Kind::Constant(found) | Kind::Excluded(found) | Kind::Setting(found) | Kind::Reported(found) => {
                let device = Shown::new(self.model, self.object, found);
                write!(f, "device {device}, default {}", Shown::default(self.model, self.object))
            }
        }
    }

    fn why(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.kind {
            Kind::Missing(_) | Kind::Length(_) | Kind::Constant(_) => {
                f.write_str("profile and firmware do not belong together, or the profile is wrong here")
            }
            Kind::Excluded(_) => {
                let (min, max) = (self.object.min(), self.object.max());
                f.write_str("the profile excludes this value")?;
                min.map_or(Ok(()), |min| write!(f, ", lowest {min}"))?;
                max.map_or(Ok(()), |max| write!(f, ", highest {max}"))
            }
            _ => Ok(()),
        }
    }
}

displays! {
    ['f, 'm] Told<'f, 'm>;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::client::testing::{at, Dictionary, Nonsense};
    use crate::prelude::*;
    use crate::transport::Refusal;
    use std::string::{String, ToString};
    use std::vec::Vec;

    const fn entry(index: u16, sub: u8, ty: DataType, access: Access) -> ObjectDesc<'static> {
        ObjectDesc::new(at(index, sub), ty, access, Mapping::Unmapped, "X")
    }

    static TEXTS: [TextDefault<'static>; 1] = [TextDefault::new(at(0x1008, 0), "X3")];
    static OBJECTS: [ObjectDesc<'static>; 9] = [
        entry(0x1000, 0, DataType::UNSIGNED32, Access::Ro).default_int(0x192),
        entry(0x1008, 0, DataType::VISIBLE_STRING, Access::Ro),
        entry(0x1018, 0, DataType::UNSIGNED8, Access::Ro).default_int(4),
        entry(0x1018, 4, DataType::UNSIGNED32, Access::Ro).default_int(0),
        entry(0x2000, 0, DataType::UNSIGNED8, Access::Wo).default_int(1),
        entry(0x6041, 0, DataType::UNSIGNED16, Access::Ro).default_int(0),
        entry(0x6064, 0, DataType::INTEGER32, Access::Ro),
        entry(0x607D, 1, DataType::INTEGER32, Access::Rw).default_int(-5).range(-10, 0),
        entry(0x607D, 2, DataType::INTEGER32, Access::Rw).default_int(5).range(0, 10),
    ];
    static MODEL: DriveModel<'static> =
        DriveModel::new(Identity::new("x3", "Acme", "X3")).with_objects(&OBJECTS).with_texts(&TEXTS);

    fn drive() -> Dictionary {
        Dictionary::default()
            .with(at(0x1000, 0), &[0x92, 1, 0, 0])
            .with(at(0x1008, 0), b"X3\0")
            .with(at(0x1018, 0), &[4])
            .with(at(0x1018, 4), &[9, 0, 0, 0])
            .with(at(0x6041, 0), &[0x50, 2])
            .with(at(0x6064, 0), &[1, 0, 0, 0])
            .with(at(0x607D, 1), &(-5_i32).to_le_bytes())
            .with(at(0x607D, 2), &5_i32.to_le_bytes())
    }

    fn compare(drive: &mut Dictionary) -> (Result<Summary, AccessError>, Vec<String>) {
        let mut told = Vec::new();
        let result = drive.run(Compare::new(&MODEL, |finding| told.push(finding.with(&MODEL).to_string())));
        (result, told)
    }

    #[test]
    fn a_drive_as_it_ships_has_only_what_lives() {
        let (result, told) = compare(&mut drive());
        let summary = Summary { as_stated: 6, changed: 2, contradictions: 0, refused: 0, skipped: 1 };
        assert_eq!(result, Ok(summary));
        assert_eq!(
            told,
            [
                "note[DIFF]: 1018:04 \"X\" device 9, default 0",
                "note[DIFF]: 2000:00 \"X\" is write-only and was not compared",
                "note[DIFF]: 6041:00 \"X\" device 592, default 0",
            ]
        );
    }

    #[test]
    fn b19_sub_indexes_are_entries_of_their_own() {
        let mut drive = drive().with(at(0x607D, 2), &7_i32.to_le_bytes());
        let (_, told) = compare(&mut drive);
        let limits: Vec<&String> = told.iter().filter(|text| text.contains("607D")).collect();
        assert_eq!(limits, ["note[DIFF]: 607D:02 \"X\" device 7, default 5"]);
    }

    #[test]
    fn contradictions_are_warnings() {
        let mut drive = drive()
            .with(at(0x1000, 0), &[0x91, 1, 0, 0])
            .with(at(0x1008, 0), b"Y\x1B")
            .with(at(0x6064, 0), &[1])
            .with(at(0x607D, 1), &(-11_i32).to_le_bytes());
        drive.entries.remove(&at(0x607D, 2));
        drive.reads.insert(at(0x6041, 0), Refusal::Abort(AbortCode::DEVICE_STATE));
        let (result, told) = compare(&mut drive);
        let summary = result.unwrap();
        assert_eq!((summary.contradictions, summary.refused, summary.skipped), (5, 1, 1));
        for text in [
            "warning[DIFF]: 1000:00 \"X\" device 401, default 402\n",
            "warning[DIFF]: 1008:00 \"X\" device \"Y\\x1b\", default \"X3\"\n",
            "warning[DIFF]: 6064:00 \"X\" has another length: 1 bytes where the type takes 4 (INTEGER32)\n",
            "warning[DIFF]: 607D:01 \"X\" device -11, default -5\n  why    : the profile excludes this value, lowest -10, highest 0",
            "warning[DIFF]: 607D:02 \"X\" is missing on the device [0609 0011: sub-index does not exist]\n",
            "warning[DIFF]: 6041:00 \"X\" cannot be read [0800 0022: ",
        ] {
            assert!(told.iter().any(|told| told.starts_with(text)), "{text} is not in {told:#?}");
        }
    }

    #[test]
    fn a_drive_that_is_gone_ends_it() {
        let mut drive = drive();
        for object in &OBJECTS {
            drive.reads.insert(object.address(), Refusal::NoAnswer);
        }
        let (result, told) = compare(&mut drive);
        assert_eq!(
            result.map_err(|error| (error.address, error.cause)),
            Err((at(0x1018, 0), Cause::NoAnswer))
        );
        assert_eq!(told.len(), 2);
    }

    #[test]
    fn nonsense_ends() {
        for seed in 0..2_000 {
            let mut findings = 0;
            let mut compare = Compare::new(&MODEL, |finding| {
                findings += 1;
                assert!(!finding.with(&MODEL).to_string().contains('\u{1B}'));
            });
            let _ = Nonsense::new(seed).run(&mut compare);
            assert!(findings <= OBJECTS.len());
        }
    }
}
