//! What the device files of an EtherCAT drive share. ESI and SII both state a SyncManager's address or a mailbox, and must
//! not differ: what nobody states is assumed here, once, by a rule that has a name and a reason.
//!
//! This is no backend: it turns the model into plain data, and writes nothing.

mod features;
mod managers;
mod pdos;

use std::fmt::Display;

use crate::model::{CoeFeature, FmmuUse, MailboxProtocol, Model, RevisionCheck};

pub use managers::Manager;
pub use pdos::AssignedPdo;

/// A value that a format demands and nobody states.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Assumed {
    /// Of what: `SyncManager 0, start`.
    pub what: String,
    /// The value.
    pub value: String,
    /// The rule, and why it is that one.
    pub reason: &'static str,
}

/// The values that are assumed, in the order in which they are needed.
#[derive(Clone, Default, PartialEq, Eq, Debug)]
pub struct Assumptions(Vec<Assumed>);

impl Assumptions {
    /// Every assumption.
    pub fn iter(&self) -> impl Iterator<Item = &Assumed> {
        self.0.iter()
    }

    /// Whether the value of that name is one of them.
    pub fn holds(&self, what: &str) -> bool {
        self.0.iter().any(|assumed| assumed.what == what)
    }

    /// One sentence for each reason, with all that it explains.
    pub fn sentences(&self) -> Vec<String> {
        let mut reasons: Vec<(&str, Vec<String>)> = Vec::new();
        for Assumed { what, value, reason } in &self.0 {
            let said = format!("{what}: {value}");
            match reasons.iter_mut().find(|(other, _)| other == reason) {
                Some((_, list)) => list.push(said),
                None => reasons.push((reason, vec![said])),
            }
        }
        reasons.into_iter().map(|(reason, list)| format!("{} ({reason}).", list.join("; "))).collect()
    }

    /// Notes a value and gives it.
    fn take<T>(&mut self, what: impl Into<String>, value: T, shown: impl Display, reason: &'static str) -> T {
        self.0.push(Assumed { what: what.into(), value: shown.to_string(), reason });
        value
    }
}

/// SYNC0 or SYNC1 of the distributed clock.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Sync {
    /// Cycle in ns; 0 for that of the master.
    pub cycle: u32,
    /// Shift in ns.
    pub shift: i32,
}

/// A way to synchronize.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct OpMode<'m> {
    /// Its name.
    pub name: &'m str,
    /// What it does.
    pub text: Option<&'m str>,
    /// Registers 0980h and 0981h.
    pub assign_activate: u16,
    /// SYNC0, where the mode has it.
    pub sync0: Option<Sync>,
    /// SYNC1, where the mode has it.
    pub sync1: Option<Sync>,
}

/// An EtherCAT drive as device files see it.
#[derive(Clone, PartialEq, Debug)]
pub struct Device<'m> {
    /// Vendor, product, revision and serial number of object 1018h.
    pub identity: [u32; 4],
    /// The maker's name of the type.
    pub product_type: &'m str,
    /// The group of products.
    pub group: &'m str,
    /// One letter a port.
    pub physics: &'m str,
    /// Which revisions the file holds for, where somebody says it.
    pub revision_check: Option<RevisionCheck>,
    /// SyncManagers, by number.
    pub managers: Vec<Manager>,
    /// FMMUs, by number.
    pub fmmus: Vec<FmmuUse>,
    /// Protocols of the mailbox; empty for a drive without one.
    pub mailbox: Vec<MailboxProtocol>,
    /// What CoE can do.
    pub coe: Vec<CoeFeature>,
    /// Ways to synchronize, the first by default.
    pub dc_modes: Vec<OpMode<'m>>,
    /// PDOs with default entries, by index.
    pub pdos: Vec<AssignedPdo<'m>>,
    /// Words 0 to 6 of the SII.
    pub config: [u16; 7],
    /// Offset and size of the receive mailbox, then of the send mailbox, in the state Bootstrap.
    pub bootstrap: [u16; 4],
    /// Bytes of the SII EEPROM.
    pub eeprom_bytes: u32,
    /// What of all this is assumed.
    pub assumed: Assumptions,
}

impl<'m> Device<'m> {
    /// The drive as EtherCAT sees it; `None` for a drive that is not on EtherCAT.
    pub fn of(model: &'m Model) -> Option<Self> {
        is_on_ethercat(model).then(|| device(model))
    }

    /// The manager that carries `what`, if there is one.
    pub fn manager(&self, what: crate::model::SyncManagerUse) -> Option<&Manager> {
        self.managers.iter().find(|m| m.carries == what)
    }

    /// Whether CoE can do it.
    pub fn can(&self, feature: CoeFeature) -> bool {
        self.coe.contains(&feature)
    }
}

/// A drive is on EtherCAT if the profile takes the objects of CoE, or states anything of a slave controller.
pub fn is_on_ethercat(model: &Model) -> bool {
    model.drive.bases.iter().any(|base| base == "coe")
        || !model.sync_managers.is_empty()
        || !model.fmmus.is_empty()
        || !model.coe.is_empty()
        || !model.dc_modes.is_empty()
        || !model.startup.is_empty()
        || model.ethercat != crate::model::EtherCat::default()
}

fn device(model: &Model) -> Device<'_> {
    let whole = &model.ethercat;
    let mut assumed = Assumptions::default();
    let identity = identity(model, &mut assumed);
    let pdos = pdos::pdos(model, &mut assumed);
    let managers = managers::managers(model, &pdos, &mut assumed);
    Device {
        identity,
        product_type: features::text(
            "Type",
            whole.product_type.as_ref(),
            &model.drive.name,
            features::TYPE,
            &mut assumed,
        ),
        group: features::text("Group", whole.group.as_ref(), "Drives", features::GROUP, &mut assumed),
        physics: features::text("Ports", whole.physics.as_ref(), "YY", features::PHYSICS, &mut assumed),
        revision_check: whole.revision_check.as_ref().map(|r| r.value),
        fmmus: managers::fmmus(model, &managers, &mut assumed),
        mailbox: features::mailbox(model, &managers, &mut assumed),
        coe: features::coe(model, &mut assumed),
        dc_modes: features::dc_modes(model, &mut assumed),
        config: features::config(model, &mut assumed),
        bootstrap: features::bootstrap(model, &mut assumed),
        eeprom_bytes: features::eeprom_bytes(model, &mut assumed),
        managers,
        pdos,
        assumed,
    }
}

/// The identity object is the one source of the drive's identity.
fn identity(model: &Model, assumed: &mut Assumptions) -> [u32; 4] {
    const NAMES: [&str; 4] = ["Vendor id", "Product code", "Revision", "Serial number"];
    const REASON: &str = "object 1018h has no such default, and 0 claims nothing";
    let mut known = model.identity().into_iter().zip(NAMES);
    [(); 4].map(|()| match known.next() {
        Some((Some(value), _)) => value,
        Some((None, name)) => assumed.take(name, 0, 0, REASON),
        None => 0,
    })
}
