//! The drive, its manuals and its errata.

use super::origin::Says;
use crate::diag::{Diagnostic, Sink, code};
use crate::merge::Profile;
use crate::model::{Address, Arena, Cite, Drive, Erratum, ErratumId, Limits, Manual};
use crate::rows::address::{At, Sub};
use crate::rows::tables::{DriveRow, ErratumRow};
use crate::rows::{Row, Visit, suggest};
use crate::source::Sp;

pub(super) fn drive(row: &DriveRow, errata: &[ErratumRow]) -> Drive {
    let says = Says::plain(&row.meta, row.pdo_src.as_ref(), errata);
    let limits = Limits {
        pdo_entries: row.pdo_entries.map(|v| says.fact("pdo_entries", v)),
        pdo_bytes: row.pdo_bytes.map(|v| says.fact("pdo_bytes", v)),
        pdos_per_direction: row.pdos_per_direction.map(|v| says.fact("pdos_per_direction", v)),
    };
    Drive {
        id: row.id.value.0.clone(),
        package: format!("{}-{}", row.vendor_id.value.0, row.id.value.0),
        vendor: row.vendor.value.0.clone(),
        name: row.name.value.0.clone(),
        crate_version: row.crate_version.value.0.clone(),
        eds_version: row.eds_version.value,
        eds_revision: row.eds_revision.value,
        date: row.date.value.0.clone(),
        bases: row.bases.iter().flat_map(|b| b.value.iter().map(|b| b.0.clone())).collect(),
        limits,
        note: row.note.as_ref().map(|n| n.value.0.clone()),
    }
}

/// The manuals; a citation of one that is not listed is reported here.
pub(super) fn manuals(profile: &Profile, sink: &mut Sink) -> Vec<Manual> {
    let rows = &profile.rows.manuals;
    for pair in rows.windows(2).filter(|p| p[0].id == p[1].id) {
        crate::merge::duplicate(&pair[1], &pair[0], sink);
    }
    let known: Vec<&str> = rows.iter().map(|m| m.id.value.0.as_str()).collect();
    let mut citations = Citations::default();
    profile.rows.visit(&mut citations);
    for cite in citations.0 {
        check_manuals(cite, &known, sink);
    }
    rows.iter()
        .map(|row| Manual {
            id: row.id.value.0.clone(),
            title: row.title.value.0.clone(),
            version: row.version.value.0.clone(),
            date: row.date.as_ref().map(|d| d.value.0.clone()),
            sha256: row.sha256.value.0.clone(),
            lines: row.lines.value,
        })
        .collect()
}

/// Collects the citations of every table.
#[derive(Default)]
struct Citations<'a>(Vec<&'a Sp<Cite>>);

impl<'a> Visit<'a> for Citations<'a> {
    fn table<R: Row>(&mut self, rows: &'a [R]) {
        self.0.extend(rows.iter().flat_map(Row::cites));
    }
}

fn check_manuals(cite: &Sp<Cite>, known: &[&str], sink: &mut Sink) {
    let unknown = |p: &&crate::model::Place| p.manual.as_deref().is_some_and(|m| !known.contains(&m));
    if let Some(manual) = cite.value.places.iter().find(unknown).and_then(|p| p.manual.as_deref()) {
        sink.push(
            Diagnostic::new(code::UNKNOWN_MANUAL, cite.span, format!("there is no manual `{manual}`"))
                .why("a citation names a document of the table `manuals`")
                .help(suggest(manual, known)),
        );
    }
}

pub(super) fn errata(profile: &Profile) -> Arena<ErratumId, Erratum> {
    Arena::new(profile.rows.errata.iter().map(erratum).collect())
}

fn erratum(row: &ErratumRow) -> Erratum {
    let at = row.at.value.0.clone();
    Erratum {
        id: row.id.value.0.clone(),
        address: match At::parse(&at) {
            Some(At { index, sub: Sub::One(sub) }) => Some(Address::new(index, sub)),
            _ => None,
        },
        at,
        field: row.field.value.0.clone(),
        was: row.was.value.to_string(),
        seen: row.seen.value.clone(),
        set: row.set.as_ref().map(|s| s.value.to_string()),
        unset: row.drops(),
        by: row.by.as_ref().map(|b| b.value.clone()),
        why: row.why.value.0.clone(),
        sure: row.sure.value,
    }
}
