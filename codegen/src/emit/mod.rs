//! Output in memory: a map from relative path to bytes. Only [`crate::sink`] brings it to disk.

pub mod escape;
pub mod file_set;

pub use file_set::{AddError, FileSet, PathError, RelPath};
