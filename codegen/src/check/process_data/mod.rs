//! PDO mappings.

pub(super) mod assigned_pdos_exist;
pub(super) mod pdo_bits_fit;
pub(super) mod pdo_entry_accessible;
pub(super) mod pdo_entry_mappable;
pub(super) mod pdo_fits_bytes;
pub(super) mod pdo_fits_entries;
pub(super) mod pdo_fits_frame;
pub(super) mod pdo_matches_object;
pub(super) mod pdo_positions_in_row;

use super::{based_on, finding, mapped, mapped_row, settled};
