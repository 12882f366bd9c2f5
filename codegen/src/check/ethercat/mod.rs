//! What a drive is on the bus, besides its dictionary.

pub(super) mod emcy_whole;
pub(super) mod sync_managers_whole;

use super::finding;
