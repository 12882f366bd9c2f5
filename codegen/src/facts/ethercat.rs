//! Facts of the EtherCAT side.

use super::{Lines, Table, words};
use crate::model::{Address, Coe, DcMode, EtherCat, Fmmu, StartUp, SyncManager};

pub(super) fn ethercat<'m>(whole: &'m EtherCat, lines: &mut Lines<'m>) {
    lines.row(Table::EtherCat, "ethercat".to_owned());
    lines.fact("type", whole.product_type.as_ref(), Clone::clone);
    lines.fact("group", whole.group.as_ref(), Clone::clone);
    lines.fact("physics", whole.physics.as_ref(), Clone::clone);
    lines.fact("revision_check", whole.revision_check.as_ref(), |w| w.word().to_owned());
    lines.fact("mailbox", whole.mailbox.as_ref(), |m| words(m));
    lines.fact("config", whole.config.as_ref(), |c| hexadecimal(c));
    lines.fact("bootstrap", whole.bootstrap.as_ref(), |b| hexadecimal(b));
    lines.fact("eeprom_bytes", whole.eeprom_bytes.as_ref(), u32::to_string);
}

pub(super) fn sync_manager<'m>(manager: &'m SyncManager, lines: &mut Lines<'m>) {
    lines.row(Table::EtherCat, format!("sync manager {}", manager.number));
    lines.said("use", manager.carries.value.word(), &manager.carries.origin);
    lines.fact("start", manager.start.as_ref(), |n| hexadecimal(&[*n]));
    lines.fact("size", manager.size.as_ref(), u16::to_string);
    lines.fact("min_size", manager.min_size.as_ref(), u16::to_string);
    lines.fact("max_size", manager.max_size.as_ref(), u16::to_string);
    lines.fact("control", manager.control.as_ref(), |n| format!("0x{n:02X}"));
    lines.fact("enable", manager.enable.as_ref(), bool::to_string);
}

pub(super) fn fmmu<'m>(fmmu: &'m Fmmu, lines: &mut Lines<'m>) {
    lines.row(Table::EtherCat, format!("fmmu {}", fmmu.number));
    lines.said("use", fmmu.maps.value.word(), &fmmu.maps.origin);
}

pub(super) fn coe<'m>(coe: &'m Coe, lines: &mut Lines<'m>) {
    lines.row(Table::EtherCat, format!("coe {}", coe.feature.word()));
    lines.said("supported", &coe.supported.value, &coe.supported.origin);
}

pub(super) fn dc_mode<'m>(mode: &'m DcMode, lines: &mut Lines<'m>) {
    lines.row(Table::EtherCat, format!("dc mode {}", mode.number));
    lines.said("name", &mode.name.value, &mode.name.origin);
    lines.said("sync", mode.sync.value.word(), &mode.sync.origin);
    lines.fact("assign_activate", mode.assign_activate.as_ref(), |n| hexadecimal(&[*n]));
    lines.fact("cycle0", mode.cycle0.as_ref(), u32::to_string);
    lines.fact("shift0", mode.shift0.as_ref(), i32::to_string);
    lines.fact("cycle1", mode.cycle1.as_ref(), u32::to_string);
    lines.fact("shift1", mode.shift1.as_ref(), i32::to_string);
    lines.own_text("text", mode.text.as_ref());
}

pub(super) fn startup<'m>(startup: &'m StartUp, lines: &mut Lines<'m>) {
    lines.row(Table::EtherCat, format!("startup {}", startup.number));
    lines.said("transition", startup.transition.value.word(), &startup.transition.origin);
    lines.fact("write", Some(&startup.write), Address::to_string);
    lines.fact("value", Some(&startup.value), i128::to_string);
    lines.own_text("text", startup.text.as_ref());
}

/// Words as registers are printed.
fn hexadecimal(words: &[u16]) -> String {
    words.iter().map(|word| format!("0x{word:04X}")).collect::<Vec<_>>().join(" ")
}
