//! The state machine of CiA 402.

pub(super) mod commands_fit;
pub(super) mod standard_words;
pub(super) mod states_apart;

use super::{finding, settled};
