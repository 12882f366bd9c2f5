//! In what a row contradicts the standard object. What either of the two leaves open is no contradiction.

use super::stated::Stated;
use crate::model::{Access, Mapping, ObjectKind};
use crate::rows::tables::ObjectRow;
use crate::source::{Sp, Span};

/// Two values of one key that cannot both hold.
pub(super) struct Contradiction {
    pub(super) key: &'static str,
    pub(super) here: String,
    pub(super) there: String,
    pub(super) row: Span,
    pub(super) base: Span,
}

/// The first contradiction of what the drive's rows state and the row of a base.
pub(super) fn find(row: Stated<'_>, base: &ObjectRow) -> Option<Contradiction> {
    let types = (row.own(|r| r.ty.as_ref()), base.ty.as_ref());
    let access = (row.own(|r| r.access.as_ref()), base.access.as_ref());
    let pdo = (row.own(|r| r.pdo.as_ref()), base.pdo.as_ref());
    let kind = (row.own(|r| r.kind.as_ref()), base.kind.as_ref());
    let unit = (row.own(|r| r.unit.as_ref()), base.unit.as_ref());
    differ("type", types, |a, b| a == b, ToString::to_string)
        .or_else(|| differ("access", access, |a, b| same_access(*a, *b), |a| a.word().into()))
        .or_else(|| differ("pdo", pdo, |a, b| same_direction(*a, *b), |m| m.word().into()))
        .or_else(|| differ("kind", kind, |a, b| same_shape(*a, *b), |k| k.word().into()))
        .or_else(|| differ("unit", unit, |a, b| a.quantity.can_be(b.quantity), ToString::to_string))
}

fn differ<T>(
    key: &'static str,
    (here, there): (Option<&Sp<T>>, Option<&Sp<T>>),
    agree: impl Fn(&T, &T) -> bool,
    word: impl Fn(&T) -> String,
) -> Option<Contradiction> {
    let (a, b) = here.zip(there).filter(|(a, b)| !agree(&a.value, &b.value))?;
    Some(Contradiction { key, here: word(&a.value), there: word(&b.value), row: a.span, base: b.span })
}

/// A constant is read only: the two words promise the same to a reader.
fn same_access(a: Access, b: Access) -> bool {
    let plain = |access| if access == Access::Const { Access::Ro } else { access };
    plain(a) == plain(b)
}

/// A drive may map less than the standard, or both ways. Only the other way is a slip.
fn same_direction(row: Mapping, base: Mapping) -> bool {
    !row.any() || (row.rx && base.rx) || (row.tx && base.tx)
}

/// Manuals call arrays records and the reverse; a variable is neither.
fn same_shape(a: ObjectKind, b: ObjectKind) -> bool {
    (a == ObjectKind::Var) == (b == ObjectKind::Var)
}
