//! The standard bases of drivewright: objects, values and bits that CiA 301, CiA 402 and CoE fix for every drive.
//!
//! Data only: the texts are carried inside of the crate, so that a published compiler needs no files beside it.
//! Types and widths come from the standards; limits, defaults and subsets belong to drives.

#![no_std]

/// A base profile.
#[derive(Clone, Copy, Debug)]
pub struct Base {
    /// The name by which a drive refers to it.
    pub name: &'static str,
    /// Its files: path, as findings print it, and text.
    pub files: &'static [(&'static str, &'static str)],
}

macro_rules! base {
    ($name:literal: $($file:literal)+) => {
        Base {
            name: $name,
            files: &[$((
                concat!("standard/", $name, "/", $file),
                include_str!(concat!("../", $name, "/", $file)),
            )),+],
        }
    };
}

/// Every base.
const BASES: &[Base] = &[
    base!("cia301": "objects.toml" "enums.toml" "bits.toml" "aborts.toml"),
    base!("cia402": "objects.toml" "enums.toml" "bits.toml" "modes.toml" "states.toml" "commands.toml" "homing.toml"),
    base!("coe": "objects.toml" "aborts.toml"),
];

/// Every base, in the order in which drives name them.
pub fn bases() -> &'static [Base] {
    BASES
}
