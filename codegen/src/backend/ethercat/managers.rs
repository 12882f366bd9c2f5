//! SyncManagers and FMMUs: where mailbox and process data lie in the memory of the slave controller.

use super::{AssignedPdo, Assumptions};
use crate::model::{Direction, FmmuUse, Model, SyncManager, SyncManagerUse};

const USES: &str = "a drive with a mailbox and process data has these four in this order";
const START: &str = "process memory starts at 1000h; each SyncManager follows the one before at the next multiple of 80h, \
    and process data has room for the three buffers of buffered mode";
const MAILBOX: &str =
    "128 bytes hold every transfer of an entry, and slave controllers with the least memory have them";
const SIZE: &str = "the length of the PDOs that are active by default";
const MAX: &str = "the greatest length of a PDO, times how many can be active";
const CONTROL: &str = "mailbox: one buffer, written by the master (26h) or read (22h), with interrupt; process data: three \
    buffers, written with watchdog and interrupt (64h) or read (20h)";
const ENABLE: &str = "a SyncManager is active unless it has no length";
const FMMUS: &str = "one FMMU for process data of each direction, and one for the state of the mailbox";
/// First address of the memory for mailbox and process data.
const MEMORY: u32 = 0x1000;
/// SyncManagers start at multiples of it.
const STEP: u32 = 0x80;
const MAILBOX_SIZE: u16 = 128;

/// A SyncManager as a device file lists it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Manager {
    /// Its number.
    pub number: u8,
    /// What it carries.
    pub carries: SyncManagerUse,
    /// Physical start address.
    pub start: u16,
    /// Length in bytes by default.
    pub size: u16,
    /// Least length in bytes, where somebody says it.
    pub min_size: Option<u16>,
    /// Greatest length in bytes, where somebody says it or it follows.
    pub max_size: Option<u16>,
    /// The control register.
    pub control: u8,
    /// Whether it is active.
    pub enable: bool,
}

impl Manager {
    /// Whether it carries a mailbox.
    pub fn is_mailbox(&self) -> bool {
        is_mailbox(self.carries)
    }

    /// The address behind its memory: process data has three buffers.
    pub fn end(&self) -> u32 {
        end(self.carries, self.start.into(), self.max_size.unwrap_or(0).max(self.size))
    }
}

fn is_mailbox(carries: SyncManagerUse) -> bool {
    matches!(carries, SyncManagerUse::MailboxOut | SyncManagerUse::MailboxIn)
}

fn end(carries: SyncManagerUse, start: u32, size: u16) -> u32 {
    let buffers = if is_mailbox(carries) { 1 } else { 3 };
    start + buffers * u32::from(size)
}

/// The SyncManagers of `model`, by number.
pub(super) fn managers(model: &Model, pdos: &[AssignedPdo<'_>], assumed: &mut Assumptions) -> Vec<Manager> {
    let mut next = MEMORY;
    let mut out: Vec<Manager> = Vec::new();
    for (number, carries, row) in listed(model, assumed) {
        let manager = manager(model, (number, carries, row), pdos, free(model, next), assumed);
        next = manager.end().max(next);
        out.push(manager);
    }
    out
}

/// The rows, or the four that every drive has.
fn listed<'m>(
    model: &'m Model,
    assumed: &mut Assumptions,
) -> Vec<(u8, SyncManagerUse, Option<&'m SyncManager>)> {
    if model.sync_managers.is_empty() {
        const FOUR: [SyncManagerUse; 4] = [
            SyncManagerUse::MailboxOut,
            SyncManagerUse::MailboxIn,
            SyncManagerUse::Outputs,
            SyncManagerUse::Inputs,
        ];
        let words = FOUR.map(SyncManagerUse::word).join(", ");
        let four = assumed.take("SyncManagers 0 to 3", FOUR, words, USES);
        return (0..).zip(four).map(|(number, carries)| (number, carries, None)).collect();
    }
    model.sync_managers.iter().map(|row| (row.number, row.carries.value, Some(row))).collect()
}

/// The first address at or behind `next` that no SyncManager with a stated address needs.
fn free(model: &Model, next: u32) -> u32 {
    let stated = model.sync_managers.iter().filter_map(|row| {
        let size = row.max_size.as_ref().or(row.size.as_ref()).map_or(MAILBOX_SIZE, |s| s.value);
        Some(end(row.carries.value, row.start.as_ref()?.value.into(), size))
    });
    stated.fold(next, u32::max).next_multiple_of(STEP)
}

fn manager(
    model: &Model,
    (number, carries, row): (u8, SyncManagerUse, Option<&SyncManager>),
    pdos: &[AssignedPdo<'_>],
    free: u32,
    assumed: &mut Assumptions,
) -> Manager {
    let mut take = |what: &str, value: u16, shown: String, reason| {
        assumed.take(format!("SyncManager {number}, {what}"), value, shown, reason)
    };
    let stated = |get: fn(&SyncManager) -> Option<u16>| row.and_then(get);
    let (size, why) = default_size(carries, pdos);
    let size = stated(|r| r.size.as_ref().map(|f| f.value))
        .unwrap_or_else(|| take("length", size, size.to_string(), why));
    let max_size = stated(|r| r.max_size.as_ref().map(|f| f.value)).or_else(|| {
        let most = longest(model, carries).filter(|most| *most >= size)?;
        Some(take("greatest length", most, most.to_string(), MAX))
    });
    // What lies beyond the memory is reported where the file is written.
    let free = u16::try_from(free).unwrap_or(u16::MAX);
    let start = stated(|r| r.start.as_ref().map(|f| f.value))
        .unwrap_or_else(|| take("start", free, format!("{free:04X}h"), START));
    let control = row.and_then(|r| r.control.as_ref()).map_or_else(
        || {
            let control = default_control(carries);
            take("control", control.into(), format!("{control:02X}h"), CONTROL);
            control
        },
        |fact| fact.value,
    );
    let enable = row.and_then(|r| r.enable.as_ref()).map_or_else(
        || {
            take("active", u16::from(size > 0), (size > 0).to_string(), ENABLE);
            size > 0
        },
        |fact| fact.value,
    );
    let min_size = stated(|r| r.min_size.as_ref().map(|f| f.value));
    Manager { number, carries, start, size, min_size, max_size, control, enable }
}

fn default_size(carries: SyncManagerUse, pdos: &[AssignedPdo<'_>]) -> (u16, &'static str) {
    let Some(direction) = direction(carries) else { return (MAILBOX_SIZE, MAILBOX) };
    let active = pdos.iter().filter(|pdo| pdo.assigned && pdo.pdo.direction == direction);
    let bits: u32 = active.map(|pdo| pdo.pdo.bits()).sum();
    (u16::try_from(bits.div_ceil(8)).unwrap_or(u16::MAX), SIZE)
}

/// The most that process data can have, where the limits of PDOs say it.
fn longest(model: &Model, carries: SyncManagerUse) -> Option<u16> {
    direction(carries)?;
    let limits = &model.drive.limits;
    let (bytes, pdos) = (limits.pdo_bytes.as_ref()?.value, limits.pdos_per_direction.as_ref()?.value);
    bytes.checked_mul(pdos.into())
}

fn direction(carries: SyncManagerUse) -> Option<Direction> {
    match carries {
        SyncManagerUse::Outputs => Some(Direction::Rx),
        SyncManagerUse::Inputs => Some(Direction::Tx),
        SyncManagerUse::MailboxOut | SyncManagerUse::MailboxIn => None,
    }
}

/// The control register that fits a use.
fn default_control(carries: SyncManagerUse) -> u8 {
    match carries {
        SyncManagerUse::MailboxOut => 0x26,
        SyncManagerUse::MailboxIn => 0x22,
        SyncManagerUse::Outputs => 0x64,
        SyncManagerUse::Inputs => 0x20,
    }
}

/// The FMMUs, by number.
pub(super) fn fmmus(model: &Model, managers: &[Manager], assumed: &mut Assumptions) -> Vec<FmmuUse> {
    if !model.fmmus.is_empty() {
        return model.fmmus.iter().map(|row| row.maps.value).collect();
    }
    let needs = [
        (SyncManagerUse::Outputs, FmmuUse::Outputs),
        (SyncManagerUse::Inputs, FmmuUse::Inputs),
        (SyncManagerUse::MailboxIn, FmmuUse::MailboxStatus),
    ];
    let needed = needs.into_iter().filter(|(carries, _)| managers.iter().any(|m| m.carries == *carries));
    let uses: Vec<FmmuUse> = needed.map(|(_, maps)| maps).collect();
    let words = uses.iter().map(|u| u.word()).collect::<Vec<_>>().join(", ");
    if uses.is_empty() { uses } else { assumed.take("FMMUs", uses, words, FMMUS) }
}
