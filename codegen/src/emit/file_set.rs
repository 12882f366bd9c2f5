//! The files that a run would write.

use std::collections::BTreeMap;
use std::fmt;

use crate::limits;

/// A path below the output folder: lower-case-safe ASCII parts joined by `/`, no `.`, no `..`, no drive, no backslash.
/// Backends build paths from ids only, so a profile's text can never choose where a file goes.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct RelPath(String);

/// Why a text is not a [`RelPath`].
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct PathError {
    /// The text.
    pub path: String,
}

impl fmt::Display for PathError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "`{}` is not an output path: parts of A-Z a-z 0-9 . _ - joined by `/`, none of them `.` or `..`, at most {} bytes",
            self.path.escape_debug(),
            limits::PATH_BYTES
        )
    }
}

impl std::error::Error for PathError {}

impl RelPath {
    /// Checks `path`.
    pub fn new(path: impl Into<String>) -> Result<Self, PathError> {
        let path = path.into();
        let part_ok = |part: &str| {
            !part.is_empty()
                && part != "."
                && part != ".."
                && part.bytes().all(|b| b.is_ascii_alphanumeric() || b"._-".contains(&b))
        };
        if path.len() <= limits::PATH_BYTES && path.split('/').all(part_ok) {
            Ok(Self(path))
        } else {
            Err(PathError { path })
        }
    }

    /// The path as text.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for RelPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Files by path, in path order.
#[derive(Clone, Default, PartialEq, Eq, Debug)]
pub struct FileSet {
    files: BTreeMap<RelPath, Vec<u8>>,
}

impl FileSet {
    /// Adds a file; a second one at the same path replaces the first.
    pub fn insert(&mut self, path: RelPath, bytes: impl Into<Vec<u8>>) {
        self.files.insert(path, bytes.into());
    }

    /// Adds a file whose path the caller wrote as a literal or built from a checked id.
    pub fn add(&mut self, path: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Result<(), PathError> {
        self.insert(RelPath::new(path)?, bytes);
        Ok(())
    }

    /// The bytes of a file.
    pub fn get(&self, path: &str) -> Option<&[u8]> {
        self.files.iter().find(|(p, _)| p.as_str() == path).map(|(_, b)| b.as_slice())
    }

    /// Every file in path order.
    pub fn iter(&self) -> impl Iterator<Item = (&RelPath, &[u8])> {
        self.files.iter().map(|(p, b)| (p, b.as_slice()))
    }

    /// How many files there are.
    pub fn len(&self) -> usize {
        self.files.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.files.is_empty()
    }

    /// Moves every file of `other` below `folder`.
    pub fn nest(&mut self, folder: &RelPath, other: Self) {
        for (path, bytes) in other.files {
            self.files.insert(RelPath(format!("{folder}/{path}")), bytes);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_stay_below_the_folder() {
        for bad in ["", "/a", "a//b", "../a", "a/..", "a\\b", "C:/a", "a b", "ä", "."] {
            assert!(RelPath::new(bad).is_err(), "{bad}");
        }
        assert!(RelPath::new("eds/sdv3-e.eds").is_ok());
    }
}
