//! Terminals.

pub(super) mod pins_differ;
pub(super) mod terminal_parameter;

use super::{finding, unsettled};
