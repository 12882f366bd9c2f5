//! Process data: which bits belong to which entry, as mapping and assignment say, and the exchange of a cycle.

use crate::address::Address;
use crate::mapping::Direction;
use crate::model::{PdoDesc, Remap};
use crate::pdo::MapEntry;

use super::memory::{Memory, Slot};
use super::number::{bits, extend, low16, low32, low64, low8};

/// The most entries that are mapped in one direction.
pub const MAX_MAPPED: usize = 64;

/// Assignment of `RxPDOs`.
const RX_ASSIGN: u16 = 0x1C12;
/// Assignment of `TxPDOs`.
const TX_ASSIGN: u16 = 0x1C13;

/// The object that assigns the process data of a direction to its sync manager.
pub(crate) const fn assignment(direction: Direction) -> u16 {
    match direction {
        Direction::Rx => RX_ASSIGN,
        Direction::Tx => TX_ASSIGN,
    }
}

/// Why there is no layout: the master is refused `SafeOP`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct LayoutError(pub(crate) Direction);

/// Bits of the image.
#[derive(Clone, Copy, Debug)]
struct Field {
    slot: Slot,
    /// The first byte of those that have a bit of it.
    byte: u16,
    /// The lowest bit in that byte.
    shift: u8,
    bits: u8,
    signed: bool,
}

/// What is exchanged in one direction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layout {
    fields: [Field; MAX_MAPPED],
    used: usize,
    bits: usize,
}

impl Layout {
    /// Nothing.
    pub(crate) const EMPTY: Self = {
        let none = Field { slot: Slot::NONE, byte: 0, shift: 0, bits: 0, signed: false };
        Self { fields: [none; MAX_MAPPED], used: 0, bits: 0 }
    };

    /// What mapping and assignment say at this moment.
    pub(crate) fn of(memory: &Memory<'_, '_>, direction: Direction) -> Result<Self, LayoutError> {
        let mut layout = Self::EMPTY;
        for pdo in assigned(memory, direction) {
            let pdo = pdo.filter(|pdo| pdo.fits(memory)).ok_or(LayoutError(direction))?;
            for entry in pdo.entries(memory) {
                layout.push(memory, entry).ok_or(LayoutError(direction))?;
            }
        }
        Ok(layout)
    }

    fn push(&mut self, memory: &Memory<'_, '_>, entry: MapEntry) -> Option<()> {
        let slot = memory.slot(entry.address());
        let signed = memory.object(slot).is_some_and(|object| object.data_type().is_signed());
        let field = self.fields.get_mut(self.used)?;
        let byte = u16::try_from(self.bits >> 3).ok()?;
        *field = Field {
            slot,
            byte,
            shift: low8(i64::try_from(self.bits & 7).unwrap_or(0)),
            bits: entry.bits(),
            signed,
        };
        self.used = self.used.checked_add(1)?;
        self.bits = self.bits.checked_add(usize::from(entry.bits()))?;
        Some(())
    }

    /// Length in bytes.
    pub(crate) const fn bytes(&self) -> usize {
        self.bits.div_ceil(8)
    }

    /// Whether it has an entry.
    pub(crate) fn has(&self, slot: Slot) -> bool {
        slot.exists() && self.fields.iter().take(self.used).any(|field| field.slot == slot)
    }

    /// The first byte of an entry.
    pub(crate) fn byte_of(&self, slot: Slot) -> Option<usize> {
        let field = self.fields.iter().take(self.used).find(|field| field.slot == slot && slot.exists())?;
        Some(usize::from(field.byte))
    }

    /// Whether it has no entries but these.
    pub(crate) fn is_of(&self, slots: &[Slot]) -> bool {
        self.fields.iter().take(self.used).all(|field| !field.slot.exists() || slots.contains(&field.slot))
    }

    /// The values that `data` hold go to their entries.
    pub(crate) fn unpack(&self, memory: &mut Memory<'_, '_>, data: &[u8]) {
        for field in self.fields.iter().take(self.used) {
            memory.put(field.slot, extend(field.read(data), u32::from(field.bits), field.signed));
        }
    }

    /// The values of the entries go to `data`, which is as long as the layout.
    pub(crate) fn pack(&self, memory: &Memory<'_, '_>, data: &mut [u8]) {
        data.fill(0);
        for field in self.fields.iter().take(self.used) {
            field.write(bits(memory.now(field.slot)), data);
        }
    }
}

/// So many bytes of the image.
fn part<const N: usize>(data: &[u8], byte: u16) -> Option<[u8; N]> {
    data.get(usize::from(byte)..)?.get(..N)?.try_into().ok()
}

impl Field {
    /// Its bits, and others above them. Whole bytes are read at once.
    fn read(self, data: &[u8]) -> u64 {
        let whole = match (self.shift, self.bits) {
            (0, 32) => part(data, self.byte).map(|b| u64::from(u32::from_le_bytes(b))),
            (0, 16) => part(data, self.byte).map(|b| u64::from(u16::from_le_bytes(b))),
            (0, 8) => part(data, self.byte).map(|[b]| u64::from(b)),
            _ => None,
        };
        whole.unwrap_or_else(|| {
            let window = data.get(usize::from(self.byte)..).unwrap_or(&[]);
            let raw = window.iter().take(9).rev().fold(0_u128, |sum, byte| sum << 8 | u128::from(*byte));
            low64(raw >> (self.shift & 7))
        })
    }

    /// Writes its bits of `value`; others of the image stay.
    fn write(self, value: u64, data: &mut [u8]) {
        let window = data.get_mut(usize::from(self.byte)..).unwrap_or(&mut []);
        let bytes = value.to_le_bytes();
        match (self.shift, self.bits) {
            (0, 32) => put::<4>(window, bytes),
            (0, 16) => put::<2>(window, bytes),
            (0, 8) => put::<1>(window, bytes),
            _ => {
                let value = bits(extend(value, u32::from(self.bits), false));
                let value = u128::from(value) << (self.shift & 7);
                window.iter_mut().zip(value.to_le_bytes()).for_each(|(to, from)| *to |= from);
            }
        }
    }
}

/// Puts so many of the bytes at the start of a part of the image.
fn put<const N: usize>(window: &mut [u8], bytes: [u8; 8]) {
    window.iter_mut().take(N).zip(bytes).for_each(|(to, from)| *to = from);
}

/// Process data of the drive: a mapping object, or a row of the model.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pdo<'m> {
    index: u16,
    pub(crate) direction: Direction,
    /// What the manual says of it, or where it has no entries as the drive ships, of the first in its direction.
    about: Option<&'m PdoDesc<'m>>,
    /// As the drive ships.
    shipped: &'m [MapEntry],
}

impl<'m> Pdo<'m> {
    /// The one at `index`; `None` if there is none.
    pub(crate) fn at(memory: &Memory<'m, '_>, index: u16) -> Option<Self> {
        let own = memory.model().pdo(Address::new(index, 0));
        if let Some(own) = own {
            return Some(Self {
                index,
                direction: own.direction(),
                about: Some(own),
                shipped: own.entries(),
            });
        }
        let direction = match index {
            0x1600..=0x17FF => Direction::Rx,
            0x1A00..=0x1BFF => Direction::Tx,
            _ => return None,
        };
        let there = memory.slot(Address::new(index, 0)).exists();
        there.then(|| Self { index, direction, about: first(memory, direction), shipped: &[] })
    }

    /// What it carries at this moment: as its mapping object says, or as the drive ships where there is none.
    pub(crate) fn entries<'a>(self, memory: &'a Memory<'m, '_>) -> impl Iterator<Item = MapEntry> + 'a
    where
        'm: 'a,
    {
        let number = memory.at(Address::new(self.index, 0));
        let mapped = (1..=number.map_or(0, low8))
            .map(move |sub| MapEntry::from_word(memory.at(Address::new(self.index, sub)).map_or(0, low32)));
        mapped.chain(self.shipped.iter().copied().filter(move |_| number.is_none()))
    }

    /// The most entries that it holds; `None` where nobody says it.
    pub(crate) fn max_entries(self) -> Option<u8> {
        self.about.and_then(PdoDesc::max_entries)
    }

    /// What a master may change.
    pub(crate) fn remap(self) -> Remap {
        self.about.map_or(Remap::NotStated, PdoDesc::remap)
    }

    /// Whether what it carries is as long as it may be.
    fn fits(self, memory: &Memory<'m, '_>) -> bool {
        let bits =
            self.entries(memory).fold(0_usize, |sum, entry| sum.saturating_add(usize::from(entry.bits())));
        let most = self.about.and_then(PdoDesc::max_bytes);
        most.map_or(true, |most| bits.div_ceil(8) <= usize::from(most))
    }

    /// Whether it is assigned.
    pub(crate) fn is_assigned(self, memory: &Memory<'m, '_>) -> bool {
        assigned(memory, self.direction).flatten().any(|other| other.index == self.index)
    }
}

/// The first row of the model in a direction.
fn first<'m>(memory: &Memory<'m, '_>, direction: Direction) -> Option<&'m PdoDesc<'m>> {
    memory.model().pdos().iter().find(|pdo| pdo.direction() == direction)
}

/// The process data that are assigned, in order; `None` for one that is not there. Without an object for it, the first of
/// the model.
fn assigned<'a, 'm>(
    memory: &'a Memory<'m, '_>,
    direction: Direction,
) -> impl Iterator<Item = Option<Pdo<'m>>> + 'a {
    let index = assignment(direction);
    let number = memory.at(Address::new(index, 0));
    let listed = (1..=number.map_or(0, low8)).map(move |sub| {
        let pdo = memory.at(Address::new(index, sub)).map_or(0, low16);
        Pdo::at(memory, pdo).filter(|pdo| pdo.direction == direction)
    });
    let alone = first(memory, direction).filter(|_| number.is_none());
    listed.chain(alone.map(|pdo| Pdo::at(memory, pdo.address().index())))
}

#[cfg(test)]
mod tests {
    use super::super::memory::cells;
    use super::super::samples::{at, MODEL};
    use super::*;

    #[test]
    fn the_image_is_laid_out_as_mapped() {
        let mut cells = [0; cells(&MODEL)];
        let mut memory = Memory::new(&MODEL, &mut cells).unwrap();
        let rx = Layout::of(&memory, Direction::Rx).unwrap();
        assert_eq!(rx.bytes(), 2 + 4 + 1);
        rx.unpack(&mut memory, &[0x0F, 0x01, 0xFE, 0xFF, 0xFF, 0xFF, 0xFF]);
        let now = |memory: &Memory<'_, '_>, index| memory.now(memory.slot(at(index, 0)));
        assert_eq!((now(&memory, 0x6040), now(&memory, 0x607A), now(&memory, 0x6060)), (0x010F, -2, -1));
        let tx = Layout::of(&memory, Direction::Tx).unwrap();
        memory.put(memory.slot(at(0x6041, 0)), 0x1237);
        memory.put(memory.slot(at(0x6064, 0)), -2);
        let mut image = [0xAA; 7];
        tx.pack(&memory, &mut image);
        assert_eq!(image, [0x37, 0x12, 0xFE, 0xFF, 0xFF, 0xFF, 0]);
    }

    #[test]
    fn bits_between_bytes_are_theirs() {
        let mut cells = [0; cells(&MODEL)];
        let mut memory = Memory::new(&MODEL, &mut cells).unwrap();
        let mut layout = Layout::EMPTY;
        for (index, bits) in [(5, 3), (0x6041, 16), (0x2001, 1)] {
            layout.push(&memory, MapEntry::new(at(index, 0), bits)).unwrap();
        }
        assert_eq!(layout.bytes(), 3);
        layout.unpack(&mut memory, &[0b1010_1111, 0b0101_0101, 0b0000_1010]);
        assert_eq!(memory.now(memory.slot(at(0x6041, 0))), 0b0100_1010_1011_0101);
        assert_eq!(memory.now(memory.slot(at(0x2001, 0))), 1);
        let mut image = [0; 3];
        layout.pack(&memory, &mut image);
        assert_eq!(image, [0b1010_1000, 0b0101_0101, 0b0000_1010], "gaps are sent as 0");
    }
}
