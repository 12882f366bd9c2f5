//! A parameter set in three columns: device, default, wanted.

use core::fmt;

use super::Setting;
use crate::client::message::Clean;
use crate::client::object::{received, AccessError, Action, Cause, Content, Shown};
use crate::model::{DriveModel, ObjectDesc};
use crate::procedure::{Answer, Ask, Procedure};
use crate::time::Instant;

/// One parameter.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct Row<'m, 'w, 'b> {
    /// The entry; `None` if the profile has none there.
    pub object: Option<&'m ObjectDesc<'m>>,
    /// What is wanted.
    pub wanted: Setting<'w>,
    /// What the device has, or why that is not known.
    pub device: Result<Content<'b>, AccessError>,
}

impl<'m> Row<'m, '_, '_> {
    /// Whether the device has what is wanted.
    pub fn agrees(&self) -> bool {
        self.device.is_ok_and(|device| device.same(self.wanted.value))
    }

    /// The row as a line of text.
    pub const fn with<'r>(&'r self, model: &'r DriveModel<'m>) -> RowText<'r, 'm> {
        RowText { model, row: self }
    }
}

/// A [`Row`] as a line of text: device, default and wanted, each in its unit; a star where device and wanted differ.
#[derive(Clone, Copy, Debug)]
pub struct RowText<'r, 'm> {
    model: &'r DriveModel<'m>,
    row: &'r Row<'m, 'r, 'r>,
}

impl fmt::Display for RowText<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Row { object, wanted, device } = self.row;
        let mark = if self.row.agrees() { ' ' } else { '*' };
        let Some(object) = object else {
            return write!(f, "{mark} {} is not in the profile", wanted.address);
        };
        write!(f, "{mark} {} {}: device ", wanted.address, Clean(object.name().as_bytes()))?;
        match device {
            Ok(content) => write!(f, "{}", Shown::new(self.model, object, *content))?,
            Err(AccessError { cause: Cause::Abort(code), .. }) => write!(f, "refuses [{code}]")?,
            Err(AccessError { cause: Cause::Access(access), .. }) => write!(f, "is {}", access.word())?,
            Err(AccessError { cause: Cause::Wire(error), .. }) => write!(f, "gives {error}")?,
            Err(_) => f.write_str("gives no answer")?,
        }
        let default = Shown::default(self.model, object);
        write!(f, " | default {default} | wanted {}", Shown::new(self.model, object, wanted.value))
    }
}

/// How many parameters agree.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct ColumnsSummary {
    /// The device has what is wanted.
    pub agree: u32,
    /// It has something else.
    pub differ: u32,
    /// What it has is not known.
    pub unknown: u32,
}

/// Reads every entry of a set; each row goes to a function of the caller.
#[derive(Debug)]
pub struct Columns<'m, 'w, F> {
    model: &'m DriveModel<'m>,
    wanted: &'w [Setting<'w>],
    sink: F,
    place: usize,
    asked: bool,
    summary: ColumnsSummary,
}

impl<'m, 'w, F: FnMut(Row<'m, 'w, '_>)> Columns<'m, 'w, F> {
    /// The comparison of a drive with what is wanted.
    pub fn new(model: &'m DriveModel<'m>, wanted: &'w [Setting<'w>], sink: F) -> Self {
        Self { model, wanted, sink, place: 0, asked: false, summary: ColumnsSummary::default() }
    }

    fn tell(&mut self, wanted: Setting<'w>, device: Result<Content<'_>, AccessError>) {
        let row = Row { object: self.model.object(wanted.address), wanted, device };
        let of = match (row.agrees(), device.is_ok()) {
            (true, _) => &mut self.summary.agree,
            (false, true) => &mut self.summary.differ,
            (false, false) => &mut self.summary.unknown,
        };
        *of = of.saturating_add(1);
        (self.sink)(row);
        self.place = self.place.saturating_add(1);
    }

    fn answered(&mut self, wanted: Setting<'w>, answer: Answer<'_>) {
        let lost = AccessError { address: wanted.address, action: Action::Read, cause: Cause::NotInProfile };
        let device = self.model.object(wanted.address).ok_or(lost).and_then(|object| {
            received(wanted.address, answer).and_then(|bytes| Content::decode(object, bytes))
        });
        self.tell(wanted, device);
    }
}

/// Why an entry is not even asked for; `None`: it is.
fn unreadable(object: Option<&ObjectDesc<'_>>) -> Option<Cause> {
    match object {
        None => Some(Cause::NotInProfile),
        Some(object) if !object.access().reads() => Some(Cause::Access(object.access())),
        Some(_) => None,
    }
}

impl<'m, 'w, F: FnMut(Row<'m, 'w, '_>)> Procedure for Columns<'m, 'w, F> {
    type Output = ColumnsSummary;

    fn next(&mut self, _: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        if let (true, Some(wanted)) = (self.asked, self.wanted.get(self.place)) {
            self.answered(*wanted, answer);
        }
        self.asked = false;
        while let Some(wanted) = self.wanted.get(self.place) {
            let Some(cause) = unreadable(self.model.object(wanted.address)) else {
                self.asked = true;
                return Ask::Upload(wanted.address);
            };
            self.tell(*wanted, Err(AccessError { address: wanted.address, action: Action::Read, cause }));
        }
        Ask::Done(self.summary)
    }
}
