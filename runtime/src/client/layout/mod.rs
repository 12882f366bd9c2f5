//! Layouts of process data on a drive: read back and compared before they are used, and written in the order of the
//! standard.
//!
//! A [`Plan`] is what a program wants to exchange in one direction. [`ReadBack`] proves that the drive has it; until then
//! every byte may mean something else. [`Write`] gives it to the drive.

mod plan;
mod read_back;
mod write;

pub use plan::{Mapped, Plan, PlanCause, PlanError};
pub use read_back::{LayoutCause, LayoutError, LayoutReport, ReadBack};
pub use write::{Write, WriteError};

use crate::address::Address;
use crate::mapping::Direction;

/// The most entries of a mapping object, CiA 301.
pub const MAX_ENTRIES: usize = 64;

/// The object that assigns PDOs to a direction: 1C12h for what the drive receives, 1C13h for what it sends.
pub const fn assignment(direction: Direction, sub: u8) -> Address {
    match direction {
        Direction::Rx => Address::new(0x1C12, sub),
        Direction::Tx => Address::new(0x1C13, sub),
    }
}

#[cfg(test)]
mod tests;
