//! What may be written to mapping and assignment objects, in which order.

use crate::abort::AbortCode;
use crate::address::Address;
use crate::mapping::Direction;
use crate::model::{EsmState, Remap};
use crate::pdo::MapEntry;

use super::memory::Memory;
use super::number::{low16, low32, low8};
use super::process::{assignment, Pdo};

/// An object that says what process data are.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Target<'m> {
    /// What a PDO carries.
    Mapping(Pdo<'m>),
    /// Which PDOs are used.
    Assignment(Direction),
}

/// What `address` is, if it belongs to process data.
pub(crate) fn target<'m>(memory: &Memory<'m, '_>, address: Address) -> Option<Target<'m>> {
    let index = address.index();
    let direction = [Direction::Rx, Direction::Tx].into_iter().find(|d| assignment(*d) == index);
    direction.map(Target::Assignment).or_else(|| Pdo::at(memory, index).map(Target::Mapping))
}

/// Whether `value` may be written: only in `PreOP`, and entries only while there is nothing that uses them.
pub(crate) fn check<'m>(
    memory: &Memory<'m, '_>,
    target: Target<'m>,
    address: Address,
    value: i64,
    esm: EsmState,
) -> Result<(), AbortCode> {
    if esm != EsmState::PreOp {
        return Err(AbortCode::DEVICE_STATE);
    }
    match (target, address.sub()) {
        (Target::Mapping(pdo), sub) => {
            mapping_is_free(memory, pdo)?;
            if sub == 0 {
                number_of_entries(memory, pdo, address.index(), low8(value))
            } else {
                sub_index_0_is_zero(memory, address)?;
                entry(memory, pdo.direction, MapEntry::from_word(low32(value)))
            }
        }
        (Target::Assignment(direction), 0) => number_of_pdos(memory, direction, low8(value)),
        (Target::Assignment(direction), _) => {
            sub_index_0_is_zero(memory, address)?;
            assignable(memory, direction, value)
        }
    }
}

fn sub_index_0_is_zero(memory: &Memory<'_, '_>, address: Address) -> Result<(), AbortCode> {
    match memory.at(Address::new(address.index(), 0)) {
        Some(0) => Ok(()),
        _ => Err(AbortCode::SUB_INDEX_0_NOT_ZERO),
    }
}

/// The mapping of a PDO that is assigned is in use.
fn mapping_is_free<'m>(memory: &Memory<'m, '_>, pdo: Pdo<'m>) -> Result<(), AbortCode> {
    if matches!(pdo.remap(), Remap::Fixed | Remap::Selectable) {
        Err(AbortCode::UNSUPPORTED_ACCESS)
    } else if pdo.is_assigned(memory) {
        Err(AbortCode::SUB_INDEX_0_NOT_ZERO)
    } else {
        Ok(())
    }
}

/// An entry that the drive can map in this direction, with the length of its type; or nothing.
fn entry(memory: &Memory<'_, '_>, direction: Direction, entry: MapEntry) -> Result<(), AbortCode> {
    if entry.word() == 0 || is_gap(entry) {
        return Ok(());
    }
    let object = memory.object(memory.slot(entry.address())).ok_or(AbortCode::NO_OBJECT)?;
    let mappable = object.mapping().allows(direction) == Some(true);
    let whole = object.data_type().bits() == u16::from(entry.bits());
    (mappable && whole).then_some(()).ok_or(AbortCode::NOT_MAPPABLE)
}

/// A gap is a type of CiA 301 in place of an object.
fn is_gap(entry: MapEntry) -> bool {
    let data_type = crate::DataType(low8(i64::from(entry.address().index())));
    entry.address().index() < 0x20 && data_type.bits() == u16::from(entry.bits()) && entry.bits() != 0
}

/// As many entries as the PDO can hold, and each of them something.
fn number_of_entries(memory: &Memory<'_, '_>, pdo: Pdo<'_>, index: u16, number: u8) -> Result<(), AbortCode> {
    if pdo.max_entries().is_some_and(|most| number > most) {
        return Err(AbortCode::PDO_LENGTH);
    }
    let word = |sub| memory.at(Address::new(index, sub));
    if (1..=number).any(|sub| word(sub).is_none()) {
        return Err(AbortCode::PDO_LENGTH);
    }
    (1..=number).all(|sub| word(sub) != Some(0)).then_some(()).ok_or(AbortCode::NOT_MAPPABLE)
}

/// A PDO of this direction.
fn assignable(memory: &Memory<'_, '_>, direction: Direction, value: i64) -> Result<(), AbortCode> {
    let pdo = Pdo::at(memory, low16(value));
    pdo.filter(|pdo| pdo.direction == direction).map(|_| ()).ok_or(AbortCode::VALUE)
}

/// Each of the first `number` is a PDO of this direction, and none comes twice.
fn number_of_pdos(memory: &Memory<'_, '_>, direction: Direction, number: u8) -> Result<(), AbortCode> {
    let index = assignment(direction);
    let assigned = |sub| memory.at(Address::new(index, sub));
    for sub in 1..=number {
        let value = assigned(sub).ok_or(AbortCode::PDO_LENGTH)?;
        assignable(memory, direction, value)?;
        if (1..sub).any(|earlier| assigned(earlier) == Some(value)) {
            return Err(AbortCode::VALUE);
        }
    }
    Ok(())
}
