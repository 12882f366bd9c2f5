//! Worked examples of the manual.

pub(super) mod mapping_words_agree;
pub(super) mod writes_accepted;

use super::{finding, settled};
