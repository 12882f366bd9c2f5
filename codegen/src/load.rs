//! Reads a profile's folder into texts. One of the few modules that touch the file system.
//!
//! Takes the `.toml` and `.xml` files of one folder, in name order, not those of folders in it. What cannot be read is a finding,
//! like everything else that is wrong with a profile.

#![allow(clippy::disallowed_methods, reason = "this module reads files for all others")]

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::diag::{Code, Diagnostic, code};
use crate::limits;
use crate::source::{Format, Source, Span};

/// What a folder holds.
#[derive(Clone, Default, Debug)]
pub struct Loaded {
    /// The texts, in path order.
    pub sources: Vec<Source>,
    /// What could not be read.
    pub diagnostics: Vec<Diagnostic>,
    /// Every file and folder that was looked at: a build must run again when one of them changes.
    pub read: Vec<PathBuf>,
}

/// Every drive below a folder of profiles: `<vendor>/<drive>`, in path order. `standard` holds the bases and no drive.
pub fn drives(profiles: &Path) -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for vendor in folders(profiles)? {
        if !vendor.ends_with("standard") {
            found.extend(folders(&vendor)?);
        }
    }
    Ok(found)
}

fn folders(of: &Path) -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(of)? {
        let path = entry?.path();
        if path.is_dir() {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

/// Reads the profile in `folder`.
pub fn folder(folder: &Path) -> Loaded {
    let mut loaded = Loaded { read: vec![folder.to_owned()], ..Loaded::default() };
    let root = match folder.canonicalize() {
        Ok(root) => root,
        Err(error) => {
            loaded.finding(
                code::FILE_MISSING,
                folder,
                &error.to_string(),
                "name the folder that holds `drive.toml`",
            );
            return loaded;
        }
    };
    match files(folder) {
        Err(error) => {
            loaded.finding(code::FILE_MISSING, folder, &error.to_string(), "name a folder that can be read");
        }
        Ok(files) if files.is_empty() => {
            loaded.finding(
                code::FILE_MISSING,
                folder,
                "it holds no `.toml` or `.xml` file",
                "add `drive.toml`",
            );
        }
        Ok(files) if files.len() > limits::FILES => {
            let text = format!("{} files", files.len());
            loaded.finding(
                code::TOO_MANY_FILES,
                folder,
                &text,
                "join tables; a profile has one file a table",
            );
        }
        Ok(files) => files.iter().for_each(|file| loaded.file(&root, file)),
    }
    loaded
}

/// Reads one file, wherever it is. Findings name it as `path` does.
pub fn file(path: &Path) -> Loaded {
    let mut loaded = Loaded { read: vec![path.to_owned()], ..Loaded::default() };
    loaded.text(path);
    loaded.sources.iter_mut().for_each(|source| source.path = shown(path));
    loaded
}

fn files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if Format::of(&shown(&path)).is_some() && !path.is_dir() {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

impl Loaded {
    fn finding(&mut self, code: Code, path: &Path, what: &str, help: &str) {
        let text = format!("{}: {what}", shown(path));
        self.diagnostics.push(
            Diagnostic::new(code, Span::nowhere(), text)
                .why("without it the profile is not whole, and half a profile is a wrong one")
                .help(help),
        );
    }

    fn file(&mut self, root: &Path, path: &Path) {
        self.read.push(path.to_owned());
        match fs::canonicalize(path) {
            Ok(real) if real.starts_with(root) => self.text(path),
            Ok(_) => self.finding(
                code::PATH_OUTSIDE,
                path,
                "the link leads out of the folder",
                "copy the file into it",
            ),
            Err(error) => self.finding(code::FILE_MISSING, path, &error.to_string(), "restore the file"),
        }
    }

    fn text(&mut self, path: &Path) {
        let most = u64::try_from(limits::FILE_BYTES).unwrap_or(u64::MAX);
        match fs::metadata(path) {
            Ok(found) if !found.is_file() => {
                let text = "it is a pipe, socket or device, not a file";
                return self.finding(
                    code::NOT_A_FILE,
                    path,
                    text,
                    "put a file in its place, or name it otherwise",
                );
            }
            Ok(found) if found.len() > most => {
                let text = format!("{} bytes, and a profile file has at most {most}", found.len());
                return self.finding(code::FILE_TOO_LARGE, path, &text, "split the table");
            }
            _ => {}
        }
        match fs::read(path).map(String::from_utf8) {
            Ok(Ok(text)) => {
                let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                self.sources.push(Source { path: name, text });
            }
            Ok(Err(error)) => {
                let at = error.utf8_error().valid_up_to();
                let text = format!("byte {at} is not UTF-8");
                self.finding(code::NOT_UTF8, path, &text, "save the file as UTF-8");
            }
            Err(error) => self.finding(code::FILE_MISSING, path, &error.to_string(), "restore the file"),
        }
    }
}

/// A path as findings print it: with `/` on every system.
fn shown(path: &Path) -> String {
    path.display().to_string().replace('\\', "/")
}
