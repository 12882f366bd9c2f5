//! What a Rust crate cannot say. Each is a warning; nothing is dropped in silence.

use crate::diag::{Code, Diagnostic};
use crate::model::{Entry, Pdo};

/// A layout that has no type.
const LAYOUT: Code = Code::warning("W1201", "a PDO has no typed layout");
/// A limit that a handle cannot hold.
const LIMIT: Code = Code::warning("W1202", "a limit does not fit a handle");
/// Named values or bits without a type of their own.
const MEANING: Code = Code::warning("W1203", "named values or bits are not typed at an entry");

/// Every code of this backend.
pub(super) const ALL: &[Code] = &[LAYOUT, LIMIT, MEANING];

pub(super) fn layout(pdo: &Pdo) -> Diagnostic {
    let span = pdo.origin.span;
    Diagnostic::new(
        LAYOUT,
        span,
        format!("PDO {:04X} carries an entry that is not one or more whole bytes", pdo.index),
    )
    .why("typed layouts are packed by byte; the table `MODEL` still holds the mapping")
    .help("pack and unpack this PDO by hand, from `MODEL.pdos()`")
}

pub(super) fn limit(entry: &Entry) -> Diagnostic {
    let text = format!("a limit or listed value of `{}` is above what 63 bits hold", entry.address);
    Diagnostic::new(LIMIT, entry.ty.span(), text)
        .why("handles hold limits as i64; the table `MODEL` has the full value")
        .help("check values of this entry against `MODEL`")
}

pub(super) fn meaning(entry: &Entry, table: &str) -> Diagnostic {
    let text = format!(
        "`{}` is a plain {}, although `{table}` names its values or bits",
        entry.address, entry.ty.value
    );
    Diagnostic::new(MEANING, entry.ty.span(), text)
        .why("the table is typed for another width, or the width has no primitive type")
        .help("convert the number with the table's own type")
}
