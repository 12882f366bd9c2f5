//! Mailbox, CoE, synchronization and the EEPROM.

use super::{Assumptions, Manager, OpMode, Sync, pdos};
use crate::model::{CoeFeature, DcMode, DcSync, Fact, MailboxProtocol, Model, Worded};

pub(super) const TYPE: &str = "the product name";
pub(super) const GROUP: &str = "masters sort devices by a group, and every one has one";
pub(super) const PHYSICS: &str = "an input and an output of 100BASE-TX, as nearly every drive has";
const PROTOCOL: &str = "the drive has an object dictionary and a mailbox, and CoE is how a master reaches it";
const NO_FEATURE: &str = "nobody states it, and no claims nothing";
const BY_ACCESS: &str = "whether 1C12h or 1C13h, 1600h or 1A00h and their like can be written";
const ACTIVATE: &str = "the cyclic unit with SYNC0 is 0300h, with SYNC1 as well 0700h, free run 0000h";
const CYCLE: &str = "nobody states another cycle";
const SHIFT: &str = "no shift unless somebody states one";
const CONFIG: &str = "how the slave controller is wired in the drive is not printed; zeros serve a virtual drive, and \
    must not be written to a real one";
const BOOTSTRAP: &str = "nobody states a mailbox for Bootstrap, and zeros say that there is none";
const EEPROM: &str = "the least that slave controllers come with";
const EEPROM_BYTES: u32 = 2048;

/// The stated text, or an assumed one.
pub(super) fn text<'m>(
    what: &str,
    stated: Option<&'m Fact<String>>,
    otherwise: &'m str,
    reason: &'static str,
    assumed: &mut Assumptions,
) -> &'m str {
    stated.map_or_else(|| assumed.take(what, otherwise, otherwise, reason), |fact| fact.value.as_str())
}

pub(super) fn mailbox(
    model: &Model,
    managers: &[Manager],
    assumed: &mut Assumptions,
) -> Vec<MailboxProtocol> {
    let mut coe = || assumed.take("Mailbox", vec![MailboxProtocol::Coe], "CoE", PROTOCOL);
    match model.ethercat.mailbox.as_ref() {
        Some(stated) => stated.value.clone(),
        None if managers.iter().any(Manager::is_mailbox) => coe(),
        None => Vec::new(),
    }
}

/// What CoE can do: as stated, by the access of the objects that it needs, or not.
pub(super) fn coe(model: &Model, assumed: &mut Assumptions) -> Vec<CoeFeature> {
    let mut can = |feature: &CoeFeature| {
        if let Some(stated) = model.coe.iter().find(|c| c.feature == *feature) {
            return stated.supported.value;
        }
        let (value, reason) = match feature {
            CoeFeature::PdoAssignment => (any_writable(model, &[0x1C12, 0x1C13]), BY_ACCESS),
            CoeFeature::PdoConfiguration => {
                let maps: Vec<u16> = model.pdos.iter().map(|pdo| pdo.index).collect();
                (any_writable(model, &maps), BY_ACCESS)
            }
            _ => (false, NO_FEATURE),
        };
        assumed.take(format!("CoE, {}", feature.word()), value, if value { "yes" } else { "no" }, reason)
    };
    CoeFeature::ALL.iter().filter(|feature| can(feature)).copied().collect()
}

fn any_writable(model: &Model, indexes: &[u16]) -> bool {
    indexes.iter().any(|index| pdos::writable(model, *index) == Some(true))
}

pub(super) fn dc_modes<'m>(model: &'m Model, assumed: &mut Assumptions) -> Vec<OpMode<'m>> {
    model.dc_modes.iter().map(|mode| op_mode(mode, assumed)).collect()
}

fn op_mode<'m>(mode: &'m DcMode, assumed: &mut Assumptions) -> OpMode<'m> {
    let number = mode.number;
    let (default, uses0, uses1) = match mode.sync.value {
        DcSync::FreeRun => (0x0000, false, false),
        DcSync::Sync0 => (0x0300, true, false),
        DcSync::Sync0And1 => (0x0700, true, true),
    };
    let assign_activate = mode.assign_activate.as_ref().map_or_else(
        || {
            let what = format!("DC mode {number}, AssignActivate");
            assumed.take(what, default, format!("{default:04X}h"), ACTIVATE)
        },
        |fact| fact.value,
    );
    let mut sync = |name: &str, cycle: Option<&Fact<u32>>, shift: Option<&Fact<i32>>| Sync {
        cycle: cycle.map_or_else(
            || assumed.take(format!("DC mode {number}, cycle of {name}"), 0, "that of the master", CYCLE),
            |fact| fact.value,
        ),
        shift: shift.map_or_else(
            || assumed.take(format!("DC mode {number}, shift of {name}"), 0, "0 ns", SHIFT),
            |fact| fact.value,
        ),
    };
    OpMode {
        name: &mode.name.value,
        text: mode.text.as_deref(),
        assign_activate,
        sync0: uses0.then(|| sync("SYNC0", mode.cycle0.as_ref(), mode.shift0.as_ref())),
        sync1: uses1.then(|| sync("SYNC1", mode.cycle1.as_ref(), mode.shift1.as_ref())),
    }
}

pub(super) fn config(model: &Model, assumed: &mut Assumptions) -> [u16; 7] {
    let stated = model.ethercat.config.as_ref();
    stated.map_or_else(|| assumed.take("SII words 0 to 6", [0; 7], "0", CONFIG), |fact| fact.value)
}

pub(super) fn bootstrap(model: &Model, assumed: &mut Assumptions) -> [u16; 4] {
    let stated = model.ethercat.bootstrap.as_ref();
    stated.map_or_else(|| assumed.take("Mailbox of Bootstrap", [0; 4], "0", BOOTSTRAP), |fact| fact.value)
}

pub(super) fn eeprom_bytes(model: &Model, assumed: &mut Assumptions) -> u32 {
    let stated = model.ethercat.eeprom_bytes.as_ref();
    stated.map_or_else(
        || assumed.take("Bytes of the EEPROM", EEPROM_BYTES, EEPROM_BYTES, EEPROM),
        |fact| fact.value,
    )
}
