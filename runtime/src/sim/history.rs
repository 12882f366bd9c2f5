//! The error history, 1003h: the codes of the alarms that came, the latest first.

use crate::abort::AbortCode;
use crate::address::Address;
use crate::model::AlarmDesc;

use super::memory::Memory;

const HISTORY: u16 = 0x1003;

const fn at(sub: u8) -> Address {
    Address::new(HISTORY, sub)
}

/// Adds an alarm: its code below, its auxiliary code above. The oldest falls out where the drive has no more entries.
pub(crate) fn add(memory: &mut Memory<'_, '_>, alarm: &AlarmDesc<'_>) {
    let count = memory.slot(at(0));
    if !count.exists() {
        return;
    }
    let mut next = i64::from(u32::from(alarm.aux().unwrap_or(0)) << 16 | u32::from(alarm.code()));
    let mut entries = 0;
    for sub in 1..=u8::MAX {
        let slot = memory.slot(at(sub));
        if !slot.exists() || next == 0 {
            break;
        }
        let moved = memory.now(slot);
        memory.put(slot, next);
        (next, entries) = (moved, i64::from(sub));
    }
    memory.put(count, entries);
}

/// What a write to `address` does if it is the number of entries: 0 clears the history, nothing else is taken. `None` for
/// other objects.
pub(crate) fn write(
    memory: &mut Memory<'_, '_>,
    address: Address,
    value: i64,
) -> Option<Result<(), AbortCode>> {
    if address != at(0) {
        return None;
    }
    if value != 0 {
        return Some(Err(AbortCode::VALUE_TOO_HIGH));
    }
    for sub in 0..=u8::MAX {
        let slot = memory.slot(at(sub));
        memory.put(slot, 0);
    }
    Some(Ok(()))
}

#[cfg(test)]
mod tests {
    use super::super::memory::cells;
    use super::super::samples::MODEL;
    use super::*;

    #[test]
    fn the_latest_is_the_first() {
        let mut cells = [0; cells(&MODEL)];
        let mut memory = Memory::new(&MODEL, &mut cells).unwrap();
        let read = |memory: &Memory<'_, '_>| [0, 1, 2].map(|sub| memory.now(memory.slot(at(sub))));
        for (number, seen) in [
            (("OF", 0x25), [1, 0x8611, 0]),
            (("ET", 0x06), [2, 0x7305, 0x8611]),
            (("OL", 0x0F), [2, 0x2350, 0x7305]),
        ] {
            add(&mut memory, MODEL.alarm(number.0, number.1).unwrap());
            assert_eq!(read(&memory), seen);
        }
        assert_eq!(write(&mut memory, at(0), 1), Some(Err(AbortCode::VALUE_TOO_HIGH)));
        assert_eq!(write(&mut memory, at(0), 0), Some(Ok(())));
        assert_eq!(read(&memory), [0, 0, 0]);
        assert_eq!(write(&mut memory, at(1), 0), None);
    }
}
