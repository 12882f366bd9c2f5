//! Names of generated code.

pub(super) mod name_starts_with_letter;

use super::finding;
