//! Brings a [`FileSet`] to disk, or compares it with what is there. One of the few modules that touch the file system.
//!
//! Each file is written beside its place and moved there, so an interruption leaves it old or new. Files below the
//! folder that the set does not have are orphans: [`write()`] removes them, [`add`] leaves them. Links are never followed.

#![allow(clippy::disallowed_methods, reason = "this module writes files for all others")]

use std::collections::BTreeSet;
use std::fmt;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::emit::FileSet;

/// How a file differs from the set.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum State {
    /// The set has it, the folder does not.
    Missing,
    /// Both have it, with other bytes.
    Changed,
    /// The folder has it, the set does not.
    Orphaned,
}

impl State {
    /// `missing`, `changed` or `orphaned`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Missing => "missing",
            Self::Changed => "changed",
            Self::Orphaned => "orphaned",
        }
    }
}

/// A file that differs.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Difference {
    /// Its path below the folder, with `/`.
    pub path: String,
    /// How it differs.
    pub state: State,
    /// The first line that differs, from 1, where both have the file.
    pub line: Option<usize>,
}

/// Why the disk refused.
#[derive(Debug)]
pub struct SinkError {
    /// What was being done.
    pub action: &'static str,
    /// Where.
    pub path: PathBuf,
    /// What the system said.
    pub source: io::Error,
}

impl fmt::Display for SinkError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot {} {}: {}", self.action, self.path.display(), self.source)
    }
}

impl std::error::Error for SinkError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.source)
    }
}

fn failed<'a>(action: &'static str, path: &'a Path) -> impl FnOnce(io::Error) -> SinkError + 'a {
    move |source| SinkError { action, path: path.to_owned(), source }
}

/// Compares `folder` with `files`; writes nothing.
pub fn check(files: &FileSet, folder: &Path) -> Result<Vec<Difference>, SinkError> {
    let on_disk = list(folder)?;
    let mut found = Vec::new();
    for (path, bytes) in files.iter() {
        let path = path.as_str();
        if !on_disk.contains(path) {
            found.push(Difference { path: path.to_owned(), state: State::Missing, line: None });
            continue;
        }
        let place = folder.join(path);
        let old = plain(&place).map_err(failed("read", &place))?;
        if old.as_deref() != Some(bytes) {
            let line = old.map(|old| first_difference(&old, bytes));
            found.push(Difference { path: path.to_owned(), state: State::Changed, line });
        }
    }
    let wanted: BTreeSet<&str> = files.iter().map(|(p, _)| p.as_str()).collect();
    let orphans = on_disk.iter().filter(|p| !wanted.contains(p.as_str()));
    found.extend(orphans.map(|p| Difference { path: p.clone(), state: State::Orphaned, line: None }));
    found.sort();
    Ok(found)
}

/// The bytes of a file. What is none, such as a link or a pipe, is not read, and equal to nothing.
fn plain(place: &Path) -> io::Result<Option<Vec<u8>>> {
    if fs::symlink_metadata(place)?.is_file() { fs::read(place).map(Some) } else { Ok(None) }
}

/// Makes `folder` hold exactly `files`; returns what differed. Files that are already right are not touched.
pub fn write(files: &FileSet, folder: &Path) -> Result<Vec<Difference>, SinkError> {
    let found = check(files, folder)?;
    bring(files, folder, &found)?;
    remove_empty_folders(folder)?;
    Ok(found)
}

/// Brings `files` to `folder` and leaves every other file there alone, but for what an interrupted run left behind.
pub fn add(files: &FileSet, folder: &Path) -> Result<Vec<Difference>, SinkError> {
    let mut found = check(files, folder)?;
    let leftover = |path: &str| path.strip_suffix(UNFINISHED).is_some_and(|of| files.get(of).is_some());
    found.retain(|d| d.state != State::Orphaned || leftover(&d.path));
    bring(files, folder, &found)?;
    Ok(found)
}

fn bring(files: &FileSet, folder: &Path, found: &[Difference]) -> Result<(), SinkError> {
    // Leftovers of an interrupted run go first: a new unfinished file may want the same name.
    for orphan in found.iter().filter(|d| d.state == State::Orphaned) {
        let place = folder.join(&orphan.path);
        fs::remove_file(&place).map_err(failed("remove", &place))?;
    }
    for difference in found {
        if let Some(bytes) = files.get(&difference.path) {
            replace(&folder.join(&difference.path), bytes)?;
        }
    }
    Ok(())
}

/// Writes one file, whole or not at all, unless it holds these bytes already.
pub fn write_file(place: &Path, bytes: &[u8]) -> Result<(), SinkError> {
    if holds(place, bytes) { Ok(()) } else { replace(place, bytes) }
}

/// Whether there is a file of these bytes.
pub fn holds(place: &Path, bytes: &[u8]) -> bool {
    plain(place).is_ok_and(|old| old.as_deref() == Some(bytes))
}

/// What [`write()`] would change in the file at `path`, as a unified diff.
#[cfg(feature = "diff")]
pub fn unified(files: &FileSet, folder: &Path, path: &str) -> String {
    let old = plain(&folder.join(path)).ok().flatten().unwrap_or_default();
    let (old, new) =
        (String::from_utf8_lossy(&old), String::from_utf8_lossy(files.get(path).unwrap_or_default()));
    let diff = similar::TextDiff::from_lines(old.as_ref(), new.as_ref());
    diff.unified_diff().header(&format!("a/{path}"), &format!("b/{path}")).to_string()
}

/// Marks a file that is being written; one that an interruption left behind is an orphan of the next run.
const UNFINISHED: &str = ".unfinished";

fn replace(place: &Path, bytes: &[u8]) -> Result<(), SinkError> {
    let folder = place.parent().unwrap_or(place);
    fs::create_dir_all(folder).map_err(failed("make", folder))?;
    let mut name = place.file_name().unwrap_or_default().to_owned();
    name.push(UNFINISHED);
    let beside = folder.join(name);
    let mut file = fs::File::create(&beside).map_err(failed("write", &beside))?;
    file.write_all(bytes).and_then(|()| file.sync_all()).map_err(failed("write", &beside))?;
    drop(file);
    fs::rename(&beside, place).map_err(failed("replace", place))
}

/// Every file below `folder`, with `/`; none if there is no such folder. `target` folders are cargo's.
fn list(folder: &Path) -> Result<BTreeSet<String>, SinkError> {
    let mut files = BTreeSet::new();
    let mut open = vec![String::new()];
    while let Some(below) = open.pop() {
        let place = folder.join(&below);
        let entries = match fs::read_dir(&place) {
            Err(error) if error.kind() == io::ErrorKind::NotFound && below.is_empty() => return Ok(files),
            entries => entries.map_err(failed("list", &place))?,
        };
        for entry in entries {
            let entry = entry.map_err(failed("list", &place))?;
            let name = entry.file_name().to_string_lossy().into_owned();
            let path = if below.is_empty() { name.clone() } else { format!("{below}/{name}") };
            let kind = entry.file_type().map_err(failed("look at", &place))?;
            if !kind.is_dir() {
                files.insert(path);
            } else if name != "target" {
                open.push(path);
            }
        }
    }
    Ok(files)
}

fn remove_empty_folders(folder: &Path) -> Result<(), SinkError> {
    let Ok(entries) = fs::read_dir(folder) else { return Ok(()) };
    for entry in entries {
        let entry = entry.map_err(failed("list", folder))?;
        if entry.file_type().map_err(failed("look at", folder))?.is_dir() && entry.file_name() != "target" {
            remove_empty_folders(&entry.path())?;
            let empty = fs::read_dir(entry.path()).is_ok_and(|mut rest| rest.next().is_none());
            if empty {
                fs::remove_dir(entry.path()).map_err(failed("remove", &entry.path()))?;
            }
        }
    }
    Ok(())
}

/// The first line, from 1, in which two texts differ.
fn first_difference(old: &[u8], new: &[u8]) -> usize {
    let same = old.iter().zip(new).take_while(|(a, b)| a == b).count();
    new.get(..same).unwrap_or_default().split(|b| *b == b'\n').count()
}
