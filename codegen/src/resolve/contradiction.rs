//! In what a row contradicts the standard object. What either of the two leaves open is no contradiction.

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

/// The first contradiction of `row` and the row of a base.
pub(super) fn find(row: &ObjectRow, base: &ObjectRow) -> Option<Contradiction> {
    let (ty, unit) = ((row.ty.as_ref(), base.ty.as_ref()), (row.unit.as_ref(), base.unit.as_ref()));
    differ("type", ty, |a, b| a == b, ToString::to_string)
        .or_else(|| {
            differ("access", (row.access.as_ref(), base.access.as_ref()), same_access, |a| a.word().into())
        })
        .or_else(|| differ("pdo", (row.pdo.as_ref(), base.pdo.as_ref()), same_direction, |m| m.word().into()))
        .or_else(|| differ("kind", (row.kind.as_ref(), base.kind.as_ref()), same_shape, |k| k.word().into()))
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
fn same_access(a: &Access, b: &Access) -> bool {
    let plain = |access: &Access| if *access == Access::Const { Access::Ro } else { *access };
    plain(a) == plain(b)
}

/// A drive may map less than the standard, or both ways. Only the other way is a slip.
fn same_direction(row: &Mapping, base: &Mapping) -> bool {
    !row.any() || (row.rx && base.rx) || (row.tx && base.tx)
}

/// Manuals call arrays records and the reverse; a variable is neither.
fn same_shape(a: &ObjectKind, b: &ObjectKind) -> bool {
    (*a == ObjectKind::Var) == (*b == ObjectKind::Var)
}
