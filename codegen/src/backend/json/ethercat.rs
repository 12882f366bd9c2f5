//! The EtherCAT side: its shape, and how the model becomes it.

use super::known::{known, maybe};
use super::schema::{Field, Shape, Struct};
use super::value::{Integer, Known, Word, shapes};
use super::write::{Json, Writer};
use crate::model::{
    self, CoeFeature, DcSync, FmmuUse, MailboxProtocol, Model, RevisionCheck, SyncManagerUse, Transition,
};

shapes! {
    /// What device files say of an EtherCAT drive as a whole.
    EtherCat<'m> {
        /// The maker's name of the type.
        product_type "type": optional Known<'m, &'m str>,
        /// The group of products that masters list it in.
        group "group": optional Known<'m, &'m str>,
        /// One letter a port, from port 0: Y for 100BASE-TX, K for E-bus, H for fast hot connect, a blank for none.
        physics "physics": optional Known<'m, &'m str>,
        /// Which revisions the facts hold for.
        revision_check "revision_check": optional Known<'m, Word<RevisionCheck>>,
        /// Protocols of the mailbox.
        mailbox "mailbox": optional Known<'m, Vec<Word<MailboxProtocol>>>,
        /// Words 0 to 6 of the SII.
        config "config": optional Known<'m, Vec<u16>>,
        /// Offset and size of the receive mailbox, then of the send mailbox, in the state Bootstrap.
        bootstrap "bootstrap": optional Known<'m, Vec<u16>>,
        /// Bytes of the SII EEPROM.
        eeprom_bytes "eeprom_bytes": optional Known<'m, u32>,
    }

    /// A SyncManager.
    SyncManager<'m> {
        /// Its number.
        number "number": required u8,
        /// What it carries.
        carries "use": required Known<'m, Word<SyncManagerUse>>,
        /// Physical start address.
        start "start": optional Known<'m, u16>,
        /// Length in bytes by default.
        size "size": optional Known<'m, u16>,
        /// Least length in bytes.
        min_size "min_size": optional Known<'m, u16>,
        /// Greatest length in bytes.
        max_size "max_size": optional Known<'m, u16>,
        /// The control register.
        control "control": optional Known<'m, u8>,
        /// Whether it is active.
        enable "enable": optional Known<'m, bool>,
    }

    /// A fieldbus memory management unit.
    Fmmu<'m> {
        /// Its number.
        number "number": required u8,
        /// What it maps.
        maps "use": required Known<'m, Word<FmmuUse>>,
    }

    /// Something that CoE can or cannot do.
    Coe<'m> {
        /// What.
        feature "feature": required Word<CoeFeature>,
        /// Whether it can.
        supported "supported": required Known<'m, bool>,
    }

    /// A way to synchronize that a master can choose.
    DcMode<'m> {
        /// Its place in the list; masters take the first if they are not told.
        number "number": required u8,
        /// Its name.
        name "name": required Known<'m, &'m str>,
        /// What the drive is synchronized by.
        sync "sync": required Known<'m, Word<DcSync>>,
        /// Registers 0980h and 0981h.
        assign_activate "assign_activate": optional Known<'m, u16>,
        /// Cycle of SYNC0 in ns; 0 for that of the master.
        cycle0 "cycle0": optional Known<'m, u32>,
        /// Shift of SYNC0 in ns.
        shift0 "shift0": optional Known<'m, Integer>,
        /// Cycle of SYNC1 in ns; 0 for that of the master.
        cycle1 "cycle1": optional Known<'m, u32>,
        /// Shift of SYNC1 in ns.
        shift1 "shift1": optional Known<'m, Integer>,
        /// What it does.
        text "text": optional &'m str,
    }

    /// A value that a master must write at start-up.
    StartUp<'m> {
        /// Its place in the order of writing.
        number "number": required u8,
        /// The change of state before which it is written.
        transition "transition": required Known<'m, Word<Transition>>,
        /// What is written.
        write "write": required Known<'m, String>,
        /// The value.
        value "value": required Known<'m, Integer>,
        /// What it is for.
        text "text": optional &'m str,
    }
}

pub(super) fn ethercat(model: &Model) -> EtherCat<'_> {
    let whole = &model.ethercat;
    EtherCat {
        product_type: maybe(model, whole.product_type.as_ref(), String::as_str),
        group: maybe(model, whole.group.as_ref(), String::as_str),
        physics: maybe(model, whole.physics.as_ref(), String::as_str),
        revision_check: maybe(model, whole.revision_check.as_ref(), |w| Word(*w)),
        mailbox: maybe(model, whole.mailbox.as_ref(), |m| m.iter().copied().map(Word).collect()),
        config: maybe(model, whole.config.as_ref(), |c| c.to_vec()),
        bootstrap: maybe(model, whole.bootstrap.as_ref(), |b| b.to_vec()),
        eeprom_bytes: maybe(model, whole.eeprom_bytes.as_ref(), |n| *n),
    }
}

pub(super) fn sync_manager<'m>(model: &'m Model, manager: &'m model::SyncManager) -> SyncManager<'m> {
    SyncManager {
        number: manager.number,
        carries: known(model, Word(manager.carries.value), &manager.carries.origin),
        start: maybe(model, manager.start.as_ref(), |n| *n),
        size: maybe(model, manager.size.as_ref(), |n| *n),
        min_size: maybe(model, manager.min_size.as_ref(), |n| *n),
        max_size: maybe(model, manager.max_size.as_ref(), |n| *n),
        control: maybe(model, manager.control.as_ref(), |n| *n),
        enable: maybe(model, manager.enable.as_ref(), |e| *e),
    }
}

pub(super) fn fmmu<'m>(model: &'m Model, fmmu: &'m model::Fmmu) -> Fmmu<'m> {
    Fmmu { number: fmmu.number, maps: known(model, Word(fmmu.maps.value), &fmmu.maps.origin) }
}

pub(super) fn coe<'m>(model: &'m Model, coe: &'m model::Coe) -> Coe<'m> {
    Coe { feature: Word(coe.feature), supported: known(model, coe.supported.value, &coe.supported.origin) }
}

pub(super) fn dc_mode<'m>(model: &'m Model, mode: &'m model::DcMode) -> DcMode<'m> {
    DcMode {
        number: mode.number,
        name: known(model, &mode.name.value, &mode.name.origin),
        sync: known(model, Word(mode.sync.value), &mode.sync.origin),
        assign_activate: maybe(model, mode.assign_activate.as_ref(), |n| *n),
        cycle0: maybe(model, mode.cycle0.as_ref(), |n| *n),
        shift0: maybe(model, mode.shift0.as_ref(), |n| Integer((*n).into())),
        cycle1: maybe(model, mode.cycle1.as_ref(), |n| *n),
        shift1: maybe(model, mode.shift1.as_ref(), |n| Integer((*n).into())),
        text: mode.text.as_deref(),
    }
}

pub(super) fn startup<'m>(model: &'m Model, startup: &'m model::StartUp) -> StartUp<'m> {
    StartUp {
        number: startup.number,
        transition: known(model, Word(startup.transition.value), &startup.transition.origin),
        write: known(model, startup.write.value.to_string(), &startup.write.origin),
        value: known(model, Integer(startup.value.value), &startup.value.origin),
        text: startup.text.as_deref(),
    }
}
