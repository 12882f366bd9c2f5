//! Why a set was not written, or not all of it.

use core::fmt;

use super::order::{Role, Slot};
use crate::address::Address;
use crate::client::message::{displays, list, Clean, Explain, Lines};
use crate::client::object::AccessError;
use crate::model::DriveModel;

/// Why a set was not written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum SetCause<'m> {
    /// The entry commands the drive.
    Command,
    /// The entry is part of the mapping of process data.
    Mapping,
    /// The set has the entry twice.
    Twice,
    /// The caller's memory is too small.
    Room {
        /// How many slots there must be at least.
        needed: usize,
    },
    /// The value cannot be written, or a transfer failed.
    Access(AccessError),
    /// A rule of the drive would be broken with the whole set written.
    Rule {
        /// Its id.
        id: &'m str,
        /// Its words.
        text: &'m str,
    },
    /// No order was found in which no rule is broken on the way.
    Order {
        /// The id of a rule that is in the way.
        id: &'m str,
    },
    /// The drive took the write and holds another value.
    NotKept,
}

/// A set that was not written, or not all of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct SetError<'m> {
    /// The entry.
    pub address: Address,
    /// Why.
    pub cause: SetCause<'m>,
    /// How many writes were made before: 0 where the set was refused as a whole. Which ones:
    /// [`Apply::written`](super::Apply::written).
    pub written: usize,
}

impl<'m> SetError<'m> {
    pub(super) const fn before(address: Address, cause: SetCause<'m>) -> Self {
        Self { address, cause, written: 0 }
    }
}

/// A [`SetError`] with the names of the model, and with what was written before.
#[derive(Clone, Copy, Debug)]
pub struct SetReport<'r, 'm> {
    error: SetError<'m>,
    model: Option<&'r DriveModel<'m>>,
    slots: &'r [Slot],
}

impl<'r, 'm> SetReport<'r, 'm> {
    pub(super) const fn new(error: SetError<'m>, model: &'r DriveModel<'m>, slots: &'r [Slot]) -> Self {
        Self { error, model: Some(model), slots }
    }

    const fn alone(error: SetError<'m>) -> Self {
        Self { error, model: None, slots: &[] }
    }
}

impl<'m> SetError<'m> {
    /// The error with the names of the model. After [`Apply`](super::Apply) ran, its
    /// [`explain`](super::Apply::explain) says more.
    pub const fn with<'r>(&self, model: &'r DriveModel<'m>) -> SetReport<'r, 'm> {
        SetReport::new(*self, model, &[])
    }
}

impl Explain for SetReport<'_, '_> {
    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.error.cause {
            SetCause::Access(error) => error.code(f),
            SetCause::Command => f.write_str("STORE"),
            _ => f.write_str("SET"),
        }
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let address = self.error.address;
        match (&self.error.cause, self.model) {
            (SetCause::Access(error), Some(model)) => return error.with(model).what(f),
            (SetCause::Access(error), None) => return error.what(f),
            _ => write!(f, "{address}")?,
        }
        if let Some(object) = self.model.and_then(|model| model.object(address)) {
            write!(f, " \"{}\"", Clean(object.name().as_bytes()))?;
        }
        match &self.error.cause {
            SetCause::Command => f.write_str(" is a command and has no place in a parameter set"),
            SetCause::Mapping => f.write_str(" is part of the mapping of process data"),
            SetCause::Twice => f.write_str(" is in the set twice"),
            SetCause::Room { needed } => write!(f, " needs slot {needed}, and there are fewer"),
            SetCause::Rule { id, text } => {
                write!(f, " breaks rule {}: {}", Clean(id.as_bytes()), Clean(text.as_bytes()))
            }
            SetCause::Order { id } => {
                write!(f, " can be written in no order that keeps rule {}", Clean(id.as_bytes()))
            }
            SetCause::NotKept => f.write_str(" was written, and the drive holds another value"),
            SetCause::Access(_) => Ok(()),
        }
    }

    fn details(&self, lines: &mut Lines<'_, '_>) -> fmt::Result {
        if let (SetCause::Access(error), Some(model)) = (&self.error.cause, self.model) {
            error.with(model).details(lines)?;
        }
        if self.error.written == 0 {
            return lines.line("effect", "nothing was written");
        }
        if self.slots.is_empty() {
            return lines.line("effect", format_args!("{} entries were written", self.error.written));
        }
        let written = |slot: &Slot| matches!(slot.role, Role::Written(_));
        let open = |slot: &Slot| matches!(slot.role, Role::Turn(_));
        lines.line("written", List(self.slots, written))?;
        lines.line("not", List(self.slots, open))
    }

    fn why(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.error.cause {
            SetCause::Command => f.write_str("a drive that keeps it would move at its next enable"),
            SetCause::Access(error) => error.why(f),
            SetCause::NotKept => {
                f.write_str("the drive clips it, keeps it for later, or process data overwrite it")
            }
            _ => Ok(()),
        }
    }

    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.error.cause {
            SetCause::Access(error) => error.remedy(f),
            SetCause::Command => f.write_str("leave it out; the client sends it when it is meant"),
            SetCause::Mapping => f.write_str("write it as a layout: it has an order of its own"),
            SetCause::Twice => f.write_str("leave one of them out"),
            SetCause::Room { .. } => {
                f.write_str("give more slots: one an entry, and one for each that rules name")
            }
            SetCause::Rule { .. } => f.write_str("change the set so that the rule holds"),
            SetCause::Order { .. } => f.write_str("write the set in two parts, with values between them"),
            SetCause::NotKept => f.write_str("read the entry, and its limits"),
        }
    }
}

/// The addresses of some slots.
struct List<'s, F>(&'s [Slot], F);

impl<F: Fn(&Slot) -> bool> fmt::Display for List<'_, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        list(f, ", ", self.0.iter().filter(|slot| (self.1)(slot)).map(|slot| slot.address))
    }
}

impl Explain for SetError<'_> {
    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        SetReport::alone(*self).code(f)
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        SetReport::alone(*self).what(f)
    }

    fn details(&self, lines: &mut Lines<'_, '_>) -> fmt::Result {
        SetReport::alone(*self).details(lines)
    }

    fn why(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        SetReport::alone(*self).why(f)
    }

    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        SetReport::alone(*self).remedy(f)
    }
}

displays! {
    ['m] SetError<'m>;
    ['r, 'm] SetReport<'r, 'm>;
}
