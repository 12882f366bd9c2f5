//! Process data as the drive has them mapped at this moment: what a master sends and what it reads.

use drivewright_runtime::Address;
use drivewright_runtime::mapping::Direction;
use drivewright_runtime::pdo::{MapEntry, byte_len};
use drivewright_runtime::sim::VirtualDrive;

/// What is exchanged in a direction, in order.
pub(crate) fn mapped(drive: &VirtualDrive<'_, '_>, direction: Direction) -> Vec<MapEntry> {
    let assignment = if direction == Direction::Rx { 0x1C12 } else { 0x1C13 };
    let number = |index, sub| drive.value(Address::new(index, sub)).and_then(|n| u32::try_from(n).ok());
    let first = drive.model().pdos().iter().find(|pdo| pdo.direction() == direction);
    let first = || first.map(|pdo| pdo.address().index()).into_iter().collect();
    let listed = |n| (1..=sub(n)).filter_map(|n| number(assignment, n)?.try_into().ok()).collect();
    let pdos: Vec<u16> = number(assignment, 0).map_or_else(first, listed);
    let entries = |pdo: u16| -> Vec<MapEntry> {
        match number(pdo, 0) {
            Some(n) => (1..=sub(n)).filter_map(|n| number(pdo, n)).map(MapEntry::from_word).collect(),
            None => drive.model().pdo(Address::new(pdo, 0)).map_or(Vec::new(), |pdo| pdo.entries().to_vec()),
        }
    };
    pdos.into_iter().flat_map(entries).collect()
}

fn sub(n: u32) -> u8 {
    u8::try_from(n).unwrap_or(u8::MAX)
}

/// Lays values out, the lowest bit first.
pub(crate) fn pack(entries: &[MapEntry], value: impl Fn(Address) -> i128) -> Vec<u8> {
    let mut frame = vec![0; byte_len(entries)];
    let mut at = 0;
    for entry in entries {
        let value = value(entry.address());
        for bit in 0..usize::from(entry.bits()) {
            let set = value >> bit.min(127) & 1 != 0;
            if let Some(byte) = frame.get_mut((at + bit) / 8).filter(|_| set) {
                *byte |= 1 << ((at + bit) % 8);
            }
        }
        at += usize::from(entry.bits());
    }
    frame
}

/// The numbers of a frame. `signed` says which entries have a sign.
pub(crate) fn unpack(
    entries: &[MapEntry],
    frame: &[u8],
    signed: impl Fn(Address) -> bool,
) -> Vec<(Address, i128)> {
    let mut at = 0;
    let mut values = Vec::new();
    for entry in entries {
        let bits = usize::from(entry.bits());
        let bit = |n: usize| frame.get(n / 8).map_or(0, |byte| i128::from(byte >> (n % 8) & 1));
        let raw: i128 = (0..bits.min(64)).map(|n| bit(at + n) << n).sum();
        let negative = signed(entry.address()) && bits > 0 && bit(at + bits - 1) != 0;
        values.push((entry.address(), if negative { raw - (1 << bits.min(64)) } else { raw }));
        at += bits;
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_come_back() {
        let at = |index| Address::new(index, 0);
        let entries = [MapEntry::new(at(1), 3), MapEntry::new(at(2), 16), MapEntry::new(at(3), 5)];
        let frame = pack(&entries, |address| if address == at(2) { -2 } else { 0b101 });
        // 101, then sixteen bits of -2 with the lowest first, then 00101.
        assert_eq!(frame, [0b1111_0101, 0b1111_1111, 0b0010_1111]);
        let values = unpack(&entries, &frame, |address| address == at(2));
        assert_eq!(values, [(at(1), 5), (at(2), -2), (at(3), 5)]);
    }
}
