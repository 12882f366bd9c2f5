//! Store and restore parameters, 1010h and 1011h, and what is kept without them.

use crate::abort::AbortCode;
use crate::address::Address;

use super::config::Keeps;
use super::memory::{Memory, Slot};
use super::number::low32;

const STORE: u16 = 0x1010;
const RESTORE: u16 = 0x1011;
/// `save`, as it is on the wire.
const SAVE: u32 = 0x6576_6173;
/// `load`, as it is on the wire.
const LOAD: u32 = 0x6461_6F6C;

/// The entries that a sub-index of 1010h and 1011h names: all, communication, application, the maker's.
fn group(sub: u8) -> fn(Address) -> bool {
    match sub {
        2 => |at| matches!(at.index(), 0x1000..=0x1FFF),
        3 => |at| matches!(at.index(), 0x6000..=0x9FFF),
        4.. => |at| matches!(at.index(), 0x2000..=0x5FFF),
        _ => |_| true,
    }
}

/// What a write to `address` does if it is one of these objects: it saves or restores with the right signature, and is
/// refused with another. `None` for other objects.
pub(crate) fn write(
    memory: &mut Memory<'_, '_>,
    address: Address,
    value: i64,
) -> Option<Result<(), AbortCode>> {
    let which = group(address.sub());
    match (address.index(), address.sub(), low32(value)) {
        (STORE | RESTORE, 0, _) => None,
        (STORE, _, SAVE) => {
            memory.save(which);
            Some(Ok(()))
        }
        (RESTORE, _, LOAD) => {
            memory.restore(which);
            Some(Ok(()))
        }
        (STORE | RESTORE, ..) => Some(Err(AbortCode::NOT_STORED)),
        _ => None,
    }
}

/// Whether a value is kept as it is written.
pub(crate) fn keeps(memory: &Memory<'_, '_>, slot: Slot, keeps: Keeps) -> bool {
    let Some(object) = memory.object(slot) else { return false };
    let stores = memory.slot(Address::new(STORE, 1)).exists();
    match keeps {
        Keeps::MakerRange => !stores && matches!(object.address().index(), 0x2000..=0x5FFF),
        Keeps::Everything => !stores,
        Keeps::Nothing => false,
    }
}

#[cfg(test)]
mod tests {
    use super::super::memory::cells;
    use super::super::samples::{at, MODEL};
    use super::*;

    #[test]
    fn only_the_signature_stores() {
        let mut cells = [0; cells(&MODEL)];
        let mut memory = Memory::new(&MODEL, &mut cells).unwrap();
        let ramp = memory.slot(at(0x6083, 0));
        memory.write(ramp, 50, keeps(&memory, ramp, Keeps::Everything));
        assert_eq!(write(&mut memory, at(0x1010, 1), 1), Some(Err(AbortCode::NOT_STORED)));
        memory.power_up();
        assert_eq!(memory.now(ramp), 100, "it has 1010h, so nothing is kept by itself");
        memory.write(ramp, 50, false);
        assert_eq!(write(&mut memory, at(0x1010, 3), i64::from(u32::from_le_bytes(*b"save"))), Some(Ok(())));
        memory.power_up();
        assert_eq!(memory.now(ramp), 50);
        assert_eq!(write(&mut memory, at(0x1011, 1), i64::from(u32::from_le_bytes(*b"load"))), Some(Ok(())));
        memory.power_up();
        assert_eq!((memory.now(ramp), write(&mut memory, at(0x6083, 0), 5)), (100, None));
    }
}
