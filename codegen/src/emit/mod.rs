//! Output in memory: a map from relative path to bytes. Only [`crate::sink`] brings it to disk.

pub mod escape;
pub mod file_set;
mod wrap;

pub use file_set::{AddError, FileSet, PathError, RelPath};
pub use wrap::wrap;
