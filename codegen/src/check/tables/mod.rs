//! Value tables.

pub(super) mod allowed_named;
pub(super) mod tables_differ;

use super::finding;
