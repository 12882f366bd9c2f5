//! Parameters of the panel and their objects.

pub(super) mod parameters_in_place;

use super::{finding, unsettled};
