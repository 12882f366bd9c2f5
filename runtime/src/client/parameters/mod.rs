//! Parameter sets: what a machine wants of a drive, compared, written in an order that no rule forbids, and stored.
//!
//! - [`Columns`] reads every entry and gives device, default and wanted value.
//! - [`Apply`] writes what differs. It checks everything before it writes anything: access, limits, lists, the rules of the
//!   drive. It orders the writes, reads back what it wrote, and after a refusal says which writes were made.
//! - [`Store`] makes the drive keep its parameters, and sees that no target is kept with them.
//!
//! Commands have no place in a set: a drive that keeps a target moves at its next enable.

mod apply;
mod columns;
mod error;
mod order;
mod store;

pub use apply::{Applied, Apply};
pub use columns::{Columns, ColumnsSummary, Row, RowText};
pub use error::{SetCause, SetError, SetReport};
pub use order::Slot;
pub use store::{Store, StoreCause, StoreError, Stored};

use crate::address::Address;
use crate::client::object::Content;

/// What an entry should hold.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Setting<'w> {
    /// The entry.
    pub address: Address,
    /// Its value.
    pub value: Content<'w>,
}

impl<'w> Setting<'w> {
    /// A raw number.
    pub const fn number(address: Address, value: i128) -> Self {
        Self { address, value: Content::Int(value) }
    }

    /// A text, without a terminator.
    pub const fn text(address: Address, value: &'w str) -> Self {
        Self { address, value: Content::Bytes(value.as_bytes()) }
    }
}

/// The index of an object of CiA 402 on the first axis: each axis has 800h indexes.
const fn on_first_axis(index: u16) -> u16 {
    match index {
        0x6000..=0x9FFF => 0x6000 | (index & 0x07FF),
        other => other,
    }
}

/// Whether an entry commands the drive instead of setting it up: controlword, mode, targets and their offsets, outputs,
/// store and restore.
///
/// ```
/// use drivewright_runtime::client::parameters::is_command;
/// use drivewright_runtime::Address;
///
/// assert!(is_command(Address::new(0x607A, 0)));
/// assert!(is_command(Address::new(0x687A, 0)), "of the second axis");
/// assert!(!is_command(Address::new(0x607D, 1)));
/// ```
pub const fn is_command(address: Address) -> bool {
    match on_first_axis(address.index()) {
        0x1010
        | 0x1011
        | 0x6040
        | 0x6042
        | 0x6060
        | 0x6071
        | 0x607A
        | 0x60B0..=0x60B2
        | 0x60B8
        | 0x60C1
        | 0x60FF => true,
        // Sub-index 2 is the mask, which is set up once.
        0x60FE => address.sub() == 1,
        _ => false,
    }
}

/// Whether an entry is part of the mapping of process data, which has an order of its own:
/// [`layout::Write`](crate::client::layout::Write).
const fn is_mapping(address: Address) -> bool {
    matches!(address.index(), 0x1600..=0x17FF | 0x1A00..=0x1BFF | 0x1C10..=0x1C2F)
}

#[cfg(test)]
mod tests;
