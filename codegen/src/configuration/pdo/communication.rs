//! When and under which identifier a PDO goes over the bus: the objects 1400h and 1800h.

use super::{CobId, Pdo};
use crate::configuration::code;
use crate::configuration::setting::{Setting, object, taken};
use crate::diag::{Diagnostic, Sink};
use crate::model::{Address, Direction, Entry, Model};
use crate::rows::tables::CommunicationRow;
use crate::source::Sp;

/// Bit 31 of a COB-ID: the PDO is off.
const OFF: i128 = 1 << 31;
/// Bit 30 of a COB-ID of a `TxPDO`: nobody may ask for it by a remote frame.
const NO_RTR: i128 = 1 << 30;
/// Bits of an identifier of a base frame.
const BASE: i128 = 0x7FF;
/// Identifiers that CiA 301 keeps for other services.
const RESERVED: &[(u32, u32)] =
    &[(0x000, 0x07F), (0x101, 0x180), (0x581, 0x5FF), (0x601, 0x67F), (0x6E0, 0x6FF), (0x701, u32::MAX)];

/// Adds what the rows say about the communication of a PDO.
pub(super) fn check(
    pdo: &mut Pdo,
    map: Sp<u16>,
    row: Option<&CommunicationRow>,
    node_id: u8,
    model: &Model,
    sink: &mut Sink,
) {
    let at = |sub| Address::new(pdo.index - 0x200, sub);
    let row = row.filter(|row| has_communication(row, model, sink));
    pdo.cob_id = cob_id(pdo.direction, at(1), map, row, node_id, model, sink);
    let Some(row) = row else { return };
    row.transmission.iter().for_each(|ty| transmission(*ty, pdo.direction, sink));
    let values = [
        (2, row.transmission.map(|value| value.map(i128::from))),
        (3, row.inhibit.map(|value| value.map(i128::from))),
        (5, row.event.map(|value| value.map(i128::from))),
    ];
    for (sub, value) in values.into_iter().filter_map(|(sub, value)| Some((sub, value?))) {
        let entry = object(Sp::new(at(sub), value.span), model, sink);
        pdo.settings.extend(entry.and_then(|entry| taken(entry, value, sink)));
    }
}

/// Whether PDOs of the drive have an identifier and timers: they do on a CAN bus.
fn has_communication(row: &CommunicationRow, model: &Model, sink: &mut Sink) -> bool {
    if !model.on_can() {
        let text = format!("the drive has no communication parameters of {:04X}h", row.map.value);
        sink.push(
            Diagnostic::new(code::NO_OBJECT, row.meta.span(), text)
                .why("the drive is on EtherCAT, where a master exchanges all active PDOs in every cycle")
                .help("remove the row; values of 1C12h and 1C13h say which PDOs are active"),
        );
    }
    model.on_can()
}

fn transmission(ty: Sp<u8>, direction: Direction, sink: &mut Sink) {
    let reserved = match ty.value {
        241..=251 => "241 to 251 are reserved",
        252 | 253 if direction == Direction::Rx => {
            "252 and 253 are for TxPDOs, which a remote frame asks for"
        }
        _ => return,
    };
    sink.push(
        Diagnostic::new(code::NOT_TAKEN, ty.span, format!("{} is no transmission type", ty.value))
            .why(format!("CiA 301: {reserved}"))
            .help("write 0 to 240 for every so many SYNCs, or 254 or 255 for changes and the event timer"),
    );
}

/// The identifier, where the drive has one that can be written.
fn cob_id(
    direction: Direction,
    at: Address,
    map: Sp<u16>,
    row: Option<&CommunicationRow>,
    node_id: u8,
    model: &Model,
    sink: &mut Sink,
) -> Option<CobId> {
    let asked = row.and_then(|row| row.cob_id.map(|id| id.span).or(row.off.map(|off| off.span)));
    let there = model.entry(at).map(|(_, entry)| entry).filter(|entry| entry.access.value.writes());
    // Where the row asks for one and the drive has none, that is said.
    let entry = if let Some(span) = asked { object(Sp::new(at, span), model, sink)? } else { there? };
    let default = default(entry, node_id);
    let id = match row.and_then(|row| row.cob_id) {
        Some(id) => usable(id, sink)?,
        None => match default.or(predefined(direction, map.value, node_id)) {
            Some(id) => id & !(OFF | NO_RTR),
            None => return unknown(at, map, sink),
        },
    };
    let no_rtr = default.unwrap_or(0) & if direction == Direction::Tx { NO_RTR } else { 0 };
    let off = row.and_then(|row| row.off).is_some_and(|off| off.value);
    let set = |value, sink: &mut Sink| taken(entry, Sp::new(value, asked.unwrap_or(map.span)), sink);
    let end = set(id | no_rtr | if off { OFF } else { 0 }, sink)?;
    Some(CobId { off: set(end.value | OFF, sink)?, end })
}

/// The default of a COB-ID for this node.
fn default(entry: &Entry, node_id: u8) -> Option<i128> {
    let formula = entry.default_beside_node_id().map(|n| n + i128::from(node_id));
    formula.or(entry.default_int().map(|default| default.value))
}

/// The identifiers of CiA 301 for the first four PDOs of a direction.
fn predefined(direction: Direction, map: u16, node_id: u8) -> Option<i128> {
    let number = i128::from(map & 0x1FF);
    let first = if direction == Direction::Rx { 0x200 } else { 0x180 };
    (number < 4).then(|| first + number * 0x100 + i128::from(node_id))
}

fn unknown(at: Address, map: Sp<u16>, sink: &mut Sink) -> Option<CobId> {
    sink.push(
        Diagnostic::new(code::COB_ID, map.span, format!("nobody states the default of {at}"))
            .why("the PDO is switched off while it is changed, and on again with its identifier")
            .help("add a row of `communication` with `cob_id`"),
    );
    None
}

fn usable(id: Sp<u32>, sink: &mut Sink) -> Option<i128> {
    let n = id.value;
    if RESERVED.iter().any(|(first, last)| (*first..=*last).contains(&n)) {
        sink.push(
            Diagnostic::new(code::COB_ID, id.span, format!("{n:X}h is no identifier for a PDO"))
                .why("CiA 301 keeps it for another service, or a base frame cannot hold it")
                .help(
                    "write 80h to 100h, 181h to 580h, 600h, 680h to 6DFh or 700h; `off` switches the PDO off",
                ),
        );
        return None;
    }
    Some(n.into())
}

/// Reports identifiers that two PDOs share.
pub(super) fn identifiers_differ(pdos: &[Pdo], sink: &mut Sink) {
    let on = |pdo: &'_ Pdo| Some((pdo.index, pdo.cob_id.as_ref().filter(|id| id.end.value & OFF == 0)?.end));
    let ids: Vec<(u16, Setting)> = pdos.iter().filter_map(on).collect();
    for (n, (index, id)) in ids.iter().enumerate() {
        let same = |(_, other): &&(u16, Setting)| other.value & BASE == id.value & BASE;
        if let Some((first, other)) = ids[..n].iter().find(same) {
            let text = format!("{index:04X}h has the identifier {:X}h of {first:04X}h", id.value & BASE);
            sink.push(
                Diagnostic::new(code::COB_ID, id.span, text)
                    .related(other.span, "the other PDO")
                    .why("what is sent under one identifier is one PDO")
                    .help("give one of them another `cob_id`"),
            );
        }
    }
}
