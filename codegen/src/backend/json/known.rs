//! Facts with who says them.

use super::value::Known;
use crate::model::{Class, Fact, Model, Origin};

/// A value and who says it.
pub(super) fn known<'m, T>(model: &'m Model, value: T, origin: &'m Origin) -> Known<'m, T> {
    let detail = match &origin.class {
        Class::Stated => None,
        Class::Inferred(rule) => Some(("\"rule\": ", rule.as_str())),
        Class::Standard(base) => Some(("\"base\": ", base.as_str())),
        Class::Assumed(reason) => Some(("\"reason\": ", reason.as_str())),
    };
    Known {
        value,
        class: origin.class.word(),
        detail,
        cite: origin.cite.as_ref().map(ToString::to_string),
        erratum: origin.erratum.map(|id| model.errata[id].id.as_str()),
    }
}

/// The same for a fact that may be missing.
pub(super) fn maybe<'m, T, U>(
    model: &'m Model,
    fact: Option<&'m Fact<T>>,
    value: impl Fn(&'m T) -> U,
) -> Option<Known<'m, U>> {
    fact.map(|f| known(model, value(&f.value), &f.origin))
}
