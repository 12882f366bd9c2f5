//! The layout that a drive has, against the one that a program wants.

use core::fmt;

use super::plan::is_fixed;
use super::{assignment, Mapped, Plan, MAX_ENTRIES};
use crate::address::Address;
use crate::client::message::{displays, list, Explain, Lines};
use crate::client::object::{received, AccessError, Action, Cause};
use crate::client::tally::sum;
use crate::mapping::Direction;
use crate::model::DriveModel;
use crate::pdo::{compare, LayoutMismatch, MapEntry};
use crate::procedure::{Answer, Ask, Procedure};
use crate::time::Instant;
use crate::wire::Fixed;

/// Reads what a drive exchanges in one direction, and compares it with a plan.
///
/// Where the profile has no 1C12h and 1C13h, as on CAN, only the mapping objects are read.
#[derive(Clone, Copy, Debug)]
pub struct ReadBack<'p, 'm> {
    plan: Plan<'p>,
    model: &'m DriveModel<'m>,
    /// Where the next answer belongs: the place of a PDO in the plan, and a sub-index. No PDO: the assignment.
    pdo: Option<usize>,
    sub: u8,
    /// What the drive has there: how many entries it says, and those that were read.
    count: u8,
    words: [u32; MAX_ENTRIES],
    used: usize,
}

/// Why a layout is not the wanted one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum LayoutCause {
    /// It could not be read.
    Access(AccessError),
    /// Other PDOs are assigned.
    Assignment {
        /// Sub-index of the assignment, from 1.
        position: u8,
        /// The PDO that should be assigned there; `None`: there should be none.
        expected: Option<u16>,
        /// The PDO that is; `None`: there is none.
        found: Option<u16>,
    },
    /// The PDO carries something else.
    Mapping(LayoutMismatch),
}

/// A layout that is not the wanted one: process data would be read and written at the wrong bytes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct LayoutError {
    /// Direction, seen from the drive.
    pub direction: Direction,
    /// The index of the mapping object, or of the assignment.
    pub index: u16,
    /// Why.
    pub cause: LayoutCause,
}

impl<'p, 'm> ReadBack<'p, 'm> {
    /// The comparison with `plan`.
    pub fn new(model: &'m DriveModel<'m>, plan: Plan<'p>) -> Self {
        let assigned = model.object(assignment(plan.direction(), 0)).is_some();
        let pdo = if assigned { None } else { Some(0) };
        Self { plan, model, pdo, sub: 0, count: 0, words: [0; MAX_ENTRIES], used: 0 }
    }

    /// What the drive has in the PDO that was read last: that of the error, after one.
    pub fn found(&self) -> impl Iterator<Item = MapEntry> + '_ {
        self.words.iter().take(self.used).map(|word| MapEntry::from_word(*word))
    }

    /// The error with both layouts.
    pub const fn explain(&self, error: &'_ LayoutError) -> LayoutReport<'_, 'p, 'm> {
        LayoutReport { read: self, error: *error }
    }

    fn mapped(&self) -> Option<&'p Mapped<'p>> {
        self.plan.pdos().get(self.pdo?)
    }

    fn address(&self) -> Option<Address> {
        match self.pdo {
            None => Some(assignment(self.plan.direction(), self.sub)),
            Some(_) => self.mapped().map(|pdo| Address::new(pdo.index(), self.sub)),
        }
    }

    fn take(&mut self, address: Address, answer: Answer<'_>) -> Result<(), LayoutCause> {
        match (self.sub, self.pdo) {
            (0, _) => {
                self.count = read::<u8>(address, answer)?;
                self.used = 0;
            }
            (_, None) => self.assigned(read::<u16>(address, answer)?)?,
            (_, Some(_)) => {
                let word = read::<u32>(address, answer)?;
                if let Some(place) = self.words.get_mut(self.used) {
                    *place = word;
                    self.used = self.used.saturating_add(1);
                }
            }
        }
        self.go_on()
    }

    /// That the PDO at this place of the assignment is that of the plan.
    fn assigned(&self, found: u16) -> Result<(), LayoutCause> {
        let expected = usize::from(self.sub).checked_sub(1).and_then(|place| self.plan.pdos().get(place));
        let expected = expected.map(Mapped::index);
        if expected == Some(found) {
            return Ok(());
        }
        Err(LayoutCause::Assignment { position: self.sub, expected, found: Some(found) })
    }

    /// The next sub-index, or the next object after the last one.
    fn go_on(&mut self) -> Result<(), LayoutCause> {
        let last = usize::from(self.count).min(MAX_ENTRIES);
        if usize::from(self.sub) < last {
            self.sub = self.sub.saturating_add(1);
            return Ok(());
        }
        self.sub = 0;
        match self.mapped() {
            None => {
                let position = self.count.saturating_add(1);
                if let Some(missing) = self.plan.pdos().get(usize::from(self.count)) {
                    let expected = Some(missing.index());
                    return Err(LayoutCause::Assignment { position, expected, found: None });
                }
                self.pdo = Some(0);
            }
            Some(pdo) => {
                self.compare(pdo).map_err(LayoutCause::Mapping)?;
                self.pdo = self.pdo.map(|place| place.saturating_add(1));
            }
        }
        Ok(())
    }

    fn compare(&self, pdo: &Mapped<'_>) -> Result<(), LayoutMismatch> {
        compare(pdo.entries(), self.words.iter().take(self.used).copied())?;
        if usize::from(self.count) <= self.used {
            return Ok(());
        }
        // More than a mapping object holds: what they are was not read.
        let found = MapEntry::from_word(0);
        Err(LayoutMismatch::Extra { position: self.used.saturating_add(1), found })
    }
}

fn read<T: Fixed>(address: Address, answer: Answer<'_>) -> Result<T, LayoutCause> {
    let wire = |error| AccessError { address, action: Action::Read, cause: Cause::Wire(error) };
    let value = received(address, answer).and_then(|bytes| T::decode(bytes).map_err(wire));
    value.map_err(LayoutCause::Access)
}

impl Procedure for ReadBack<'_, '_> {
    type Output = Result<(), LayoutError>;

    fn next(&mut self, _: Instant, answer: Answer<'_>) -> Ask<'_, Self::Output> {
        if let (Some(address), false) = (self.address(), answer == Answer::Begin) {
            if let Err(cause) = self.take(address, answer) {
                let (direction, index) = (self.plan.direction(), address.index());
                return Ask::Done(Err(LayoutError { direction, index, cause }));
            }
        }
        self.address().map_or(Ask::Done(Ok(())), Ask::Upload)
    }
}

impl LayoutError {
    fn pdo(&self) -> &'static str {
        match self.direction {
            Direction::Rx => "RxPDO",
            Direction::Tx => "TxPDO",
        }
    }
}

impl Explain for LayoutError {
    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.cause {
            LayoutCause::Access(error) => error.code(f),
            _ => f.write_str("LAYOUT"),
        }
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.cause {
            LayoutCause::Access(error) => error.what(f),
            LayoutCause::Assignment { position, expected, found } => {
                write!(f, "assignment {:04X}:{position:02X} ", self.index)?;
                match found {
                    Some(found) => write!(f, "is {found:04X}h, ")?,
                    None => f.write_str("is not in use, ")?,
                }
                match expected {
                    Some(expected) => write!(f, "not {expected:04X}h"),
                    None => f.write_str("and should not be in use"),
                }
            }
            LayoutCause::Mapping(mismatch) => {
                write!(f, "{} {:04X}h is not the wanted layout: {mismatch}", self.pdo(), self.index)
            }
        }
    }

    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.cause {
            LayoutCause::Access(error) => error.remedy(f),
            _ => f.write_str("do not exchange process data; write the layout, then read it back again"),
        }
    }
}

/// A [`LayoutError`] with both layouts.
#[derive(Clone, Copy, Debug)]
pub struct LayoutReport<'r, 'p, 'm> {
    read: &'r ReadBack<'p, 'm>,
    error: LayoutError,
}

impl LayoutReport<'_, '_, '_> {
    fn wanted(&self) -> Option<&Mapped<'_>> {
        self.read.plan.pdos().iter().find(|pdo| pdo.index() == self.error.index)
    }
}

impl Explain for LayoutReport<'_, '_, '_> {
    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.error.code(f)
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.error.what(f)
    }

    fn details(&self, lines: &mut Lines<'_, '_>) -> fmt::Result {
        let (LayoutCause::Mapping(mismatch), Some(wanted)) = (&self.error.cause, self.wanted()) else {
            return Ok(());
        };
        lines.line("wanted", Row(|| wanted.entries().iter().copied()))?;
        lines.line("device", Row(|| self.read.found()))?;
        lines.line("effect", Effect(mismatch))
    }

    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if is_fixed(self.read.model.pdo(Address::new(self.error.index, 0))) {
            return f.write_str("use the layout of the drive: it does not let anyone change it");
        }
        self.error.remedy(f)?;
        match &self.error.cause {
            LayoutCause::Mapping(
                LayoutMismatch::Object { position, expected, .. }
                | LayoutMismatch::Bits { position, expected, .. },
            ) => {
                let (index, word) = (self.error.index, expected.word());
                write!(f, "; {index:04X}:{position:02X} should be {word:08X}h")
            }
            _ => Ok(()),
        }
    }
}

/// A layout in a line: its entries and its length.
struct Row<F>(F);

impl<I: Iterator<Item = MapEntry>, F: Fn() -> I> fmt::Display for Row<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        list(f, " | ", (self.0)())?;
        let bits = sum((self.0)().map(|entry| entry.bits().into()));
        write!(f, "{}({} bytes)", if bits == 0 { "" } else { "  " }, bits.div_ceil(8))
    }
}

/// What would happen if the layout were used.
struct Effect<'e>(&'e LayoutMismatch);

impl fmt::Display for Effect<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            LayoutMismatch::Bits { expected, found, .. } => {
                let off = found.bits().abs_diff(expected.bits());
                write!(f, "every value after {} would be {off} bits off", expected.address())
            }
            LayoutMismatch::Object { position, .. } => {
                write!(f, "every value from entry {position} on would be another one")
            }
            LayoutMismatch::Missing { expected, .. } => {
                write!(f, "{} and what follows would not be exchanged", expected.address())
            }
            LayoutMismatch::Extra { .. } => f.write_str("the frame would be longer than the wanted one"),
        }
    }
}

displays! {
    [] LayoutError;
    ['r, 'p, 'm] LayoutReport<'r, 'p, 'm>;
}
