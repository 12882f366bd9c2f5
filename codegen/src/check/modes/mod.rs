//! Modes of operation.

pub(super) mod modes_agree;

use super::finding;
