//! The files that a run would write.

use std::borrow::Borrow;
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

impl Borrow<str> for RelPath {
    fn borrow(&self) -> &str {
        &self.0
    }
}

/// Why a file was not added.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum AddError {
    /// The path is none.
    Path(PathError),
    /// There is a file at that path already.
    Taken(RelPath),
}

impl fmt::Display for AddError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Path(error) => error.fmt(f),
            Self::Taken(path) => write!(f, "`{path}` is written twice"),
        }
    }
}

impl std::error::Error for AddError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Path(error) => Some(error),
            Self::Taken(_) => None,
        }
    }
}

/// Files by path, in path order.
#[derive(Clone, Default, PartialEq, Eq, Debug)]
pub struct FileSet {
    files: BTreeMap<RelPath, Vec<u8>>,
    /// Paths at which a second file was refused.
    taken: Vec<RelPath>,
}

impl FileSet {
    /// Adds a file whose path the caller wrote as a literal or built from a checked id. The first file at a path stays.
    pub fn add(&mut self, path: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Result<(), AddError> {
        let path = RelPath::new(path).map_err(AddError::Path)?;
        if self.files.contains_key(&path) {
            self.taken.push(path.clone());
            return Err(AddError::Taken(path));
        }
        self.files.insert(path, bytes.into());
        Ok(())
    }

    /// Paths at which a second file was refused, whether or not the caller listened.
    pub fn taken(&self) -> &[RelPath] {
        &self.taken
    }

    /// The bytes of a file.
    pub fn get(&self, path: &str) -> Option<&[u8]> {
        self.files.get(path).map(Vec::as_slice)
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

    #[test]
    fn a_second_file_at_a_path_is_refused() {
        let mut files = FileSet::default();
        assert_eq!(files.add("a", "first"), Ok(()));
        assert!(matches!(files.add("a", "second"), Err(AddError::Taken(path)) if path.as_str() == "a"));
        assert!(matches!(files.add("../a", ""), Err(AddError::Path(_))));
        assert_eq!((files.get("a"), files.get("b")), (Some(&b"first"[..]), None));
        assert_eq!(files.taken().len(), 1);
    }
}
