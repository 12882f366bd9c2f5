//! SDO: what the drive answers to uploads and downloads, with the abort code that its manual has.

use crate::abort::AbortCode;
use crate::address::Address;
use crate::data_type::DataType;
use crate::model::{EsmState, ObjectDesc};

use super::aborts::listed;
use super::config::Keeps;
use super::memory::{decode, Memory, Slot};
use super::process::Layout;
use super::{history, remap, rules, store};

/// What decides a transfer besides the values.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Situation<'a> {
    pub(crate) esm: EsmState,
    /// What the drive receives, while it does.
    pub(crate) received: Option<&'a Layout>,
    /// Homing runs: its method is not changed.
    pub(crate) homing: bool,
    /// The drive is operated at its panel.
    pub(crate) local: bool,
    pub(crate) keeps: Keeps,
}

/// What a download wrote.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Written {
    pub(crate) slot: Slot,
    pub(crate) address: Address,
}

/// Why an upload has no answer in `into`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum NoUpload {
    Abort(AbortCode),
    TooLong,
}

/// Reads an entry.
pub(crate) fn upload(memory: &Memory<'_, '_>, address: Address, into: &mut [u8]) -> Result<usize, NoUpload> {
    let abort = |code| NoUpload::Abort(listed(memory.model(), code));
    let (slot, object) = find(memory, address).map_err(abort)?;
    if !object.access().reads() {
        return Err(abort(AbortCode::WRITE_ONLY));
    }
    memory.encode(slot, into).ok_or(NoUpload::TooLong)
}

/// Writes an entry.
pub(crate) fn download(
    memory: &mut Memory<'_, '_>,
    situation: &Situation<'_>,
    address: Address,
    data: &[u8],
) -> Result<Written, AbortCode> {
    let model = memory.model();
    write(memory, situation, address, data).map_err(|code| listed(model, code))
}

fn write(
    memory: &mut Memory<'_, '_>,
    situation: &Situation<'_>,
    address: Address,
    data: &[u8],
) -> Result<Written, AbortCode> {
    let (slot, object) = find(memory, address)?;
    if !object.access().writes() {
        return Err(AbortCode::READ_ONLY);
    }
    if situation.local {
        return Err(AbortCode::LOCAL_CONTROL);
    }
    let value = number(object, data)?;
    let written = Written { slot, address };
    let own = store::write(memory, address, value).or_else(|| history::write(memory, address, value));
    if let Some(done) = own {
        return done.map(|()| written);
    }
    if let Some(target) = remap::target(memory, address) {
        remap::check(memory, target, address, value, situation.esm)?;
    }
    in_range(memory, object, value)?;
    allowed_now(memory, situation, slot, address, value)?;
    memory.write(slot, value, store::keeps(memory, slot, situation.keeps));
    Ok(written)
}

fn find<'m>(memory: &Memory<'m, '_>, address: Address) -> Result<(Slot, &'m ObjectDesc<'m>), AbortCode> {
    let slot = memory.slot(address);
    if let Some(object) = memory.object(slot) {
        return Ok((slot, object));
    }
    let other = !memory.model().entries_of(address).is_empty();
    Err(if other { AbortCode::NO_SUB_INDEX } else { AbortCode::NO_OBJECT })
}

/// The number that `data` hold for this entry. Texts are not written.
fn number(object: &ObjectDesc<'_>, data: &[u8]) -> Result<i64, AbortCode> {
    let length = object.data_type().bytes();
    match data.len() {
        _ if length == 0 => Err(AbortCode::UNSUPPORTED_ACCESS),
        0 => Err(AbortCode::LENGTH),
        found if found > length => Err(AbortCode::LENGTH_TOO_HIGH),
        found if found < length => Err(AbortCode::LENGTH_TOO_LOW),
        _ => Ok(decode(object.data_type(), data)),
    }
}

/// Whether the entry takes the value at all.
fn in_range(memory: &Memory<'_, '_>, object: &ObjectDesc<'_>, value: i64) -> Result<(), AbortCode> {
    if !object.data_type().is_integer() {
        return Ok(());
    }
    let raw = widen(object.data_type(), value);
    if object.max().or(highest(object.data_type())).is_some_and(|max| raw > max) {
        return Err(AbortCode::VALUE_TOO_HIGH);
    }
    if object.min().is_some_and(|min| raw < min) {
        return Err(AbortCode::VALUE_TOO_LOW);
    }
    match memory.model().allowed_of(object) {
        Some(allowed) if !allowed.contains(&value) => Err(AbortCode::VALUE),
        _ => Ok(()),
    }
}

/// A BOOLEAN is one byte and has no more than 1; other types are as wide as their bytes.
fn highest(data_type: DataType) -> Option<i128> {
    (data_type == DataType::BOOLEAN).then_some(1)
}

/// A cell as the type sees it.
fn widen(data_type: DataType, value: i64) -> i128 {
    if data_type == DataType::UNSIGNED64 {
        i128::from(super::number::bits(value))
    } else {
        i128::from(value)
    }
}

/// Whether the entry may be written in this situation.
fn allowed_now(
    memory: &Memory<'_, '_>,
    situation: &Situation<'_>,
    slot: Slot,
    address: Address,
    value: i64,
) -> Result<(), AbortCode> {
    let blocks = memory.model().abort(AbortCode::MAPPED_IN_RX_PDO).is_some();
    if blocks && situation.received.is_some_and(|layout| layout.has(slot)) {
        return Err(AbortCode::MAPPED_IN_RX_PDO);
    }
    if situation.homing && address == HOMING_METHOD {
        return Err(AbortCode::DEVICE_STATE);
    }
    match rules::broken_by(memory, address, value).find(|rule| rules::refuses(rule)) {
        Some(_) => Err(AbortCode::VALUE),
        None => Ok(()),
    }
}

const HOMING_METHOD: Address = Address::new(0x6098, 0);

#[cfg(test)]
mod tests {
    use super::super::memory::cells;
    use super::super::samples::{at, MODEL};
    use super::*;

    const CALM: Situation<'static> = Situation {
        esm: EsmState::PreOp,
        received: None,
        homing: false,
        local: false,
        keeps: Keeps::Nothing,
    };

    /// What a download of `data` gives, as a fresh drive answers it.
    fn answer(situation: Situation<'_>, address: Address, data: &[u8]) -> Result<(), AbortCode> {
        let mut cells = [0; cells(&MODEL)];
        let mut memory = Memory::new(&MODEL, &mut cells).unwrap();
        download(&mut memory, &situation, address, data).map(|_| ())
    }

    #[test]
    fn every_mistake_has_its_code() {
        for (index, sub, data, code) in [
            (0x5FFF, 0, &[0][..], AbortCode::NO_OBJECT),
            (0x6040, 1, &[0, 0], AbortCode::NO_SUB_INDEX),
            (0x6041, 0, &[0, 0], AbortCode::READ_ONLY),
            (0x6040, 0, &[0], AbortCode::LENGTH_TOO_LOW),
            (0x6040, 0, &[0, 0, 0], AbortCode::LENGTH_TOO_HIGH),
            (0x6040, 0, &[], AbortCode::LENGTH),
            (0x6060, 0, &[2], AbortCode::VALUE),
            (0x6098, 0, &[38], AbortCode::VALUE_TOO_HIGH),
            (0x6098, 0, &[0x80], AbortCode::VALUE_TOO_LOW),
            (0x2001, 0, &[2], AbortCode::VALUE_TOO_HIGH),
        ] {
            assert_eq!(answer(CALM, at(index, sub), data), Err(code), "{index:04X}:{sub:02X} {data:?}");
        }
        assert_eq!(answer(CALM, at(0x6040, 0), &[6, 0]), Ok(()));
        let local = Situation { local: true, ..CALM };
        assert_eq!(answer(local, at(0x6040, 0), &[6, 0]), Err(AbortCode::LOCAL_CONTROL));
        let homing = Situation { homing: true, ..CALM };
        assert_eq!(answer(homing, at(0x6098, 0), &[1]), Err(AbortCode::DEVICE_STATE));
    }

    #[test]
    fn what_can_only_be_written_is_not_read() {
        let mut cells = [0; cells(&MODEL)];
        let memory = Memory::new(&MODEL, &mut cells).unwrap();
        let read = |address, room: usize| upload(&memory, address, &mut [0; 8][..room]);
        assert_eq!(read(at(0x2002, 0), 8), Err(NoUpload::Abort(AbortCode::WRITE_ONLY)));
        assert_eq!(read(at(0x6041, 0), 1), Err(NoUpload::TooLong));
        assert_eq!(read(at(0x6041, 0), 2), Ok(2));
    }

    #[test]
    fn a_mapping_is_changed_in_order_only() {
        let mut cells = [0; cells(&MODEL)];
        let mut memory = Memory::new(&MODEL, &mut cells).unwrap();
        let mut write = |index, sub, value: u32, bytes: usize| {
            download(&mut memory, &CALM, at(index, sub), &value.to_le_bytes()[..bytes]).map(|_| ())
        };
        let early = Err(AbortCode::SUB_INDEX_0_NOT_ZERO);
        assert_eq!(write(0x1A00, 0, 0, 1), early, "it is assigned");
        assert_eq!(write(0x1A00, 1, 0x6041_0010, 4), early);
        assert_eq!(write(0x1C13, 0, 0, 1), Ok(()));
        assert_eq!(write(0x1A00, 1, 0x6041_0010, 4), early, "it has entries");
        assert_eq!(write(0x1A00, 0, 0, 1), Ok(()));
        assert_eq!(write(0x1A00, 1, 0x6040_0010, 4), Err(AbortCode::NOT_MAPPABLE), "only received");
        assert_eq!(write(0x1A00, 1, 0x6041_0008, 4), Err(AbortCode::NOT_MAPPABLE), "it has 16 bits");
        assert_eq!(write(0x1A00, 1, 0x5FFF_0010, 4), Err(AbortCode::NO_OBJECT));
        assert_eq!(write(0x1A00, 1, 0x606C_0020, 4), Ok(()));
        assert_eq!(write(0x1A00, 0, 9, 1), Err(AbortCode::PDO_LENGTH), "it holds 8");
        assert_eq!(write(0x1A00, 0, 8, 1), Err(AbortCode::NOT_MAPPABLE), "the last ones are empty");
        assert_eq!(write(0x1A00, 0, 1, 1), Ok(()));
        assert_eq!(write(0x1C13, 1, 0x1600, 2), Err(AbortCode::VALUE), "the other direction");
        assert_eq!(write(0x1C13, 1, 0x1A00, 2), Ok(()));
        assert_eq!(write(0x1C13, 0, 1, 1), Ok(()));
        assert_eq!(write(0x1C13, 1, 0x1A00, 2), early);
        let op = Situation { esm: EsmState::Op, ..CALM };
        let last = download(&mut memory, &op, at(0x1C13, 0), &[0]);
        assert_eq!(last, Err(AbortCode::DEVICE_STATE));
    }
}
