//! The EtherCAT side of a drive: what device files state besides the dictionary.

use super::{
    Address, CoeFeature, DcSync, Fact, FmmuUse, MailboxProtocol, RevisionCheck, SyncManagerUse, Transition,
};

/// The EtherCAT slave controller and what device files say of the drive as a whole, where anybody says it.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct EtherCat {
    /// The maker's name of the type: what masters show beside the product code.
    pub product_type: Option<Fact<String>>,
    /// The group of products that masters list it in.
    pub group: Option<Fact<String>>,
    /// One letter a port, from port 0: `Y` for 100BASE-TX, `K` for E-bus, `H` for fast hot connect, a blank for none.
    pub physics: Option<Fact<String>>,
    /// Which revisions the facts hold for.
    pub revision_check: Option<Fact<RevisionCheck>>,
    /// Protocols of the mailbox.
    pub mailbox: Option<Fact<Vec<MailboxProtocol>>>,
    /// Words 0 to 6 of the SII: what the slave controller is configured with at power-on.
    pub config: Option<Fact<[u16; 7]>>,
    /// Offset and size of the receive mailbox, then of the send mailbox, in the state Bootstrap.
    pub bootstrap: Option<Fact<[u16; 4]>>,
    /// Bytes of the SII EEPROM.
    pub eeprom_bytes: Option<Fact<u32>>,
}

/// A SyncManager.
#[derive(Clone, PartialEq, Debug)]
pub struct SyncManager {
    /// Its number.
    pub number: u8,
    /// What it carries.
    pub carries: Fact<SyncManagerUse>,
    /// Physical start address.
    pub start: Option<Fact<u16>>,
    /// Length in bytes by default.
    pub size: Option<Fact<u16>>,
    /// Least length in bytes.
    pub min_size: Option<Fact<u16>>,
    /// Greatest length in bytes.
    pub max_size: Option<Fact<u16>>,
    /// The control register.
    pub control: Option<Fact<u8>>,
    /// Whether it is active.
    pub enable: Option<Fact<bool>>,
}

/// A fieldbus memory management unit.
#[derive(Clone, PartialEq, Debug)]
pub struct Fmmu {
    /// Its number.
    pub number: u8,
    /// What it maps.
    pub maps: Fact<FmmuUse>,
}

/// What CoE can or cannot do.
#[derive(Clone, PartialEq, Debug)]
pub struct Coe {
    /// What.
    pub feature: CoeFeature,
    /// Whether it can.
    pub supported: Fact<bool>,
}

/// A way to synchronize that a master can choose.
#[derive(Clone, PartialEq, Debug)]
pub struct DcMode {
    /// Its place in the list; masters take the first if they are not told.
    pub number: u8,
    /// Its name.
    pub name: Fact<String>,
    /// What the drive is synchronized by.
    pub sync: Fact<DcSync>,
    /// Registers 0980h and 0981h.
    pub assign_activate: Option<Fact<u16>>,
    /// Cycle of SYNC0 in ns; 0 for that of the master.
    pub cycle0: Option<Fact<u32>>,
    /// Shift of SYNC0 in ns.
    pub shift0: Option<Fact<i32>>,
    /// Cycle of SYNC1 in ns; 0 for that of the master.
    pub cycle1: Option<Fact<u32>>,
    /// Shift of SYNC1 in ns.
    pub shift1: Option<Fact<i32>>,
    /// What it does.
    pub text: Option<String>,
}

/// A value that a master must write at start-up.
#[derive(Clone, PartialEq, Debug)]
pub struct StartUp {
    /// Its place in the order of writing.
    pub number: u8,
    /// The change of state before which it is written.
    pub transition: Fact<Transition>,
    /// What is written.
    pub write: Fact<Address>,
    /// The value.
    pub value: Fact<i128>,
    /// What it is for.
    pub text: Option<String>,
}
