//! The shape of the object dictionary.

pub(super) mod count_is_highest;
pub(super) mod count_is_u8;
pub(super) mod count_present;
pub(super) mod device_type_whole;
pub(super) mod identity_present;
pub(super) mod kind_fits_entries;

use super::{based_on, finding, settled};
