//! The order in which a master writes.
//!
//! A PDO is switched off, set, emptied, mapped and switched on again; on EtherCAT it is taken out of its assignment
//! meanwhile. Single values come after that, in the order of rows, except that a value waits while it would break a rule
//! that the values before it obey.

use std::collections::{BTreeMap, VecDeque};

use super::Write;
use super::pdo::Pdo;
use super::setting::{Setting, Settings};
use crate::model::{Address, Direction, Model, Rule};

/// The direction whose PDOs an object assigns to a SyncManager.
pub(super) fn assigned(at: Address) -> Option<Direction> {
    [Direction::Rx, Direction::Tx].into_iter().find(|direction| assignment(*direction) == at.index)
}

/// The object that assigns PDOs of a direction to a SyncManager.
pub(super) fn assignment(direction: Direction) -> u16 {
    match direction {
        Direction::Rx => 0x1C12,
        Direction::Tx => 0x1C13,
    }
}

/// Every write.
pub(super) fn writes(model: &Model, settings: &Settings, pdos: &[Pdo]) -> Vec<Write> {
    let mut writes = Vec::new();
    for direction in [Direction::Rx, Direction::Tx] {
        let own: Vec<&Pdo> = pdos.iter().filter(|pdo| pdo.direction == direction).collect();
        let assign: Vec<&Setting> =
            settings.list.iter().filter(|s| assigned(s.address) == Some(direction)).collect();
        if own.is_empty() && assign.is_empty() {
            continue;
        }
        let count = count(model, Address::new(assignment(direction), 0), &assign);
        writes.extend(count.map(|count| Write { value: 0, ..count }));
        for pdo in own {
            add_pdo(pdo, &mut writes);
        }
        writes.extend(assign.iter().filter(|s| s.address.sub > 0).map(|s| write(s)));
        // Where none is assigned in the end, that is written already.
        writes.extend(count.filter(|count| count.value != 0));
    }
    let plain = settings.list.iter().filter(|s| assigned(s.address).is_none());
    writes.extend(obeying(model, plain.collect()).into_iter().map(write));
    writes
}

fn write(setting: &Setting) -> Write {
    Write { address: setting.address, value: setting.value, bytes: setting.bytes }
}

/// How many PDOs are assigned in the end: as the configuration says, or as before.
fn count(model: &Model, at: Address, assign: &[&Setting]) -> Option<Write> {
    if let Some(setting) = assign.iter().find(|s| s.address == at) {
        return Some(write(setting));
    }
    let (_, entry) = model.entry(at).filter(|(_, entry)| entry.access.value.writes())?;
    Some(Write { address: at, value: entry.default_int()?.value, bytes: 1 })
}

fn add_pdo(pdo: &Pdo, writes: &mut Vec<Write>) {
    writes.extend(pdo.cob_id.iter().map(|id| write(&id.off)));
    writes.extend(pdo.settings.iter().map(write));
    if let Some(mapping) = &pdo.mapping {
        let count = write(&mapping.count);
        writes.push(Write { value: 0, ..count });
        writes.extend(mapping.words.iter().map(write));
        writes.push(count);
    }
    // One that stays off is written once.
    let on = pdo.cob_id.iter().filter(|id| id.end.value != id.off.value);
    writes.extend(on.map(|id| write(&id.end)));
}

/// The settings in an order that breaks no rule on its way, as far as there is one.
fn obeying<'s>(model: &Model, settings: Vec<&'s Setting>) -> Vec<&'s Setting> {
    let mut rules: BTreeMap<Address, Vec<&Rule>> = BTreeMap::new();
    for rule in model.rules.iter().filter(|rule| rule.on.is_none()) {
        rule.objects().into_iter().for_each(|at| rules.entry(at).or_default().push(rule));
    }
    let mut written: BTreeMap<Address, i128> = BTreeMap::new();
    let mut left: VecDeque<&Setting> = settings.into();
    let mut order = Vec::new();
    while !left.is_empty() {
        let value = |at| written.get(&at).copied().or_else(|| model.default_int(at));
        let breaks = |setting: &Setting| {
            let then = |at| if at == setting.address { Some(setting.value) } else { value(at) };
            let own = rules.get(&setting.address);
            own.into_iter().flatten().any(|rule| rule.broken(then) && !rule.broken(value))
        };
        let next = left.iter().position(|setting| !breaks(setting)).unwrap_or(0);
        let Some(setting) = left.remove(next) else { break };
        written.insert(setting.address, setting.value);
        order.push(setting);
    }
    order
}
