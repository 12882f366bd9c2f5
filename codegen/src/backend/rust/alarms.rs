//! `alarms.rs`: the table of alarms, and their texts in a static of its own that is linked only when it is named.

use std::fmt::Write;

use super::items::{self, variants};
use crate::backend::rust::lower::Lowered;
use crate::emit::escape::rust_str;
use crate::model::{Alarm, Detection, Fact, Reset};

pub(super) fn body(lowered: &Lowered<'_>) -> String {
    let alarms = &lowered.model.alarms;
    let mut out = String::from("use drivewright_runtime::prelude::*;\n");
    out.push_str(&items::table(
        "Faults and warnings, by number.",
        "ALARMS",
        "AlarmDesc",
        alarms.iter().map(row),
    ));
    let told = alarms.iter().filter(|a| a.is_explained());
    let doc = "Causes, remedies and what EtherCAT shows, where the manual says so. No other table refers to it: it is \
        linked only when it is named.";
    out.push_str(&items::table(doc, "ALARM_TEXTS", "AlarmText", told.map(text)));
    out
}

fn row(alarm: &Alarm) -> String {
    let mut row = format!(
        "AlarmDesc::new(\"{}\", 0x{:02X}, 0x{:04X}, \"{}\")",
        rust_str(&alarm.display),
        alarm.number.value,
        alarm.code.value,
        rust_str(&alarm.printed)
    );
    if let Some(aux) = &alarm.aux {
        let _ = write!(row, ".with_aux(0x{:04X})", aux.value);
    }
    match alarm.reset.as_ref().map(|r| r.value) {
        Some(Reset::Resettable) => row.push_str(".with_reset(Reset::Resettable)"),
        Some(Reset::NotResettable) => row.push_str(".with_reset(Reset::NotResettable)"),
        None => {}
    }
    row
}

fn text(alarm: &Alarm) -> String {
    let list = |texts: &[Fact<String>]| {
        let texts: Vec<String> = texts.iter().map(|t| format!("\"{}\"", rust_str(&t.value))).collect();
        format!("&[{}]", texts.join(", "))
    };
    format!(
        "AlarmText::new(\"{}\", 0x{:02X}, {}, {}){}",
        rust_str(&alarm.display),
        alarm.number.value,
        list(&alarm.causes),
        list(&alarm.remedies),
        detection(&alarm.detection)
    )
}

/// Builder calls for how an alarm shows on EtherCAT.
fn detection(detection: &Detection) -> String {
    let calls = [
        detection.esm.as_ref().map(|e| format!(".with_esm(&[{}])", variants("EsmState", &e.value))),
        detection.esm_after.as_ref().map(|e| format!(".with_esm_after(EsmAfter::{:?})", e.value)),
        detection.sync.as_ref().map(|s| format!(".with_sync(SyncMode::{:?})", s.value)),
        detection.al_status.as_ref().map(|n| format!(".with_al_status(0x{:04X})", n.value)),
        detection.led.as_ref().map(|l| format!(".with_led(Led::{:?})", l.value)),
    ];
    calls.into_iter().flatten().collect()
}
