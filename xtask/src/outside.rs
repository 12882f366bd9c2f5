//! What lies outside of the project and is named by the environment: the makers' manuals and the schemas of the ETG.

use std::path::PathBuf;

/// Names the folder with `<drive>.txt`, the text of the manual, for each drive.
pub const MANUALS: &str = "DRIVEWRIGHT_MANUALS";
/// Names the folder with the schemas of ETG.2000.
pub const SCHEMAS: &str = "ETG_XSD_DIR";

/// The variables that are set, with whole paths: what runs in another folder finds the same place.
pub fn variables() -> impl Iterator<Item = (&'static str, PathBuf)> {
    [MANUALS, SCHEMAS].into_iter().filter_map(|name| Some((name, folder(name)?)))
}

/// The folder that a variable names.
pub fn folder(variable: &str) -> Option<PathBuf> {
    let named = PathBuf::from(std::env::var_os(variable).filter(|v| !v.is_empty())?);
    Some(std::path::absolute(&named).unwrap_or(named))
}
