//! Entries of one object that differ in their sub-index only are told together.

use crate::model::{Entry, Model, Object};

/// The entries of an object in runs that say the same.
pub(super) fn runs<'m>(model: &'m Model, object: &Object) -> Vec<Vec<&'m Entry>> {
    let mut runs: Vec<Vec<&Entry>> = Vec::new();
    for entry in object.entries.iter().map(|id| &model.entries[*id]) {
        match runs.last_mut() {
            Some(run) if run.last().is_some_and(|before| alike(before, entry)) => run.push(entry),
            _ => runs.push(vec![entry]),
        }
    }
    runs
}

/// Whether two entries, the second right behind the first, are told in the same words.
fn alike(a: &Entry, b: &Entry) -> bool {
    a.address.sub > 0
        && a.address.sub + 1 == b.address.sub
        && values_alike(a, b)
        && (&a.text, &a.note, &a.deviation, &a.also) == (&b.text, &b.note, &b.deviation, &b.also)
        && known_alike(a, b)
}

fn values_alike(a: &Entry, b: &Entry) -> bool {
    (&a.name, &a.ty, &a.access, &a.mapping) == (&b.name, &b.ty, &b.access, &b.mapping)
        && (&a.unit, &a.min, &a.max, &a.allow, &a.default) == (&b.unit, &b.min, &b.max, &b.allow, &b.default)
        && (&a.values, &a.bits, &a.parameter, &a.effect) == (&b.values, &b.bits, &b.parameter, &b.effect)
}

fn known_alike(a: &Entry, b: &Entry) -> bool {
    let (a, b) = (a.origins(), b.origins());
    let same = |(a, b): (&&crate::model::Origin, &&crate::model::Origin)| {
        (&a.class, &a.cite, a.erratum) == (&b.class, &b.cite, b.erratum)
    };
    a.len() == b.len() && a.iter().zip(&b).all(same)
}

/// First and last sub-index of a run.
pub(super) fn span(run: &[&Entry]) -> (u8, u8) {
    let sub = |entry: Option<&&Entry>| entry.map_or(0, |e| e.address.sub);
    (sub(run.first()), sub(run.last()))
}

/// `01`, `01, 02`, or `01 to 3F`.
pub(super) fn sub_span(first: u8, last: u8) -> String {
    match last.saturating_sub(first) {
        0 => format!("{first:02X}"),
        1 => format!("{first:02X}, {last:02X}"),
        _ => format!("{first:02X} to {last:02X}"),
    }
}
