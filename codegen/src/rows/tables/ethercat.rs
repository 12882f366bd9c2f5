//! The EtherCAT side: slave controller, mailbox, synchronization, start-up.

use std::collections::BTreeMap;

use crate::diag::Sink;
use crate::model::{
    Address, Cite, CoeFeature, DcSync, FmmuUse, MailboxProtocol, RevisionCheck, SyncManagerUse, Transition,
};
use crate::raw::RawRow;
use crate::rows::decode::{Decoder, FieldInfo, TableInfo};
use crate::rows::define::rows;
use crate::rows::kind::FromRaw;
use crate::rows::value::{Count, Physics, Reason, Text};
use crate::rows::{Meta, Row};
use crate::source::Sp;

rows! {
    /// What device files say of an EtherCAT drive as a whole: one row. All of it is left to a rule where it is left out.
    EtherCatRow in ethercat, key |_row| { "ethercat".to_owned() } {
        /// The maker's name of the type, which masters show beside the product code.
        type_ "type": optional Text,
        /// The group of products that masters list it in.
        group "group": optional Text,
        /// One letter a port, from port 0: `Y` for 100BASE-TX, `K` for E-bus, `H` for fast hot connect, a blank for none.
        physics "physics": optional Physics,
        /// Which revisions the facts hold for.
        revision_check "revision_check": optional RevisionCheck,
        /// Protocols of the mailbox.
        mailbox "mailbox": optional Vec<MailboxProtocol>,
        /// Words 0 to 6 of the SII: what the slave controller is configured with at power-on.
        config "config": optional [u16; 7],
        /// Offset and size of the receive mailbox, then of the send mailbox, in the state Bootstrap; all 0 for none.
        bootstrap "bootstrap": optional [u16; 4],
        /// Bytes of the SII EEPROM.
        eeprom_bytes "eeprom_bytes": optional u32,
        /// Fields that follow from the manual by a rule.
        inferred "inferred": optional Vec<Reason>,
        /// Where the manual prints it.
        src "src": optional Cite,
    }

    /// A SyncManager of the EtherCAT slave controller.
    SyncManagerRow in sync_managers, key |row| { format!("sync manager {}", row.number.value) } {
        /// Its number.
        number "number": required u8,
        /// What it carries.
        use_ "use": required SyncManagerUse,
        /// Physical start address.
        start "start": optional u16,
        /// Length in bytes by default.
        size "size": optional u16,
        /// Least length in bytes.
        min_size "min_size": optional u16,
        /// Greatest length in bytes.
        max_size "max_size": optional u16,
        /// The control register.
        control "control": optional u8,
        /// Whether it is active.
        enable "enable": optional bool,
        /// Fields that follow from the manual by a rule.
        inferred "inferred": optional Vec<Reason>,
        /// Where the manual prints it.
        src "src": optional Cite,
    }

    /// A fieldbus memory management unit of the EtherCAT slave controller.
    FmmuRow in fmmus, key |row| { format!("fmmu {}", row.number.value) } {
        /// Its number.
        number "number": required u8,
        /// What it maps.
        use_ "use": required FmmuUse,
        /// Where the manual prints it.
        src "src": optional Cite,
    }

    /// Something that CoE can or cannot do beyond reading and writing one entry.
    CoeRow in coe, key |row| { format!("coe {}", row.feature.value.word()) } {
        /// What.
        feature "feature": required CoeFeature,
        /// Whether it can.
        supported "supported": required bool,
        /// Fields that follow from the manual by a rule.
        inferred "inferred": optional Vec<Reason>,
        /// Where the manual says so.
        src "src": optional Cite,
    }

    /// A way to synchronize that a master can choose.
    DcModeRow in dc_modes, key |row| { format!("dc mode {}", row.number.value) } {
        /// Its place in the list: masters take the first if they are not told.
        number "number": required u8,
        /// Its name as printed.
        name "name": required Text,
        /// What the drive is synchronized by.
        sync "sync": required DcSync,
        /// The word for registers 0980h and 0981h.
        assign_activate "assign_activate": optional u16,
        /// Cycle of SYNC0 in ns; 0 for that of the master.
        cycle0 "cycle0": optional u32,
        /// Shift of SYNC0 in ns.
        shift0 "shift0": optional i32,
        /// Cycle of SYNC1 in ns; 0 for that of the master.
        cycle1 "cycle1": optional u32,
        /// Shift of SYNC1 in ns.
        shift1 "shift1": optional i32,
        /// What it does, in your own words.
        text "text": optional Text,
        /// Fields that follow from the manual by a rule.
        inferred "inferred": optional Vec<Reason>,
        /// Where the manual prints it.
        src "src": optional Cite,
    }

    /// A value that a master must write at start-up.
    StartUpRow in startup, key |row| { format!("startup {}", row.number.value) } {
        /// Its place in the order of writing.
        number "number": required u8,
        /// The change of state before which it is written.
        transition "transition": required Transition,
        /// The entry that is written.
        write "write": required Address,
        /// The value.
        value "value": required Count,
        /// What it is for, in your own words.
        text "text": optional Text,
        /// Fields that follow from the manual by a rule.
        inferred "inferred": optional Vec<Reason>,
        /// Where the manual prints it.
        src "src": optional Cite,
    }
}
