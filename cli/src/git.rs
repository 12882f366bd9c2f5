//! Reads a revision by calling `git`. Nothing is checked out, and no file of the work tree is touched.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::End;
use crate::output::{disk, tell};

/// What a revision has at a path.
pub(crate) enum Object {
    /// A file.
    Text(String),
    /// A folder, its files written to a folder of their own.
    Folder(Copied),
    /// Nothing.
    Missing,
}

/// A revision of the repository that holds a folder.
pub(crate) struct Revision<'a> {
    name: &'a str,
    at: PathBuf,
}

impl<'a> Revision<'a> {
    /// The revision `name` of the repository that holds the folder `at`. What is wrong is said.
    pub(crate) fn find(name: &'a str, at: &Path) -> Result<Self, End> {
        let found = Self { name, at: at.to_owned() };
        // A name that begins with a hyphen would be an option of git.
        if name.is_empty() || name.starts_with('-') {
            tell!("error: `{name}` is no revision");
            return Err(End::Usage);
        }
        let commit = format!("{name}^{{commit}}");
        let (ok, _) = found.git(&["rev-parse", "--verify", "--quiet", "--end-of-options", &commit])?;
        if !ok {
            tell!("error: git knows no revision `{name}` here\nhelp: `git fetch` it, or name another one");
            return Err(End::Usage);
        }
        Ok(found)
    }

    /// What it has at `path`, which is relative to the root, or with `./` before it to the folder.
    pub(crate) fn object(&self, path: &str) -> Result<Object, End> {
        let place = format!("{}:{path}", self.name);
        let (ok, kind) = self.git(&["cat-file", "-t", &place])?;
        match String::from_utf8_lossy(&kind).trim() {
            "blob" if ok => {
                let (_, bytes) = self.git(&["cat-file", "blob", &place])?;
                String::from_utf8(bytes).map(Object::Text).map_err(|_| {
                    tell!("error: {place} is not UTF-8");
                    End::Findings
                })
            }
            "tree" if ok => self.folder(&place).map(Object::Folder),
            _ => Ok(Object::Missing),
        }
    }

    /// The folders two levels below `path`: `vendor/drive`.
    pub(crate) fn pairs(&self, path: &str) -> Result<Vec<String>, End> {
        let place = format!("{}:{path}", self.name);
        let (ok, names) = self.git(&["ls-tree", "--full-tree", "-rtdz", "--name-only", &place])?;
        let pair = |name: &&str| name.matches('/').count() == 1;
        Ok(split(&names).iter().filter(|_| ok).map(String::as_str).filter(pair).map(str::to_owned).collect())
    }

    fn folder(&self, place: &str) -> Result<Copied, End> {
        let (_, names) = self.git(&["ls-tree", "--full-tree", "-z", "--name-only", place])?;
        let copied = Copied::new().map_err(|e| disk(&e))?;
        let inside = place.trim_end_matches('/');
        for name in split(&names) {
            let (ok, bytes) = self.git(&["cat-file", "blob", &format!("{inside}/{name}")])?;
            // Folders in it are no files, and no part of a profile.
            if ok {
                std::fs::write(copied.folder.join(&name), bytes).map_err(|e| disk(&e))?;
            }
        }
        Ok(copied)
    }

    fn git(&self, arguments: &[&str]) -> Result<(bool, Vec<u8>), End> {
        let output = Command::new("git").args(arguments).current_dir(&self.at).output();
        let output = output.map_err(|e| disk(&format!("`git` cannot be started: {e}")))?;
        Ok((output.status.success(), output.stdout))
    }
}

fn split(names: &[u8]) -> Vec<String> {
    String::from_utf8_lossy(names).split('\0').filter(|n| !n.is_empty()).map(str::to_owned).collect()
}

/// A folder for the time of its use.
pub(crate) struct Copied {
    pub(crate) folder: PathBuf,
}

impl Copied {
    fn new() -> std::io::Result<Self> {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let name = format!("drivewright-{}-{}", std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
        let folder = std::env::temp_dir().join(name);
        // It fails where somebody else has made one.
        std::fs::create_dir(&folder)?;
        Ok(Self { folder })
    }
}

impl Drop for Copied {
    fn drop(&mut self) {
        // What cannot be removed is left to the system.
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}
