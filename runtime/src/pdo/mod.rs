//! Process data: which entries, in which order, at which byte.
//!
//! A layout is a struct made by [`pdo_layout!`](crate::pdo_layout!). Limits and directions are checked when the layout
//! is compiled; what the drive really holds is checked by [`compare`] before it is used.

mod compare;
mod entry;
mod layout;

pub use compare::{compare, LayoutMismatch};
pub use entry::MapEntry;
pub use layout::{byte_len, bytes_are_whole, offset_of, offsets, put, take, ProcessData};
