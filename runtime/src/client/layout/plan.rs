//! What a program wants to exchange, checked against what the profile allows.

use core::fmt;

use super::{assignment, MAX_ENTRIES};
use crate::address::Address;
use crate::client::message::{displays, Clean, Explain};
use crate::client::tally::sum;
use crate::mapping::Direction;
use crate::model::{DriveModel, PdoDesc, Remap};
use crate::pdo::{MapEntry, ProcessData};
use crate::rule::Occasion;

/// A PDO with what it carries.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Mapped<'p> {
    index: u16,
    entries: &'p [MapEntry],
}

impl<'p> Mapped<'p> {
    /// The PDO whose mapping object is at `index`, with these entries in order.
    pub const fn new(index: u16, entries: &'p [MapEntry]) -> Self {
        Self { index, entries }
    }

    /// The PDO at `index` with a typed layout.
    pub const fn layout<L: ProcessData>(index: u16) -> Self {
        Self { index, entries: L::MAPPING }
    }

    /// A PDO as the drive ships.
    pub const fn shipped(pdo: &PdoDesc<'p>) -> Self {
        Self { index: pdo.address().index(), entries: pdo.entries() }
    }

    /// The index of its mapping object.
    pub const fn index(&self) -> u16 {
        self.index
    }

    /// What it carries, in order.
    pub const fn entries(&self) -> &'p [MapEntry] {
        self.entries
    }

    /// Length in bits.
    pub fn bits(&self) -> usize {
        sum(self.entries.iter().map(|entry| entry.bits().into()))
    }
}

/// What a program wants to exchange in one direction.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Plan<'p> {
    direction: Direction,
    pdos: &'p [Mapped<'p>],
}

/// Why a plan is none for this drive. `'m` is the model's.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum PlanCause<'m> {
    /// The profile has no such mapping object, or one of the other direction.
    NoSuchPdo,
    /// The profile has no object that assigns PDOs.
    NoAssignment,
    /// More entries than the PDO takes.
    Entries {
        /// How many the plan has.
        wanted: usize,
        /// The most that the drive takes.
        most: usize,
    },
    /// More bytes than the PDO takes.
    Bytes {
        /// How many the plan has.
        wanted: usize,
        /// The most that the drive takes.
        most: usize,
    },
    /// The drive does not let anyone change what the PDO carries.
    Fixed,
    /// The entry cannot be mapped in this direction, or the manual does not say that it can.
    NotMappable(MapEntry),
    /// The entry has another length than its type.
    Bits {
        /// The entry.
        entry: MapEntry,
        /// The length of its type.
        bits: u16,
    },
    /// A rule of the drive forbids it.
    Rule {
        /// Its id.
        id: &'m str,
        /// Its words.
        text: &'m str,
    },
}

/// A plan that is none for this drive. Nothing was sent.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct PlanError<'m> {
    /// The index of the mapping object.
    pub pdo: u16,
    /// Why.
    pub cause: PlanCause<'m>,
}

impl<'p> Plan<'p> {
    /// These PDOs, in this order.
    pub const fn new(direction: Direction, pdos: &'p [Mapped<'p>]) -> Self {
        Self { direction, pdos }
    }

    /// Direction, seen from the drive.
    pub const fn direction(&self) -> Direction {
        self.direction
    }

    /// The PDOs, in order.
    pub const fn pdos(&self) -> &'p [Mapped<'p>] {
        self.pdos
    }

    /// That the drive can take this.
    ///
    /// # Errors
    /// The first [`PlanError`]: limits, directions, and the rules for mapping that the plan's own values decide.
    pub fn check<'m>(&self, model: &DriveModel<'m>) -> Result<(), PlanError<'m>> {
        let first = self.pdos.first().map_or(0, Mapped::index);
        if model.object(assignment(self.direction, 0)).is_none() {
            return Err(PlanError { pdo: first, cause: PlanCause::NoAssignment });
        }
        for pdo in self.pdos {
            let checked = self.check_pdo(model, pdo);
            checked.map_err(|cause| PlanError { pdo: pdo.index, cause })?;
        }
        let value = |address| self.value(address);
        match model.rules_on(Some(Occasion::Remap)).find(|rule| rule.broken(value)) {
            None => Ok(()),
            Some(rule) => {
                Err(PlanError { pdo: first, cause: PlanCause::Rule { id: rule.id(), text: rule.text() } })
            }
        }
    }

    fn check_pdo<'m>(&self, model: &DriveModel<'m>, pdo: &Mapped<'_>) -> Result<(), PlanCause<'m>> {
        let count = model.object(Address::new(pdo.index, 0)).ok_or(PlanCause::NoSuchPdo)?;
        let shipped = model.pdo(Address::new(pdo.index, 0));
        if shipped.is_some_and(|shipped| shipped.direction() != self.direction) {
            return Err(PlanCause::NoSuchPdo);
        }
        if is_fixed(shipped) && shipped.map(PdoDesc::entries) != Some(pdo.entries) {
            return Err(PlanCause::Fixed);
        }
        let most = shipped.and_then(PdoDesc::max_entries).map(usize::from);
        let most =
            most.or_else(|| usize::try_from(count.max()?).ok()).unwrap_or(MAX_ENTRIES).min(MAX_ENTRIES);
        if pdo.entries.len() > most {
            return Err(PlanCause::Entries { wanted: pdo.entries.len(), most });
        }
        let bytes = pdo.bits().div_ceil(8);
        match shipped.and_then(PdoDesc::max_bytes).map(usize::from) {
            Some(most) if bytes > most => return Err(PlanCause::Bytes { wanted: bytes, most }),
            _ => {}
        }
        pdo.entries.iter().try_for_each(|entry| self.check_entry(model, *entry))
    }

    fn check_entry<'m>(&self, model: &DriveModel<'m>, entry: MapEntry) -> Result<(), PlanCause<'m>> {
        let object = model.object(entry.address()).ok_or(PlanCause::NotMappable(entry))?;
        if object.mapping().allows(self.direction) != Some(true) {
            return Err(PlanCause::NotMappable(entry));
        }
        let bits = object.data_type().bits();
        if bits == u16::from(entry.bits()) {
            Ok(())
        } else {
            Err(PlanCause::Bits { entry, bits })
        }
    }

    /// What the plan writes to `address`; `None` where it writes nothing there.
    fn value(&self, address: Address) -> Option<i128> {
        let place = usize::from(address.sub()).checked_sub(1);
        let assigned = assignment(self.direction, 0).index() == address.index();
        let count = |n: usize| i128::try_from(n).ok();
        match (place, assigned) {
            (None, true) => count(self.pdos.len()),
            (Some(place), true) => self.pdos.get(place).map(|pdo| pdo.index.into()),
            (place, false) => {
                let pdo = self.pdos.iter().find(|pdo| pdo.index == address.index())?;
                match place {
                    None => count(pdo.entries.len()),
                    Some(place) => pdo.entries.get(place).map(|entry| entry.word().into()),
                }
            }
        }
    }
}

/// Whether nobody can change what a PDO carries.
pub(super) fn is_fixed(shipped: Option<&PdoDesc<'_>>) -> bool {
    shipped.is_some_and(|pdo| matches!(pdo.remap(), Remap::Fixed | Remap::Selectable))
}

impl Explain for PlanError<'_> {
    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("LAYOUT")
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the layout for {:04X}h was not written: ", self.pdo)?;
        match self.cause {
            PlanCause::NoSuchPdo => f.write_str("the profile has no such PDO in this direction"),
            PlanCause::NoAssignment => f.write_str("the profile has no object that assigns PDOs"),
            PlanCause::Entries { wanted, most } => write!(f, "{wanted} entries, and it takes {most}"),
            PlanCause::Bytes { wanted, most } => write!(f, "{wanted} bytes, and it takes {most}"),
            PlanCause::Fixed => f.write_str("the drive does not let anyone change what it carries"),
            PlanCause::NotMappable(entry) => {
                write!(f, "{} cannot be mapped in this direction", entry.address())
            }
            PlanCause::Bits { entry, bits } => write!(f, "{entry}, and its type has {bits}"),
            PlanCause::Rule { id, text } => {
                write!(f, "rule {}: {}", Clean(id.as_bytes()), Clean(text.as_bytes()))
            }
        }
    }

    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.cause {
            PlanCause::NoSuchPdo => "use a mapping object of the profile",
            PlanCause::NoAssignment => "this drive has its PDOs by another way than 1C12h and 1C13h",
            PlanCause::Entries { .. } | PlanCause::Bytes { .. } => {
                "leave out entries, or spread them over two PDOs"
            }
            PlanCause::Fixed => "use the layout as the drive ships",
            PlanCause::NotMappable(_) => "read or write it over SDO",
            PlanCause::Bits { .. } => "give the entry the length of its type",
            PlanCause::Rule { .. } => "change the plan so that the rule holds",
        })
    }
}

displays! {
    ['m] PlanError<'m>;
}
