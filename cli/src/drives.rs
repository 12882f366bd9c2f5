//! Finds the profiles that a command line names.

use std::path::{Path, PathBuf};

use drivewright_codegen::{Compiled, compile_folder, diag};

use crate::End;

/// A profile, compiled without errors.
pub(crate) struct Found {
    pub(crate) id: String,
    pub(crate) folder: PathBuf,
    pub(crate) compiled: Compiled,
}

/// Where profiles are looked for by id.
const PROFILES: &str = "profiles";

/// Every `profiles/<vendor>/<drive>` below the current folder, in path order.
pub(crate) fn all() -> Vec<PathBuf> {
    let folders = |of: &Path| -> Vec<PathBuf> {
        let entries = std::fs::read_dir(of).into_iter().flatten().flatten();
        let mut found: Vec<PathBuf> = entries.map(|e| e.path()).filter(|p| p.is_dir()).collect();
        found.sort();
        found
    };
    let vendors = folders(Path::new(PROFILES)).into_iter().filter(|v| !v.ends_with("standard"));
    vendors.flat_map(|vendor| folders(&vendor)).collect()
}

/// The folder of the profile that `named` is the id or the folder of. What is wrong is said.
pub(crate) fn folder(named: &str) -> Result<PathBuf, End> {
    let folder = Path::new(named);
    if folder.is_dir() {
        return Ok(folder.to_owned());
    }
    let known = all();
    if let Some(folder) = known.iter().find(|p| p.file_name().is_some_and(|n| n == named)) {
        return Ok(folder.clone());
    }
    let ids: Vec<_> = known.iter().filter_map(|p| p.file_name()).map(|n| n.to_string_lossy()).collect();
    let known = if ids.is_empty() { "none below `profiles/` here".to_owned() } else { ids.join(", ") };
    eprintln!("error: there is no drive or folder `{named}`; known drives: {known}");
    Err(End::Usage)
}

/// The profile that `named` is the id or the folder of, compiled. What is wrong is said.
pub(crate) fn find(named: &str) -> Result<Found, End> {
    folder(named).and_then(open)
}

/// Compiles the profile in `folder`.
pub(crate) fn open(folder: PathBuf) -> Result<Found, End> {
    let (compiled, _) = compile_folder(&folder);
    if let Some(model) = compiled.sound() {
        return Ok(Found { id: model.drive.id.clone(), folder, compiled });
    }
    let summary = diag::render::summary(&compiled.diagnostics).unwrap_or_default();
    eprintln!("error: {} has {summary}: run `drivewright check {0}`", folder.display());
    Err(End::Findings)
}
