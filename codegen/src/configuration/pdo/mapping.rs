//! What a PDO carries: the objects 1600h and 1A00h.

use super::{Mapping, Pdo};
use crate::configuration::code;
use crate::configuration::setting::{Setting, object, taken};
use crate::diag::{Diagnostic, Sink};
use crate::limits;
use crate::model::{Address, Direction, Entry, Fact, Model};
use crate::rows::tables::MappedRow;
use crate::source::{Sp, Span};

/// Bytes of a CAN frame.
const FRAME: u32 = 8;

/// The mapping that rows of one PDO say.
pub(super) fn check(pdo: &Pdo, rows: &[&MappedRow], model: &Model, sink: &mut Sink) -> Option<Mapping> {
    let last = rows.last()?.entry.span;
    let (_, count) = model.entry(Address::new(pdo.index, 0))?;
    if !count.access.value.writes() {
        fixed(count, rows.first()?.map.span, sink);
        return None;
    }
    few_enough(pdo, rows, model, sink)?;
    let mapped: Vec<Option<(&Entry, u8)>> =
        rows.iter().map(|row| carried(row.entry, pdo.direction, model, sink)).collect();
    short_enough(pdo, rows, &mapped, model, sink);
    let mut words = Vec::new();
    for ((row, mapped), sub) in rows.iter().zip(&mapped).zip(1..) {
        let Some((entry, bits)) = mapped else { continue };
        words.extend(word(Address::new(pdo.index, sub), entry.address, *bits, row.entry.span, model, sink));
    }
    let entries = mapped.iter().flatten().map(|(entry, _)| entry.address).collect();
    let count = taken(count, Sp::new(rows.len() as i128, last), sink)?;
    Some(Mapping { count, words, entries })
}

fn fixed(entry: &Entry, span: Span, sink: &mut Sink) {
    let text = format!("{} is {}", entry.address, entry.access.value.word());
    sink.push(
        Diagnostic::new(code::MAPPING_FIXED, span, text)
            .related(entry.access.span(), "its access")
            .why("the drive maps this PDO as its maker did")
            .help("use a PDO whose mapping can be written, or the objects that this one carries"),
    );
}

/// Whether the drive can map so many entries.
fn few_enough(pdo: &Pdo, rows: &[&MappedRow], model: &Model, sink: &mut Sink) -> Option<()> {
    let limit = model.drive.limits.pdo_entries.as_ref();
    let stated = limit.map_or(usize::MAX, |limit| limit.value.into());
    let object = model.object(pdo.index)?;
    let there = object.entries.iter().filter(|id| model.entries[**id].address.sub > 0).count();
    let most = stated.min(there);
    let Some(first) = rows.get(most) else { return Some(()) };
    let text = format!("{:04X}h would carry {} entries", pdo.index, rows.len());
    let mut finding = Diagnostic::new(code::TOO_MANY_MAPPED, first.entry.span, text)
        .why(format!("the drive can map {most}, and would refuse more with abort 0604 0042"))
        .help("leave entries out, or use another PDO");
    if let Some(limit) = limit.filter(|_| stated <= there) {
        finding = finding.related(limit.span(), "the limit");
    }
    sink.push(finding);
    None
}

/// The entry with its width, if a PDO of this direction can carry it.
fn carried<'m>(
    at: Sp<Address>,
    direction: Direction,
    model: &'m Model,
    sink: &mut Sink,
) -> Option<(&'m Entry, u8)> {
    let entry = object(at, model, sink)?;
    let mapping = entry.mapping.as_ref();
    let pdo = if direction == Direction::Rx { "an RxPDO" } else { "a TxPDO" };
    let (fact, text) = if !mapping.is_some_and(|m| m.value.has(direction)) {
        let says = mapping.map_or("not stated", |m| m.value.word());
        (mapping.map_or(entry.name.span(), Fact::span), format!("whose mapping is {says}"))
    } else if !entry.access.value.carries(direction) {
        (entry.access.span(), format!("whose access is {}", entry.access.value.word()))
    } else if let Some(bits) = entry.ty.value.bits() {
        return Some((entry, bits));
    } else {
        (entry.ty.span(), format!("whose type {} has no fixed width", entry.ty.value))
    };
    let text = format!("{pdo} cannot carry {} ({}), {text}", entry.address, entry.name.value);
    sink.push(
        Diagnostic::new(code::NOT_MAPPABLE, at.span, text)
            .related(fact, "the object")
            .why("the drive would refuse the mapping with abort 0604 0041")
            .help("leave it out; a status goes into a TxPDO, a command into an RxPDO"),
    );
    None
}

/// Reports the first entry with which a PDO is longer than the drive or the bus allows.
fn short_enough(
    pdo: &Pdo,
    rows: &[&MappedRow],
    mapped: &[Option<(&Entry, u8)>],
    model: &Model,
    sink: &mut Sink,
) {
    let bus = if model.on_can() { FRAME } else { limits::PDO_BYTES };
    let limit = model.drive.limits.pdo_bytes.as_ref().filter(|limit| u32::from(limit.value) <= bus);
    let most = limit.map_or(bus, |limit| limit.value.into());
    let ends = mapped.iter().scan(0, |bits, mapped| {
        *bits += mapped.map_or(0, |(_, bits)| u32::from(bits));
        Some(*bits)
    });
    let ends: Vec<u32> = ends.collect();
    let Some(beyond) = ends.iter().position(|bits| bits.div_ceil(8) > most) else { return };
    let all = ends.last().map_or(0, |bits| bits.div_ceil(8));
    let by = if limit.is_some() { "the drive" } else { "a frame" };
    let text = format!("{:04X}h would have {all} bytes", pdo.index);
    let mut finding = Diagnostic::new(code::PDO_TOO_LONG, rows[beyond].entry.span, text)
        .label("from here on")
        .why(format!("{by} carries {most} bytes, and the mapping would be refused with abort 0604 0042"))
        .help("leave entries out, or use another PDO");
    if let Some(limit) = limit {
        finding = finding.related(limit.span(), "the limit");
    }
    sink.push(finding);
}

/// The mapping word of an entry.
fn word(
    at: Address,
    entry: Address,
    bits: u8,
    span: Span,
    model: &Model,
    sink: &mut Sink,
) -> Option<Setting> {
    let word = i128::from(entry.index) << 16 | i128::from(entry.sub) << 8 | i128::from(bits);
    let place = object(Sp::new(at, span), model, sink)?;
    if !place.access.value.writes() {
        fixed(place, span, sink);
        return None;
    }
    taken(place, Sp::new(word, span), sink)
}
