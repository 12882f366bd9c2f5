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

/// The profile that `named` is the id or the folder of. What is wrong is said.
pub(crate) fn find(named: &str) -> Result<Found, End> {
    let folder = Path::new(named);
    let folder = if folder.is_dir() {
        folder.to_owned()
    } else {
        let known = all();
        let Some(folder) = known.iter().find(|p| p.file_name().is_some_and(|n| n == named)) else {
            let ids: Vec<_> =
                known.iter().filter_map(|p| p.file_name()).map(|n| n.to_string_lossy()).collect();
            let known = if ids.is_empty() { "none below `profiles/`".to_owned() } else { ids.join(", ") };
            eprintln!("error: there is no drive or folder `{named}`; known: {known}");
            return Err(End::Usage);
        };
        folder.clone()
    };
    open(folder)
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
