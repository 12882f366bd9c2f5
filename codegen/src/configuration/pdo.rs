//! Process data: the tables `pdo` and `communication`.

mod communication;
mod mapping;

use std::collections::BTreeMap;

use super::setting::{Setting, Settings};
use super::{Configuration, code, order};
use crate::diag::{Diagnostic, Sink};
use crate::model::{Address, Direction, Model, Pdo as DefaultPdo};
use crate::rows::tables::{CommunicationRow, MappedRow};
use crate::rows::{ConfigurationRows, Row};
use crate::source::Sp;

/// A PDO that the configuration changes.
#[derive(Debug)]
pub(super) struct Pdo {
    /// Index of the mapping object.
    pub(super) index: u16,
    pub(super) direction: Direction,
    /// Its identifier; `None` where the drive has none that can be written.
    pub(super) cob_id: Option<CobId>,
    /// Transmission type and timers.
    pub(super) settings: Vec<Setting>,
    /// What it carries; `None` where that stays.
    pub(super) mapping: Option<Mapping>,
}

/// The identifier of a PDO while it is changed, and in the end.
#[derive(Debug)]
pub(super) struct CobId {
    pub(super) off: Setting,
    pub(super) end: Setting,
}

/// A whole mapping.
#[derive(Debug)]
pub(super) struct Mapping {
    /// How many entries there are.
    pub(super) count: Setting,
    /// The mapping words.
    pub(super) words: Vec<Setting>,
    /// The mapped objects.
    pub(super) entries: Vec<Address>,
}

impl Pdo {
    /// Every setting of it in the end.
    pub(super) fn settings(&self) -> impl Iterator<Item = &Setting> {
        let mapping = self.mapping.iter().flat_map(|mapping| mapping.words.iter().chain([&mapping.count]));
        self.cob_id.iter().map(|id| &id.end).chain(&self.settings).chain(mapping)
    }
}

/// The rows of one PDO.
#[derive(Default)]
struct Rows<'r> {
    communication: Option<&'r CommunicationRow>,
    mapped: Vec<&'r MappedRow>,
}

/// The PDOs that the configuration changes, by index.
pub(super) fn check(rows: &ConfigurationRows, node_id: u8, model: &Model, sink: &mut Sink) -> Vec<Pdo> {
    let mut by_index: BTreeMap<u16, (Sp<u16>, Rows<'_>)> = BTreeMap::new();
    let new = |map: Sp<u16>| move || (map, Rows::default());
    for row in &rows.communication {
        let rows = &mut by_index.entry(row.map.value).or_insert_with(new(row.map)).1;
        match rows.communication {
            None => rows.communication = Some(row),
            Some(first) => twice(row, first, sink),
        }
    }
    for row in &rows.pdo {
        by_index.entry(row.map.value).or_insert_with(new(row.map)).1.mapped.push(row);
    }
    let pdo = |(map, rows): &(Sp<u16>, Rows<'_>)| one(*map, rows, node_id, model, sink);
    let pdos: Vec<Pdo> = by_index.values().filter_map(pdo).collect();
    communication::identifiers_differ(&pdos, sink);
    pdos
}

fn twice(row: &CommunicationRow, first: &CommunicationRow, sink: &mut Sink) {
    let text = format!("`{}` is set twice", row.key());
    sink.push(
        Diagnostic::new(super::profile_code::DUPLICATE_ROW, row.meta.span(), text)
            .label("again here")
            .related(first.meta.span(), "first here")
            .why("the later row would win, and nobody could see that it does")
            .help("join the two rows"),
    );
}

fn one(map: Sp<u16>, rows: &Rows<'_>, node_id: u8, model: &Model, sink: &mut Sink) -> Option<Pdo> {
    let index = map.value;
    let there = model.entry(Address::new(index, 0)).is_some();
    let Some(direction) = DefaultPdo::direction_of(index).filter(|_| there) else {
        no_pdo(map, model, sink);
        return None;
    };
    let mut pdo = Pdo { index, direction, cob_id: None, settings: Vec::new(), mapping: None };
    communication::check(&mut pdo, map, rows.communication, node_id, model, sink);
    if !rows.mapped.is_empty() {
        pdo.mapping = mapping::check(&pdo, &rows.mapped, model, sink);
    }
    Some(pdo)
}

fn no_pdo(map: Sp<u16>, model: &Model, sink: &mut Sink) {
    let indexes = model.objects.as_slice().iter().map(|object| object.index);
    let known: Vec<String> = indexes
        .filter(|index| DefaultPdo::direction_of(*index).is_some())
        .map(|index| format!("0x{index:04X}"))
        .collect();
    let meant = format!("0x{}", map.value);
    let help = match known.as_slice() {
        [] => "remove the row: the drive has no PDO that can be changed".to_owned(),
        known if known.contains(&meant) => format!("write `{meant}`; without `0x` the number is decimal"),
        known => format!("mapping objects of the drive: {}", known.join(", ")),
    };
    sink.push(
        Diagnostic::new(
            code::NO_PDO,
            map.span,
            format!("{:04X}h is no mapping object of the drive", map.value),
        )
        .why("an RxPDO is mapped in 1600h to 17FFh, a TxPDO in 1A00h to 1BFFh, as far as the drive has them")
        .help(help),
    );
}

/// Warns of PDOs that are mapped and not active: on EtherCAT, 1C12h and 1C13h assign them.
pub(super) fn inactive(model: &Model, configuration: &Configuration, pdos: &[Pdo], sink: &mut Sink) {
    let values = configuration.values();
    let value = |at| values.get(&at).copied().or_else(|| model.default_int(at));
    for pdo in pdos {
        let Some(mapping) = &pdo.mapping else { continue };
        let assignment = order::assignment(pdo.direction);
        let Some(count) = value(Address::new(assignment, 0)).and_then(|n| u8::try_from(n).ok()) else {
            continue;
        };
        if (1..=count).any(|sub| value(Address::new(assignment, sub)) == Some(pdo.index.into())) {
            continue;
        }
        let text = format!("{:04X}h is mapped here, and is not active", pdo.index);
        sink.push(
            Diagnostic::new(code::NOT_ACTIVE, mapping.count.span, text)
                .why(format!("{assignment:04X}h assigns other PDOs, so the master does not exchange this one"))
                .help(format!(
                    "add `{{ at = \"{assignment:04X}:01\", value = 0x{:04X} }}` to `values`, or map the PDO that is active",
                    pdo.index
                )),
        );
    }
}

/// Warns of values that a PDO of the configuration overwrites.
pub(super) fn overwritten(settings: &Settings, pdos: &[Pdo], sink: &mut Sink) {
    for pdo in pdos.iter().filter(|pdo| pdo.direction == Direction::Rx) {
        let Some(mapping) = &pdo.mapping else { continue };
        for setting in settings.list.iter().filter(|s| mapping.entries.contains(&s.address)) {
            let text = format!("{} is set here and carried by the PDO {:04X}h", setting.address, pdo.index);
            sink.push(
                Diagnostic::new(code::OVERWRITTEN, setting.span, text)
                    .related(mapping.count.span, "the end of its mapping")
                    .why("the first PDO overwrites the value")
                    .help("let the PDO carry the value, or take the object out of the mapping"),
            );
        }
    }
}
