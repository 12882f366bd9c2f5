//! The rows that may say a value of an object.

use crate::rows::tables::ObjectRow;
use crate::source::Sp;

/// A row of a base, with the base's name.
pub(super) type BaseRow<'a> = (&'a str, &'a ObjectRow);

/// Who may state a value, the most exact first.
#[derive(Clone, Copy)]
pub(super) struct Stated<'a> {
    /// The drive's row for the address.
    pub(super) row: &'a ObjectRow,
    /// The drive's row for a range that it refines.
    pub(super) range: Option<&'a ObjectRow>,
    /// The base's row.
    pub(super) base: Option<BaseRow<'a>>,
}

impl<'a> Stated<'a> {
    /// What the drive's rows state.
    pub(super) fn own<T>(self, get: impl Fn(&'a ObjectRow) -> Option<&'a Sp<T>>) -> Option<&'a Sp<T>> {
        get(self.row).or_else(|| self.range.and_then(get))
    }
}
