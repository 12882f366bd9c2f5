//! Who says a value: the row, a rule, an erratum or a base.

use crate::model::{Cite, Class, ErratumId, Fact, Id, Origin};
use crate::rows::Meta;
use crate::rows::tables::ErratumRow;
use crate::rows::value::Reason;
use crate::source::{Sp, Span};

/// What decides the origin of a row's values.
#[derive(Clone, Copy)]
pub(super) struct Says<'a> {
    /// The row.
    pub(super) meta: &'a Meta,
    /// Its citation.
    pub(super) src: Option<&'a Sp<Cite>>,
    /// Its inferred fields.
    pub(super) inferred: &'a [Reason],
    /// Its assumed fields.
    pub(super) assumed: &'a [Reason],
    /// All errata of the profile.
    pub(super) errata: &'a [ErratumRow],
    /// The base that the row is of; `None` for the drive's own.
    pub(super) base: Option<&'a str>,
}

impl<'a> Says<'a> {
    /// A row of the drive without inferred or assumed fields.
    pub(super) fn plain(meta: &'a Meta, src: Option<&'a Sp<Cite>>, errata: &'a [ErratumRow]) -> Self {
        Self { meta, src, inferred: &[], assumed: &[], errata, base: None }
    }

    /// The value of `key` with its origin.
    pub(super) fn fact<T>(&self, key: &str, value: Sp<T>) -> Fact<T> {
        Fact::new(value.value, self.origin(key, value.span))
    }

    /// A value that several keys make together, such as a name and the number that it names; an erratum of any of them
    /// concerns it.
    pub(super) fn joint<T>(&self, keys: &[&str], value: Sp<T>) -> Fact<T> {
        let fixed = keys.iter().find(|key| self.meta.fix(key).is_some());
        self.fact(fixed.or(keys.first()).unwrap_or(&""), value)
    }

    fn origin(&self, key: &str, span: Span) -> Origin {
        if let Some(base) = self.base {
            return Origin { class: Class::Standard(base.to_owned()), span, cite: None, erratum: None };
        }
        let cite = self.src.map(|s| s.value.clone());
        let reason = |list: &[Reason]| list.iter().find(|r| r.field == key).map(|r| r.text.clone());
        let Some(fix) = self.meta.fix(key) else {
            let class = match (reason(self.inferred), reason(self.assumed)) {
                (Some(rule), _) => Class::Inferred(rule),
                (None, Some(why)) => Class::Assumed(why),
                (None, None) => Class::Stated,
            };
            return Origin { class, span, cite, erratum: None };
        };
        let erratum = &self.errata[fix.erratum];
        let (class, cite) = match (&erratum.by, fix.set) {
            (_, false) => (Class::Stated, cite),
            (Some(by), true) => (Class::Stated, Some(by.value.clone())),
            // Nothing prints the corrected value: it follows from the reason.
            (None, true) => (Class::Inferred(erratum.why.value.0.clone()), Some(erratum.seen.value.clone())),
        };
        Origin { class, span, cite, erratum: Some(ErratumId::at(fix.erratum)) }
    }
}
