//! Rules between values.

pub(super) mod defaults_obey_rules;

use super::{finding, settled};
