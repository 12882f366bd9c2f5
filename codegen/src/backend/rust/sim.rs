//! `sim.rs`: the drive without hardware, behind the feature `sim`. It is of the whole crate only: the features of a crate
//! that includes one file are its own.

use super::Module;
use super::lower::Lowered;
use crate::emit::escape::rust_doc;

/// The feature that adds it.
pub(super) const FEATURE: &str = "sim";

pub(super) fn module(lowered: &Lowered<'_>) -> Module {
    let drive = rust_doc(&lowered.model.drive.name);
    let entries = lowered.handles.len().to_string();
    Module {
        name: "sim",
        doc: format!(
            "The {drive} without hardware: a virtual drive that is this model. Feature `{FEATURE}`."
        ),
        // The drive's own text last: nothing of it is replaced.
        body: include_str!("res/sim.rs.in")
            .replace("ENTRIES", &entries)
            .replace("PACKAGE", &lowered.model.drive.package.replace('-', "_"))
            .replace("DRIVE", &drive),
        feature: Some(FEATURE),
    }
}
