//! The values of a drive: one cell of the caller's memory for each thing that the drive knows about an entry.
//!
//! There are three planes. *Now* is what an upload reads. *Used* is what the drive acts on, which is another value while
//! one that was written waits for the next standstill or power cycle. *Kept* is what survives when the supply is off.

use crate::address::Address;
use crate::data_type::DataType;
use crate::model::{DefaultValue, DriveModel, Effect, ObjectDesc};

use super::number::{bits, cell, extend};

/// Planes of the memory.
const PLANES: usize = 3;

/// How many cells a virtual drive of this model needs.
///
/// ```
/// use drivewright_runtime::model::{DriveModel, Identity};
///
/// assert_eq!(drivewright_runtime::sim::cells(&DriveModel::new(Identity::new("x", "y", "z"))), 0);
/// ```
pub const fn cells(model: &DriveModel<'_>) -> usize {
    cells_for(model.objects().len())
}

/// How many cells a virtual drive with so many entries needs: [`cells`] for a constant, which must not look into a static.
pub const fn cells_for(entries: usize) -> usize {
    entries.saturating_mul(PLANES)
}

/// There are fewer cells than the model needs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct SpaceError {
    /// Cells that the model needs: [`cells`].
    pub needed: usize,
    /// Cells that there are.
    pub found: usize,
}

impl core::fmt::Display for SpaceError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "the drive needs {} cells of memory, there are {}", self.needed, self.found)
    }
}

impl core::error::Error for SpaceError {}

/// The place of an entry in the table of the model: what a look-up gives, kept so that a cycle looks nothing up.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Slot(u16);

impl Slot {
    /// No entry: reads as 0, and what is written to it is lost.
    pub(crate) const NONE: Self = Self(u16::MAX);

    const fn place(self) -> usize {
        self.0 as usize
    }

    /// Whether there is an entry.
    pub(crate) const fn exists(self) -> bool {
        self.0 != Self::NONE.0
    }
}

/// The values of a drive.
#[derive(Debug)]
pub(crate) struct Memory<'m, 's> {
    model: &'m DriveModel<'m>,
    now: &'s mut [i64],
    used: &'s mut [i64],
    kept: &'s mut [i64],
    /// A value waits for the next standstill.
    waits: bool,
}

impl<'m, 's> Memory<'m, 's> {
    /// The values as the drive ships.
    pub(crate) fn new(model: &'m DriveModel<'m>, memory: &'s mut [i64]) -> Result<Self, SpaceError> {
        let (needed, found) = (cells(model), memory.len());
        let each = model.objects().len();
        if found < needed {
            return Err(SpaceError { needed, found });
        }
        let (now, rest) = memory.split_at_mut_checked(each).unwrap_or_default();
        let (used, rest) = rest.split_at_mut_checked(each).unwrap_or_default();
        let kept = rest.get_mut(..each).unwrap_or_default();
        let mut memory = Self { model, now, used, kept, waits: false };
        memory.restore(|_| true);
        memory.power_up();
        Ok(memory)
    }

    pub(crate) fn model(&self) -> &'m DriveModel<'m> {
        self.model
    }

    /// Where the entry at `address` is; [`Slot::NONE`] if there is none.
    pub(crate) fn slot(&self, address: Address) -> Slot {
        let found = self.model.objects().binary_search_by_key(&address, ObjectDesc::address);
        found.ok().and_then(|at| u16::try_from(at).ok()).map_or(Slot::NONE, Slot)
    }

    pub(crate) fn object(&self, slot: Slot) -> Option<&'m ObjectDesc<'m>> {
        self.model.objects().get(slot.place())
    }

    /// What an upload reads; 0 where there is no entry.
    pub(crate) fn now(&self, slot: Slot) -> i64 {
        self.now.get(slot.place()).copied().unwrap_or(0)
    }

    /// What the drive acts on; 0 where there is no entry.
    pub(crate) fn used(&self, slot: Slot) -> i64 {
        self.used.get(slot.place()).copied().unwrap_or(0)
    }

    /// What the drive acts on, or `default` where there is no entry.
    pub(crate) fn used_or(&self, slot: Slot, default: i64) -> i64 {
        self.used.get(slot.place()).copied().unwrap_or(default)
    }

    /// What the drive acts on, by address.
    pub(crate) fn at(&self, address: Address) -> Option<i64> {
        self.used.get(self.slot(address).place()).copied()
    }

    /// A value that the drive reports, or receives as process data: it counts at once.
    pub(crate) fn put(&mut self, slot: Slot, value: i64) {
        if let (Some(now), Some(used)) = (self.now.get_mut(slot.place()), self.used.get_mut(slot.place())) {
            (*now, *used) = (value, value);
        }
    }

    /// A value that a master writes: it counts when the manual says.
    pub(crate) fn write(&mut self, slot: Slot, value: i64, keep: bool) {
        let effect = self.object(slot).and_then(|object| self.model.effect_of(object.address()));
        if let Some(now) = self.now.get_mut(slot.place()) {
            *now = value;
        }
        if keep {
            self.keep(slot);
        }
        match effect {
            Some(Effect::PowerCycle) => self.keep(slot),
            Some(Effect::AtStop) => self.waits = true,
            _ => self.put(slot, value),
        }
    }

    /// What an upload reads survives when the supply is off.
    pub(crate) fn keep(&mut self, slot: Slot) {
        if let (Some(kept), Some(now)) = (self.kept.get_mut(slot.place()), self.now.get(slot.place())) {
            *kept = *now;
        }
    }

    /// The axis stands: what waited for that counts.
    pub(crate) fn standstill(&mut self) {
        if !core::mem::take(&mut self.waits) {
            return;
        }
        for row in self.model.effects().iter().filter(|row| row.effect() == Effect::AtStop) {
            let slot = self.slot(row.address());
            self.put(slot, self.now(slot));
        }
    }

    /// Keeps every value that `which` names.
    pub(crate) fn save(&mut self, which: impl Fn(Address) -> bool) {
        for ((object, kept), now) in self.model.objects().iter().zip(&mut *self.kept).zip(&*self.now) {
            if which(object.address()) {
                *kept = *now;
            }
        }
    }

    /// Makes the values as the drive ships those that are kept, of every entry that `which` names. They count after the
    /// next power cycle.
    pub(crate) fn restore(&mut self, which: impl Fn(Address) -> bool) {
        for (object, kept) in self.model.objects().iter().zip(&mut *self.kept) {
            if which(object.address()) {
                *kept = default(self.model, object);
            }
        }
    }

    /// The supply comes on: what was kept is there, the rest is gone.
    pub(crate) fn power_up(&mut self) {
        for ((now, used), kept) in self.now.iter_mut().zip(&mut *self.used).zip(&*self.kept) {
            (*now, *used) = (*kept, *kept);
        }
        self.waits = false;
    }

    /// Writes what an upload reads; `None` where it does not fit `into`.
    pub(crate) fn encode(&self, slot: Slot, into: &mut [u8]) -> Option<usize> {
        let object = self.object(slot)?;
        let number = bits(self.now(slot)).to_le_bytes();
        let data: &[u8] = match self.model.default_of(object) {
            DefaultValue::Text(text) => text.as_bytes(),
            _ => number.get(..object.data_type().bytes()).unwrap_or(&[]),
        };
        let room = into.get_mut(..data.len())?;
        room.iter_mut().zip(data).for_each(|(to, from)| *to = *from);
        Some(data.len())
    }
}

/// The value of an entry as the drive ships. Where the manual states none it is the one nearest to 0 in the range, and
/// for the number of entries of a PDO as many as the manual lists.
fn default(model: &DriveModel<'_>, object: &ObjectDesc<'_>) -> i64 {
    let nearest = || 0.max(object.min().unwrap_or(0)).min(object.max().unwrap_or(i128::MAX));
    let pdo = model.pdo(object.address()).filter(|_| object.address().sub() == 0);
    let entries = pdo.and_then(|pdo| i128::try_from(pdo.entries().len()).ok());
    cell(object.default_value().or(entries).unwrap_or_else(nearest))
}

/// The number that `data` hold, little endian, for a type of at most 8 bytes.
pub(crate) fn decode(data_type: DataType, data: &[u8]) -> i64 {
    let raw = data.iter().rev().fold(0_u64, |sum, byte| sum << 8 | u64::from(*byte));
    let width = u32::try_from(data.len()).map_or(64, |n| n.saturating_mul(8));
    extend(raw, width, data_type.is_signed())
}

#[cfg(test)]
mod tests {
    use super::super::samples::{at, MODEL};
    use super::*;

    #[test]
    fn too_little_memory_is_refused() {
        let mut memory = [0; 8];
        let needed = cells(&MODEL);
        assert_eq!(Memory::new(&MODEL, &mut memory).unwrap_err(), SpaceError { needed, found: 8 });
    }

    #[test]
    fn a_power_cycle_keeps_what_is_kept() {
        let mut cells = [0; cells(&MODEL)];
        let mut memory = Memory::new(&MODEL, &mut cells).unwrap();
        let (speed, ramp) = (memory.slot(at(0x6081, 0)), memory.slot(at(0x6083, 0)));
        assert_eq!((memory.now(speed), memory.now(ramp)), (0, 100));
        memory.write(speed, 300, false);
        memory.write(ramp, 50, true);
        memory.power_up();
        assert_eq!((memory.used(speed), memory.used(ramp)), (0, 50));
        memory.restore(|_| true);
        assert_eq!(memory.used(ramp), 50, "a restore waits for the next power cycle");
        memory.power_up();
        assert_eq!(memory.used(ramp), 100);
    }

    #[test]
    fn values_wait_for_what_the_manual_says() {
        let mut cells = [0; cells(&MODEL)];
        let mut memory = Memory::new(&MODEL, &mut cells).unwrap();
        let (stop, cycle) = (memory.slot(at(0x2000, 1)), memory.slot(at(0x2000, 2)));
        memory.write(stop, 7, false);
        memory.write(cycle, 8, false);
        assert_eq!((memory.now(stop), memory.used(stop)), (7, 0));
        memory.standstill();
        assert_eq!((memory.used(stop), memory.now(cycle), memory.used(cycle)), (7, 8, 0));
        memory.power_up();
        assert_eq!((memory.used(stop), memory.used(cycle)), (0, 8));
    }

    #[test]
    fn numbers_and_texts_are_bytes() {
        let mut cells = [0; cells(&MODEL)];
        let memory = Memory::new(&MODEL, &mut cells).unwrap();
        let mut out = [0; 8];
        let read = |slot, out: &mut [u8]| memory.encode(slot, out);
        assert_eq!((read(memory.slot(at(0x1008, 0)), &mut out), &out[..2]), (Some(2), &b"X3"[..]));
        assert_eq!(read(memory.slot(at(0x6083, 0)), &mut out[..3]), None);
        assert_eq!((read(memory.slot(at(0x6083, 0)), &mut out), &out[..4]), (Some(4), &[100, 0, 0, 0][..]));
        assert_eq!(read(Slot::NONE, &mut out), None);
        assert_eq!(decode(DataType::INTEGER16, &[0xFE, 0xFF]), -2);
        assert_eq!(decode(DataType::UNSIGNED16, &[0xFE, 0xFF]), 65_534);
    }
}
