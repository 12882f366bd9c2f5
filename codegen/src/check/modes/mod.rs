//! Modes of operation.

pub(super) mod modes_agree;
pub(super) mod modes_have_objects;
pub(super) mod modes_listed;

use super::{based_on, finding, settled, unsettled};
