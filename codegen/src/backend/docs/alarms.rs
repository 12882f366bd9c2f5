//! Faults and warnings: what a person at the machine looks up first.

use std::collections::BTreeMap;

use serde::Serialize;

use super::book::Book;
use super::table::Table;
use crate::backend::prose::capital;
use crate::model::{Alarm, EmcyPart, EsmAfter, EsmState, Led, Model, Reset, SyncMode};

/// The page.
#[derive(Serialize)]
pub(super) struct Alarms {
    overview: String,
    by_code: String,
    emergency: String,
    emergency_texts: Vec<String>,
    sections: Vec<AlarmView>,
}

/// An alarm for a reader.
#[derive(Serialize)]
pub(super) struct AlarmView {
    anchor: String,
    display: String,
    name: String,
    reset: String,
    causes: Vec<String>,
    remedies: Vec<String>,
    facts: String,
    errata: Vec<String>,
}

pub(super) fn page(book: &Book<'_>) -> Option<Alarms> {
    let Model { alarms, emcy, .. } = book.model;
    (!alarms.is_empty() || !emcy.is_empty()).then(|| Alarms {
        overview: overview(book, alarms),
        by_code: by_code(book, alarms),
        emergency: emergency(book, emcy),
        emergency_texts: emcy.iter().filter_map(|part| told(book, part)).collect(),
        sections: alarms.iter().map(|a| view(book, a)).collect(),
    })
}

fn overview(book: &Book<'_>, alarms: &[Alarm]) -> String {
    let rows = alarms.iter().map(|a| {
        [
            book.alarm(a),
            format!("{:02X}h", a.number.value),
            book.fact(Some(&a.code), |n| format!("{n:04X}h")),
            book.fact(a.aux.as_ref(), |n| format!("{n:04X}h")),
            book.marked(&book.text(&a.printed), &[&a.name.origin]),
            book.fact(a.reset.as_ref(), |r| short_reset(*r).to_owned()),
        ]
    });
    Table::of(&["Display", "Number", "603Fh", "Aux", "Name", "Fault reset"], rows).text(book.plain)
}

fn short_reset(reset: Reset) -> &'static str {
    if reset == Reset::Resettable { "yes" } else { "no" }
}

fn by_code(book: &Book<'_>, alarms: &[Alarm]) -> String {
    let mut codes: BTreeMap<u16, Vec<String>> = BTreeMap::new();
    for alarm in alarms {
        let text = format!("{} {}", book.alarm(alarm), book.text(&alarm.printed));
        codes.entry(alarm.code.value).or_default().push(text);
    }
    let rows = codes.into_iter().map(|(code, all)| [format!("{code:04X}h"), all.join("; ")]);
    Table::of(&["603Fh", "Alarm"], rows).text(book.plain)
}

fn emergency(book: &Book<'_>, parts: &[EmcyPart]) -> String {
    let rows = parts.iter().map(|p| {
        let last = u16::from(p.byte) + u16::from(p.bytes.value).max(1) - 1;
        let bytes = if last > p.byte.into() { format!("{} to {last}", p.byte) } else { p.byte.to_string() };
        let holds = book.fact(Some(&p.holds), |h| h.word().to_owned());
        [book.marked(&bytes, &[&p.bytes.origin]), holds, book.source(&p.holds.origin)]
    });
    Table::of(&["Byte", "Holds", "Manual"], rows).text(book.plain)
}

fn told(book: &Book<'_>, part: &EmcyPart) -> Option<String> {
    let text = part.text.as_ref()?;
    Some(format!("{}: {}", capital(part.holds.value.word()), book.prose(text)))
}

/// What to tell of an alarm.
pub(super) fn view(book: &Book<'_>, alarm: &Alarm) -> AlarmView {
    let texts = |list: &[crate::model::Fact<String>]| -> Vec<String> {
        list.iter().map(|t| book.marked(&book.prose(&t.value), &[&t.origin])).collect()
    };
    AlarmView {
        anchor: book.anchored(&book.alarm_anchor(alarm)),
        display: book.text(&alarm.display),
        name: book.text(&alarm.printed),
        reset: match alarm.reset.as_ref().map(|r| r.value) {
            Some(Reset::Resettable) => "A fault reset clears it once the cause is gone.".to_owned(),
            Some(Reset::NotResettable) => "A fault reset does not clear it.".to_owned(),
            None => "Whether a fault reset clears it is not stated.".to_owned(),
        },
        causes: texts(&alarm.causes),
        remedies: texts(&alarm.remedies),
        facts: facts(book, alarm),
        errata: errata(book, alarm),
    }
}

fn facts(book: &Book<'_>, alarm: &Alarm) -> String {
    let d = &alarm.detection;
    let cite = |origin: Option<&crate::model::Origin>| origin.map(|o| book.source(o)).unwrap_or_default();
    let states = |list: &Vec<EsmState>| list.iter().map(|s| s.word()).collect::<Vec<_>>().join(", ");
    let rows = [
        (
            "Error code in 603Fh",
            book.fact(Some(&alarm.code), |n| format!("{n:04X}h")),
            Some(&alarm.code.origin),
        ),
        ("Number", book.fact(Some(&alarm.number), |n| format!("{n:02X}h ({n})")), Some(&alarm.number.origin)),
        (
            "Auxiliary code",
            book.fact(alarm.aux.as_ref(), |n| format!("{n:04X}h")),
            alarm.aux.as_ref().map(|f| &f.origin),
        ),
        (
            "Fault reset",
            book.fact(alarm.reset.as_ref(), |r| r.word().to_owned()),
            alarm.reset.as_ref().map(|f| &f.origin),
        ),
        ("Found in EtherCAT state", book.fact(d.esm.as_ref(), states), d.esm.as_ref().map(|f| &f.origin)),
        (
            "EtherCAT state after it",
            book.fact(d.esm_after.as_ref(), |s| after(*s).to_owned()),
            d.esm_after.as_ref().map(|f| &f.origin),
        ),
        (
            "Found with synchronization",
            book.fact(d.sync.as_ref(), |s| sync(*s).to_owned()),
            d.sync.as_ref().map(|f| &f.origin),
        ),
        (
            "AL status code",
            book.fact(d.al_status.as_ref(), |n| format!("{n:04X}h")),
            d.al_status.as_ref().map(|f| &f.origin),
        ),
        (
            "Error indicator",
            book.fact(d.led.as_ref(), |l| Led::word(*l).to_owned()),
            d.led.as_ref().map(|f| &f.origin),
        ),
    ];
    let rows = rows.into_iter().filter(|(_, value, _)| !value.is_empty());
    Table::of(
        &["Fact", "Value", "Manual"],
        rows.map(|(what, value, origin)| [what.to_owned(), value, cite(origin)]),
    )
    .text(book.plain)
}

fn after(state: EsmAfter) -> &'static str {
    match state {
        EsmAfter::Kept => "the one before",
        EsmAfter::Requested => "the one that the master asks for",
        other => other.word(),
    }
}

fn sync(mode: SyncMode) -> &'static str {
    match mode {
        SyncMode::All => "any",
        SyncMode::Dc => "distributed clocks",
        SyncMode::FreeRun => "free run",
    }
}

/// Errata of the alarm's row, and those that its values come from.
fn errata(book: &Book<'_>, alarm: &Alarm) -> Vec<String> {
    let rows =
        [format!("alarm {}", alarm.display), format!("alarm {} 0x{:02X}", alarm.display, alarm.number.value)];
    let d = &alarm.detection;
    let mut used = vec![alarm.number.origin.erratum, alarm.code.origin.erratum, alarm.name.origin.erratum];
    used.extend(alarm.causes.iter().chain(&alarm.remedies).map(|t| t.origin.erratum));
    used.extend([
        alarm.aux.as_ref().and_then(|f| f.origin.erratum),
        alarm.reset.as_ref().and_then(|f| f.origin.erratum),
        d.esm.as_ref().and_then(|f| f.origin.erratum),
        d.esm_after.as_ref().and_then(|f| f.origin.erratum),
        d.sync.as_ref().and_then(|f| f.origin.erratum),
        d.al_status.as_ref().and_then(|f| f.origin.erratum),
        d.led.as_ref().and_then(|f| f.origin.erratum),
    ]);
    let concerns = |(id, e): &(crate::model::ErratumId, &crate::model::Erratum)| {
        used.contains(&Some(*id)) || rows.contains(&e.at)
    };
    book.model.errata.iter().filter(concerns).map(|(_, e)| super::objects::erratum(book, e)).collect()
}
