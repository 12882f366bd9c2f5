//! Alarms as diagnosis messages with cause and remedy.

use std::collections::BTreeSet;

use super::xml::{Xml, hex};
use crate::model::{Alarm, Model, Reset};

/// Where the numbers of messages start that cannot have their alarm's.
const SHARED: u16 = 0x8000;
/// The ways to clear an alarm, by their number in the file.
const RESETS: &[(Reset, &str)] =
    &[(Reset::Resettable, "by a fault reset"), (Reset::NotResettable, "not by a fault reset")];

/// Numbers of the messages: that of the alarm where it is the only one with it and not 0, which means none; else the next
/// free one from 8000h. It is never 603Fh's code, which alarms share.
pub(super) fn text_ids(alarms: &[Alarm]) -> Vec<u16> {
    let alone = |alarm: &Alarm| {
        let number = alarm.number.value;
        number != 0 && alarms.iter().filter(|other| other.number.value == number).count() == 1
    };
    let mut taken: BTreeSet<u16> = alarms.iter().filter(|a| alone(a)).map(|a| a.number.value).collect();
    let mut ids = Vec::with_capacity(alarms.len());
    for alarm in alarms {
        let free = || (SHARED..=u16::MAX).find(|id| !taken.contains(id)).unwrap_or(u16::MAX);
        let id = if alone(alarm) { alarm.number.value } else { free() };
        taken.insert(id);
        ids.push(id);
    }
    ids
}

/// The element `DiagMessages`, which must not be empty.
pub(super) fn write(model: &Model, xml: &mut Xml) {
    if model.alarms.is_empty() {
        return;
    }
    xml.group("DiagMessages", |xml| {
        for (number, (reset, text)) in (1..).zip(RESETS) {
            if model.alarms.iter().any(|a| a.reset.as_ref().is_some_and(|r| r.value == *reset)) {
                xml.group("DiagReset", |xml| {
                    xml.english("Text", text);
                    xml.text("Enum", number);
                });
            }
        }
        for (alarm, id) in model.alarms.iter().zip(text_ids(&model.alarms)) {
            xml.group("DiagMessage", |xml| message(alarm, id, xml));
        }
    });
}

fn message(alarm: &Alarm, id: u16, xml: &mut Xml) {
    xml.text("TextId", hex(id, 4));
    xml.english("MessageText", &alarm.printed);
    xml.english("Description", description(alarm));
    xml.group("Flags", |xml| {
        xml.text("DiagClass", "error");
        let number =
            alarm.reset.as_ref().and_then(|r| RESETS.iter().position(|(reset, _)| *reset == r.value));
        if let Some(number) = number {
            xml.text("DiagReset", number + 1);
        }
    });
    if !alarm.causes.is_empty() || !alarm.remedies.is_empty() {
        xml.element("CauseRemedy", &[("Idx", "1")], |xml| {
            alarm.causes.iter().for_each(|cause| xml.english("Cause", &cause.value));
            alarm.remedies.iter().for_each(|remedy| xml.english("Remedy", &remedy.value));
        });
    }
}

/// What panel, 603Fh and emergency message show.
fn description(alarm: &Alarm) -> String {
    let aux =
        alarm.aux.as_ref().map(|aux| format!(", auxiliary code {:04X}h", aux.value)).unwrap_or_default();
    format!(
        "Panel {}, number {:02X}h, error code {:04X}h{aux}.",
        alarm.display, alarm.number.value, alarm.code.value
    )
}
