//! Citations.

pub(super) mod facts_cited;
pub(super) mod lines_in_manual;

use super::finding;
