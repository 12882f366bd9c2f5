//! Alarms and their texts.

use drivewright_runtime::model::{AlarmDesc, AlarmText, Reset};

use super::Arena;
use crate::model::{self, Alarm, Fact, Model};

pub(super) fn table<'a>(profile: &'a Model, arena: &'a Arena) -> &'a [AlarmDesc<'a>] {
    arena.slice(profile.alarms.iter().map(row))
}

fn row(alarm: &Alarm) -> AlarmDesc<'_> {
    let row = AlarmDesc::new(&alarm.display, alarm.number.value, alarm.code.value, &alarm.printed);
    let row = alarm.aux.as_ref().map_or(row, |aux| row.with_aux(aux.value));
    match alarm.reset.as_ref().map(|r| r.value) {
        Some(model::Reset::Resettable) => row.with_reset(Reset::Resettable),
        Some(model::Reset::NotResettable) => row.with_reset(Reset::NotResettable),
        None => row,
    }
}

pub(super) fn texts<'a>(profile: &'a Model, arena: &'a Arena) -> &'a [AlarmText<'a>] {
    arena.slice(profile.alarms.iter().filter(|a| a.is_explained()).map(|a| text(a, arena)))
}

fn text<'a>(alarm: &'a Alarm, arena: &'a Arena) -> AlarmText<'a> {
    let list = |texts: &'a [Fact<String>]| arena.slice(texts.iter().map(|t| t.value.as_str()));
    let (causes, remedies) = (list(&alarm.causes), list(&alarm.remedies));
    let text = AlarmText::new(&alarm.display, alarm.number.value, causes, remedies);
    let shown = &alarm.detection;
    let text = shown.esm.as_ref().map_or(text, |esm| text.with_esm(&esm.value));
    let text = shown.esm_after.as_ref().map_or(text, |after| text.with_esm_after(after.value));
    let text = shown.sync.as_ref().map_or(text, |sync| text.with_sync(sync.value));
    let text = shown.al_status.as_ref().map_or(text, |code| text.with_al_status(code.value));
    shown.led.as_ref().map_or(text, |led| text.with_led(led.value))
}
