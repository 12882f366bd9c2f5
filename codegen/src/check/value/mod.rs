//! Values, limits, defaults, value names and bits of one entry.

pub(super) mod allowed_in_range;
pub(super) mod bits_apart;
pub(super) mod bits_fit_type;
pub(super) mod default_allowed;
pub(super) mod default_fits_type;
pub(super) mod default_in_range;
pub(super) mod default_of_kind;
pub(super) mod limits_fit_type;
pub(super) mod limits_in_order;
pub(super) mod limits_on_numbers;
pub(super) mod quantities_have_units;
pub(super) mod values_fit_type;

use super::{based_on, finding, fits};
