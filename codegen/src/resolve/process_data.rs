//! Default PDO mappings.

use std::collections::BTreeMap;

use super::origin::Says;
use crate::diag::{Diagnostic, Sink, code};
use crate::limits;
use crate::merge::Profile;
use crate::model::{Direction, Fact, Model, Pdo, PdoEntry};
use crate::rows::tables::PdoRow;

pub(super) fn pdos(profile: &Profile, model: &Model, sink: &mut Sink) -> Vec<Pdo> {
    let mut groups: BTreeMap<u16, Vec<&PdoRow>> = BTreeMap::new();
    for row in &profile.rows.pdo {
        groups.entry(row.map.value).or_default().push(row);
    }
    if let Some(row) = profile.rows.pdo.first().filter(|_| groups.len() > limits::PDOS) {
        sink.push(
            Diagnostic::new(code::TOO_MANY_PDOS, row.meta.span(), format!("{} PDOs", groups.len()))
                .why(format!("a drive has at most {}", limits::PDOS))
                .help("check the column `map`"),
        );
        return Vec::new();
    }
    groups.into_iter().map(|(index, rows)| pdo(index, rows, profile, model, sink)).collect()
}

fn pdo(index: u16, mut rows: Vec<&PdoRow>, profile: &Profile, model: &Model, sink: &mut Sink) -> Pdo {
    rows.sort_by_key(|r| (r.pos.value, r.meta.span()));
    for pair in rows.windows(2).filter(|p| p[0].pos.value == p[1].pos.value) {
        crate::merge::duplicate(pair[1], pair[0], sink);
    }
    rows.dedup_by_key(|r| r.pos.value);
    let direction = direction(index, &rows, profile, sink);
    bounded(index, &rows, sink);
    let entries = rows.iter().filter_map(|row| mapped(row, profile, model, sink)).collect();
    Pdo { index, direction: direction.value, origin: direction.origin, entries }
}

/// What no drive can map, whatever its manual says. What this drive can map is the matter of lints.
fn bounded(index: u16, rows: &[&PdoRow], sink: &mut Sink) {
    let most = usize::try_from(limits::PDO_ENTRIES).unwrap_or(usize::MAX);
    if let Some(row) = rows.get(most) {
        let text = format!("PDO {index:04X} has {} entries", rows.len());
        sink.push(
            Diagnostic::new(code::TOO_MANY_MAPPED, row.meta.span(), text)
                .why(format!("sub-index 0 of a mapping counts at most {most} entries"))
                .help("check the columns `map` and `pos`"),
        );
    }
    let bits: u32 = rows.iter().map(|row| u32::from(row.bits.value)).sum();
    let bytes = bits.div_ceil(8);
    if let Some(row) = rows.last().filter(|_| bytes > limits::PDO_BYTES) {
        sink.push(
            Diagnostic::new(
                code::PDO_TOO_LONG,
                row.meta.span(),
                format!("PDO {index:04X} has {bytes} bytes"),
            )
            .why(format!("one frame carries at most {} bytes of process data", limits::PDO_BYTES))
            .help("check the columns `map` and `bits`"),
        );
    }
}

fn direction(index: u16, rows: &[&PdoRow], profile: &Profile, sink: &mut Sink) -> Fact<Direction> {
    let first = rows[0];
    for row in rows.iter().filter(|r| r.dir != first.dir) {
        sink.push(
            Diagnostic::new(code::BAD_VALUE, row.dir.span, format!("PDO {index:04X} has two directions"))
                .related(first.dir.span, "the other one")
                .why("a PDO is either received or sent")
                .help("correct `dir` or `map`"),
        );
    }
    Says::plain(&first.meta, first.src.as_ref(), &profile.rows.errata).fact("dir", first.dir)
}

fn mapped(row: &PdoRow, profile: &Profile, model: &Model, sink: &mut Sink) -> Option<PdoEntry> {
    let address = row.entry.value;
    let says = Says::plain(&row.meta, row.src.as_ref(), &profile.rows.errata);
    if let Some((entry, _)) = model.entry(address) {
        let origin = says.fact("entry", row.entry).origin;
        return Some(PdoEntry { position: row.pos.value, entry, origin, bits: says.fact("bits", row.bits) });
    }
    if !profile.rows.left_out.contains(&address.to_string()) {
        sink.push(
            Diagnostic::new(code::UNKNOWN_OBJECT, row.entry.span, format!("there is no object {address}"))
                .why("a PDO can carry only what the dictionary has")
                .help("add a row to `objects`, or correct the address"),
        );
    }
    None
}
