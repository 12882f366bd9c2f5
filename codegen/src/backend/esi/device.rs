//! Writes what a device is besides its dictionary: slave controller, process data, mailbox, synchronization, EEPROM.

use super::loss::{Loss, Losses};
use super::lower::Dictionary;
use super::types;
use super::value::{bytes, digits};
use super::xml::{Xml, flag, hex};
use super::{alarms, dictionary};
use crate::backend::ethercat::{AssignedPdo, Device, Manager, OpMode, Sync};
use crate::model::{
    Address, CoeFeature, Direction, FmmuUse, MailboxProtocol, Model, PdoEntry, RevisionCheck, StartUp,
    SyncManagerUse,
};

/// Addresses of a slave controller have 16 bits.
const MEMORY_END: u32 = 0x1_0000;

/// What of the device an ESI cannot hold.
pub(super) fn lose(model: &Model, device: &Device<'_>, losses: &mut Losses) {
    if device.managers.iter().any(|manager| manager.end() > MEMORY_END) {
        losses.add_of_drive(Loss::Memory);
    }
    let syncs = device.dc_modes.iter().flat_map(|mode| mode.sync0.iter().chain(&mode.sync1));
    if syncs.into_iter().any(|sync| i32::try_from(sync.cycle).is_err()) {
        losses.add_of_drive(Loss::CycleTooLong);
    }
    let coe = device.mailbox.contains(&MailboxProtocol::Coe);
    for startup in &model.startup {
        if !coe {
            losses.add(Loss::StartUpWithoutCoe, startup.write.value, startup.write.span());
        } else if start_up_bytes(model, startup).is_none() {
            losses.add(Loss::StartUpValue, startup.write.value, startup.value.span());
        }
    }
}

/// The element `Device`.
pub(super) fn write(model: &Model, device: &Device<'_>, dictionary: &Dictionary, xml: &mut Xml) {
    xml.element("Device", &[("Physics", device.physics)], |xml| {
        device_type(device, xml);
        xml.english("Name", &model.drive.name);
        xml.text("GroupType", device.group);
        profile(model, dictionary, xml);
        device.fmmus.iter().for_each(|fmmu| xml.text("Fmmu", fmmu_name(*fmmu)));
        device.managers.iter().for_each(|manager| sync_manager(manager, xml));
        for direction in [Direction::Rx, Direction::Tx] {
            let pdos = device.pdos.iter().filter(|pdo| pdo.pdo.direction == direction);
            pdos.for_each(|pdo| self::pdo(model, device, pdo, xml));
        }
        mailbox(model, device, xml);
        if !device.dc_modes.is_empty() {
            xml.group("Dc", |xml| {
                device.dc_modes.iter().for_each(|mode| op_mode(mode, xml));
            });
        }
        eeprom(device, xml);
    });
}

fn device_type(device: &Device<'_>, xml: &mut Xml) {
    let [_, product, revision, _] = device.identity;
    let (product, revision) = (hex(product, 8), hex(revision, 8));
    let mut attributes = vec![("ProductCode", product.as_str()), ("RevisionNo", revision.as_str())];
    attributes.extend(device.revision_check.map(|check| ("CheckRevisionNo", check_name(check))));
    xml.text_with("Type", &attributes, device.product_type);
}

fn check_name(check: RevisionCheck) -> &'static str {
    match check {
        RevisionCheck::Any => "NONE",
        RevisionCheck::Equal => "EQ",
        RevisionCheck::EqualOrHigher => "EQ_OR_G",
        RevisionCheck::LowEqual => "LW_EQ",
        RevisionCheck::LowEqualHighOrHigher => "LW_EQ_HW_EQ_OR_G",
        RevisionCheck::HighEqual => "HW_EQ",
        RevisionCheck::HighEqualLowOrHigher => "HW_EQ_LW_EQ_OR_G",
    }
}

/// The low word of 1000h is the profile, the high word what the profile makes of it.
fn profile(model: &Model, dictionary: &Dictionary, xml: &mut Xml) {
    xml.group("Profile", |xml| {
        let device_type = model.default_int(Address::new(0x1000, 0)).and_then(|n| u32::try_from(n).ok());
        if let Some(device_type) = device_type {
            xml.text("ProfileNo", device_type & 0xFFFF);
            xml.text("AddInfo", device_type >> 16);
        }
        dictionary::write(dictionary, xml);
        alarms::write(model, xml);
    });
}

fn fmmu_name(fmmu: FmmuUse) -> &'static str {
    match fmmu {
        FmmuUse::Outputs => "Outputs",
        FmmuUse::Inputs => "Inputs",
        FmmuUse::MailboxStatus => "MBoxState",
    }
}

fn sync_manager(manager: &Manager, xml: &mut Xml) {
    let name = match manager.carries {
        SyncManagerUse::MailboxOut => "MBoxOut",
        SyncManagerUse::MailboxIn => "MBoxIn",
        SyncManagerUse::Outputs => "Outputs",
        SyncManagerUse::Inputs => "Inputs",
    };
    let number = |n: Option<u16>| n.map(|n| n.to_string());
    let attributes = [
        ("MinSize", number(manager.min_size)),
        ("MaxSize", number(manager.max_size)),
        ("DefaultSize", number(Some(manager.size))),
        ("StartAddress", Some(hex(manager.start, 4))),
        ("ControlByte", Some(hex(manager.control, 2))),
        ("Enable", Some(flag(manager.enable).to_owned())),
    ];
    let given: Vec<(&str, &str)> =
        attributes.iter().filter_map(|(key, value)| Some((*key, value.as_deref()?))).collect();
    xml.text_with("Sm", &given, name);
}

/// A PDO that is active by default names its SyncManager; one without can be chosen instead.
fn pdo(model: &Model, device: &Device<'_>, pdo: &AssignedPdo<'_>, xml: &mut Xml) {
    let (element, carries) = match pdo.pdo.direction {
        Direction::Rx => ("RxPdo", SyncManagerUse::Outputs),
        Direction::Tx => ("TxPdo", SyncManagerUse::Inputs),
    };
    let manager = device.manager(carries).filter(|_| pdo.assigned).map(|m| m.number.to_string());
    let mut attributes = vec![("Fixed", flag(pdo.fixed))];
    attributes.extend(manager.as_deref().map(|number| ("Sm", number)));
    xml.element(element, &attributes, |xml| {
        let index = pdo.pdo.index;
        xml.text("Index", hex(index, 4));
        let name = model.object(index).map(|object| object.name.value.original().to_owned());
        xml.text("Name", name.unwrap_or_else(|| format!("{element} {index:04X}h")));
        pdo.excludes.iter().for_each(|other| xml.text("Exclude", hex(*other, 4)));
        pdo.pdo.entries.iter().for_each(|mapped| entry(model, mapped, xml));
    });
}

fn entry(model: &Model, mapped: &PdoEntry, xml: &mut Xml) {
    let entry = &model.entries[mapped.entry];
    xml.group("Entry", |xml| {
        xml.text("Index", hex(entry.address.index, 4));
        xml.text("SubIndex", entry.address.sub);
        xml.text("BitLen", mapped.bits.value);
        xml.text("Name", &entry.name.value);
        xml.text("DataType", types::base(entry.ty.value, mapped.bits.value.div_ceil(8).into()).name);
    });
}

fn mailbox(model: &Model, device: &Device<'_>, xml: &mut Xml) {
    let has = |protocol| device.mailbox.contains(&protocol);
    if device.mailbox.is_empty() {
        return;
    }
    xml.group("Mailbox", |xml| {
        for (protocol, element) in [(MailboxProtocol::Aoe, "AoE"), (MailboxProtocol::Eoe, "EoE")] {
            if has(protocol) {
                xml.empty(element, &[]);
            }
        }
        if has(MailboxProtocol::Coe) {
            coe(model, device, xml);
        }
        let rest =
            [(MailboxProtocol::Foe, "FoE"), (MailboxProtocol::Soe, "SoE"), (MailboxProtocol::Voe, "VoE")];
        for (protocol, element) in rest {
            if has(protocol) {
                xml.empty(element, &[]);
            }
        }
    });
}

fn coe(model: &Model, device: &Device<'_>, xml: &mut Xml) {
    let attributes = [
        ("SdoInfo", CoeFeature::SdoInformation),
        ("PdoAssign", CoeFeature::PdoAssignment),
        ("PdoConfig", CoeFeature::PdoConfiguration),
        ("PdoUpload", CoeFeature::PdoUpload),
        ("CompleteAccess", CoeFeature::CompleteAccess),
        ("SegmentedSdo", CoeFeature::SegmentedSdo),
    ];
    let attributes = attributes.map(|(key, feature)| (key, flag(device.can(feature))));
    let commands: Vec<(&StartUp, String)> =
        model.startup.iter().filter_map(|s| Some((s, start_up_bytes(model, s)?))).collect();
    if commands.is_empty() {
        xml.empty("CoE", &attributes);
        return;
    }
    xml.element("CoE", &attributes, |xml| {
        for (startup, data) in &commands {
            init_command(startup, data, xml);
        }
    });
}

/// The value of a start-up command as bytes of the entry's type.
fn start_up_bytes(model: &Model, startup: &StartUp) -> Option<String> {
    bytes(model.entry(startup.write.value)?.1.ty.value, startup.value.value)
}

fn init_command(startup: &StartUp, data: &str, xml: &mut Xml) {
    xml.group("InitCmd", |xml| {
        xml.text("Transition", startup.transition.value.word());
        xml.text("Index", hex(startup.write.value.index, 4));
        xml.text("SubIndex", startup.write.value.sub);
        xml.text("Data", data);
        if let Some(text) = &startup.text {
            xml.text("Comment", text);
        }
    });
}

fn op_mode(mode: &OpMode<'_>, xml: &mut Xml) {
    xml.group("OpMode", |xml| {
        xml.text("Name", mode.name);
        if let Some(text) = mode.text {
            xml.text("Desc", text);
        }
        xml.text("AssignActivate", hex(mode.assign_activate, 4));
        let syncs = [
            ("CycleTimeSync0", "ShiftTimeSync0", mode.sync0),
            ("CycleTimeSync1", "ShiftTimeSync1", mode.sync1),
        ];
        for (cycle, shift, sync) in syncs {
            if let Some(sync) = sync {
                cycle_time(cycle, sync, xml);
                xml.text(shift, sync.shift);
            }
        }
    });
}

/// A cycle of the master is 0 times a factor.
fn cycle_time(element: &str, sync: Sync, xml: &mut Xml) {
    match i32::try_from(sync.cycle) {
        Ok(0) => xml.text_with(element, &[("Factor", "1")], 0),
        Ok(cycle) => xml.text(element, cycle),
        // Reported as a loss.
        Err(_) => {}
    }
}

fn eeprom(device: &Device<'_>, xml: &mut Xml) {
    let words =
        |words: &[u16]| digits(&words.iter().flat_map(|word| word.to_le_bytes()).collect::<Vec<u8>>());
    xml.group("Eeprom", |xml| {
        xml.text("ByteSize", device.eeprom_bytes);
        xml.text("ConfigData", words(&device.config));
        xml.text("BootStrap", words(&device.bootstrap));
    });
}
