//! Finds the profiles that a command line names.

use std::path::{Path, PathBuf};

use drivewright_codegen::{Compiled, compile_folder, diag, load};

use crate::End;
use crate::output::tell;

/// A profile, compiled without errors.
pub(crate) struct Found {
    pub(crate) id: String,
    pub(crate) folder: PathBuf,
    pub(crate) compiled: Compiled,
}

/// Where profiles are looked for by id.
const PROFILES: &str = "profiles";

/// Every `profiles/<vendor>/<drive>` below the current folder, in path order; none where there is no such folder.
pub(crate) fn all() -> Vec<PathBuf> {
    load::drives(Path::new(PROFILES)).unwrap_or_default()
}

/// The folders of the profiles that are `named`, or of all when none is. What is wrong is said.
pub(crate) fn folders(named: &[String]) -> Result<Vec<PathBuf>, End> {
    if !named.is_empty() {
        return named.iter().map(|one| folder(one)).collect();
    }
    let all = all();
    if all.is_empty() {
        tell!("error: there is no drive below `profiles/`; name a profile's folder");
        return Err(End::Usage);
    }
    Ok(all)
}

/// The folder of the profile that `named` is the id or the folder of. What is wrong is said.
pub(crate) fn folder(named: &str) -> Result<PathBuf, End> {
    let folder = Path::new(named);
    if folder.is_dir() {
        return Ok(folder.to_owned());
    }
    let known = all();
    let listed = |of: &mut dyn Iterator<Item = &PathBuf>| of.map(|p| id(p)).collect::<Vec<_>>().join(", ");
    // `sdv3-e`, or `savch/sdv3-e` where two makers have one.
    let meant = |p: &&PathBuf| p.ends_with(named);
    match known.iter().filter(meant).collect::<Vec<_>>().as_slice() {
        [one] => return Ok((*one).clone()),
        [] => {
            let known = if known.is_empty() {
                "none below `profiles/` here".to_owned()
            } else {
                listed(&mut known.iter())
            };
            tell!("error: there is no drive or folder `{named}`; known drives: {known}");
        }
        several => {
            tell!("error: `{named}` is one of several drives: {}", listed(&mut several.iter().copied()));
        }
    }
    Err(End::Usage)
}

/// `savch/sdv3-e`
fn id(folder: &Path) -> String {
    let parts = folder.strip_prefix(PROFILES).unwrap_or(folder);
    parts.display().to_string().replace('\\', "/")
}

/// The profile that `named` is the id or the folder of, compiled. What is wrong is said.
pub(crate) fn find(named: &str) -> Result<Found, End> {
    folder(named).and_then(open)
}

/// The profiles that are `named`, or all when none is, compiled. What is wrong is said.
pub(crate) fn find_all(named: &[String]) -> Result<Vec<Found>, End> {
    folders(named)?.into_iter().map(open).collect()
}

/// Compiles the profile in `folder`.
fn open(folder: PathBuf) -> Result<Found, End> {
    let (compiled, _) = compile_folder(&folder);
    if let Some(model) = compiled.sound() {
        return Ok(Found { id: model.drive.id.clone(), folder, compiled });
    }
    let summary = diag::render::summary(&compiled.diagnostics).unwrap_or_default();
    tell!("error: {} has {summary}: run `drivewright check {0}`", folder.display());
    Err(End::Findings)
}
