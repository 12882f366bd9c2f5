//! Answers on a terminal: what a drive's profile knows of an error code, a display, an object, a parameter, a homing method,
//! an erratum or a rule. The views are those of the pages.

use crate::model::Model;

/// What `model` knows of `what`, as text for a terminal; `None` where it knows nothing of it.
pub fn explain(_model: &Model, _what: &str) -> Option<String> {
    None
}
