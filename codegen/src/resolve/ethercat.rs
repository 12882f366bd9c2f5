//! The EtherCAT side: tables that nothing else refers to, sorted by number.

use super::behaviour::{maybe, plain, reasoned, sorted, text};
use super::objects::check_reasons;
use crate::diag::Sink;
use crate::merge::Profile;
use crate::model::{Coe, DcMode, EtherCat, Fmmu, Model, StartUp, SyncManager};
use crate::rows::Rows;
use crate::rows::tables::{CoeRow, DcModeRow, ErratumRow, EtherCatRow, FmmuRow, StartUpRow, SyncManagerRow};

/// Fills the tables of `model`.
pub(super) fn fill(model: &mut Model, profile: &Profile, sink: &mut Sink) {
    let (rows, errata) = (&profile.rows, profile.rows.errata.as_slice());
    let whole = sorted(&rows.ethercat, |_| (), sink).next();
    model.ethercat = whole.map(|r| ethercat(r, errata)).unwrap_or_default();
    model.sync_managers =
        sorted(&rows.sync_managers, |r| r.number.value, sink).map(|r| sync_manager(r, errata)).collect();
    model.fmmus = sorted(&rows.fmmus, |r| r.number.value, sink).map(|r| fmmu(r, errata)).collect();
    model.coe = sorted(&rows.coe, |r| r.feature.value, sink).map(|r| coe(r, errata)).collect();
    model.dc_modes = sorted(&rows.dc_modes, |r| r.number.value, sink).map(|r| dc_mode(r, errata)).collect();
    model.startup = sorted(&rows.startup, |r| r.number.value, sink).map(|r| startup(r, errata)).collect();
}

/// Reasons of rows that may have them.
pub(super) fn reasons(rows: &Rows, sink: &mut Sink) {
    rows.ethercat.iter().for_each(|r| check_reasons(r, [r.inferred.as_ref()], sink));
    rows.sync_managers.iter().for_each(|r| check_reasons(r, [r.inferred.as_ref()], sink));
    rows.coe.iter().for_each(|r| check_reasons(r, [r.inferred.as_ref()], sink));
    rows.dc_modes.iter().for_each(|r| check_reasons(r, [r.inferred.as_ref()], sink));
    rows.startup.iter().for_each(|r| check_reasons(r, [r.inferred.as_ref()], sink));
}

fn ethercat(row: &EtherCatRow, errata: &[ErratumRow]) -> EtherCat {
    let says = reasoned(&row.meta, row.src.as_ref(), row.inferred.as_ref(), errata);
    EtherCat {
        product_type: maybe(&says, "type", row.type_.as_ref(), |t| t.0),
        group: maybe(&says, "group", row.group.as_ref(), |g| g.0),
        physics: maybe(&says, "physics", row.physics.as_ref(), |p| p.0),
        revision_check: maybe(&says, "revision_check", row.revision_check.as_ref(), |r| r),
        mailbox: maybe(&says, "mailbox", row.mailbox.as_ref(), |m| m),
        config: maybe(&says, "config", row.config.as_ref(), |c| c),
        bootstrap: maybe(&says, "bootstrap", row.bootstrap.as_ref(), |b| b),
        eeprom_bytes: maybe(&says, "eeprom_bytes", row.eeprom_bytes.as_ref(), |e| e),
    }
}

fn sync_manager(row: &SyncManagerRow, errata: &[ErratumRow]) -> SyncManager {
    let says = reasoned(&row.meta, row.src.as_ref(), row.inferred.as_ref(), errata);
    SyncManager {
        number: row.number.value,
        carries: says.joint(&["use", "number"], row.use_),
        start: maybe(&says, "start", row.start.as_ref(), |n| n),
        size: maybe(&says, "size", row.size.as_ref(), |n| n),
        min_size: maybe(&says, "min_size", row.min_size.as_ref(), |n| n),
        max_size: maybe(&says, "max_size", row.max_size.as_ref(), |n| n),
        control: maybe(&says, "control", row.control.as_ref(), |n| n),
        enable: maybe(&says, "enable", row.enable.as_ref(), |e| e),
    }
}

fn fmmu(row: &FmmuRow, errata: &[ErratumRow]) -> Fmmu {
    let says = plain(&row.meta, row.src.as_ref(), errata);
    Fmmu { number: row.number.value, maps: says.joint(&["use", "number"], row.use_) }
}

fn coe(row: &CoeRow, errata: &[ErratumRow]) -> Coe {
    let says = reasoned(&row.meta, row.src.as_ref(), row.inferred.as_ref(), errata);
    Coe { feature: row.feature.value, supported: says.joint(&["supported", "feature"], row.supported) }
}

fn dc_mode(row: &DcModeRow, errata: &[ErratumRow]) -> DcMode {
    let says = reasoned(&row.meta, row.src.as_ref(), row.inferred.as_ref(), errata);
    DcMode {
        number: row.number.value,
        name: says.fact("name", row.name.clone().map(|n| n.0)),
        sync: says.fact("sync", row.sync),
        assign_activate: maybe(&says, "assign_activate", row.assign_activate.as_ref(), |n| n),
        cycle0: maybe(&says, "cycle0", row.cycle0.as_ref(), |n| n),
        shift0: maybe(&says, "shift0", row.shift0.as_ref(), |n| n),
        cycle1: maybe(&says, "cycle1", row.cycle1.as_ref(), |n| n),
        shift1: maybe(&says, "shift1", row.shift1.as_ref(), |n| n),
        text: text(row.text.as_ref()),
    }
}

fn startup(row: &StartUpRow, errata: &[ErratumRow]) -> StartUp {
    let says = reasoned(&row.meta, row.src.as_ref(), row.inferred.as_ref(), errata);
    StartUp {
        number: row.number.value,
        transition: says.fact("transition", row.transition),
        write: says.fact("write", row.write),
        value: says.fact("value", row.value.map(|v| v.0)),
        text: text(row.text.as_ref()),
    }
}
