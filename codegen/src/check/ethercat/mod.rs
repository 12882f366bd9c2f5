//! What a drive is on the bus, besides its dictionary.

pub(super) mod control_fits_use;
pub(super) mod emcy_whole;
pub(super) mod startup_accepted;
pub(super) mod sync_managers_apart;
pub(super) mod sync_managers_whole;

use super::finding;
