//! Faults and warnings.

use super::names;
use super::origin::Says;
use crate::diag::Sink;
use crate::merge::Profile;
use crate::model::{Alarm, Detection, Fact};
use crate::rows::tables::{AlarmRow, ErratumRow};
use crate::rows::value::Text;
use crate::source::Sp;

pub(super) fn alarms(profile: &Profile, sink: &mut Sink) -> Vec<Alarm> {
    let mut rows: Vec<&AlarmRow> = profile.rows.alarms.iter().collect();
    rows.sort_by(|a, b| {
        (a.number.value, &a.display.value, a.meta.span()).cmp(&(
            b.number.value,
            &b.display.value,
            b.meta.span(),
        ))
    });
    for pair in rows.windows(2).filter(|p| p[0].number == p[1].number && p[0].display == p[1].display) {
        crate::merge::duplicate(pair[1], pair[0], sink);
    }
    rows.iter().map(|row| alarm(row, &profile.rows.errata, sink)).collect()
}

fn alarm(row: &AlarmRow, errata: &[ErratumRow], sink: &mut Sink) -> Alarm {
    let says = Says::plain(&row.meta, row.src.as_ref(), errata);
    let detail = Says::plain(&row.meta, row.detail.as_ref().or(row.src.as_ref()), errata);
    Alarm {
        display: row.display.value.0.clone(),
        number: says.fact("number", row.number),
        code: says.fact("code", row.code),
        aux: row.aux.map(|v| says.fact("aux", v)),
        name: says.joint(&["name", "display"], names::used(&row.name, row.rename.as_ref(), sink)),
        printed: row.name.value.0.original().to_owned(),
        reset: row.reset.map(|v| says.fact("reset", v)),
        causes: texts("causes", row.causes.as_ref(), &detail),
        remedies: texts("remedies", row.remedies.as_ref(), &detail),
        detection: Detection {
            esm: row.esm.clone().map(|v| detail.fact("esm", v)),
            esm_after: row.esm_after.map(|v| detail.fact("esm_after", v)),
            sync: row.sync.map(|v| detail.fact("sync", v)),
            al_status: row.al_status.map(|v| detail.fact("al_status", v)),
            led: row.led.map(|v| detail.fact("led", v)),
        },
    }
}

fn texts(key: &str, list: Option<&Sp<Vec<Text>>>, says: &Says<'_>) -> Vec<Fact<String>> {
    let each = |list: &Sp<Vec<Text>>| -> Vec<Fact<String>> {
        list.value.iter().map(|t| says.fact(key, Sp::new(t.0.clone(), list.span))).collect()
    };
    list.map(each).unwrap_or_default()
}
