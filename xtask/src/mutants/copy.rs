//! A copy of the checkout that may be broken. Only files that differ are written, so that little is built again.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::tidy;

/// Where the copy is, and what of.
pub struct Copy {
    pub from: PathBuf,
    pub to: PathBuf,
}

impl Copy {
    /// Makes the copy equal to the checkout as it is, committed or not.
    pub fn refresh(&self) -> Result<(), String> {
        let wanted: BTreeSet<PathBuf> = tidy::tracked(&self.from).into_iter().collect();
        self.remove_others(&wanted, Path::new("")).map_err(|e| format!("{}: {e}", self.to.display()))?;
        wanted.iter().try_for_each(|path| self.renew(path).map_err(|e| format!("{}: {e}", path.display())))
    }

    fn renew(&self, path: &Path) -> std::io::Result<()> {
        // What git still lists may have been deleted.
        let Ok(bytes) = fs::read(self.from.join(path)) else { return Ok(()) };
        let to = self.to.join(path);
        if fs::read(&to).is_ok_and(|old| old == bytes) {
            return Ok(());
        }
        fs::create_dir_all(to.parent().unwrap_or(&self.to))?;
        fs::write(to, bytes)
    }

    fn remove_others(&self, wanted: &BTreeSet<PathBuf>, folder: &Path) -> std::io::Result<()> {
        fs::create_dir_all(self.to.join(folder))?;
        for entry in fs::read_dir(self.to.join(folder))? {
            let entry = entry?;
            let path = folder.join(entry.file_name());
            if entry.file_type()?.is_dir() {
                self.remove_others(wanted, &path)?;
            } else if !wanted.contains(&path) {
                fs::remove_file(self.to.join(&path))?;
            }
        }
        Ok(())
    }

    /// Puts a patch on the copy, whole or not at all.
    pub fn apply(&self, patch: &Path) -> Result<(), String> {
        let mut git = Command::new("git");
        git.arg("apply").arg(patch).current_dir(&self.to);
        // The copy lies inside a repository and is none.
        git.env("GIT_CEILING_DIRECTORIES", self.to.parent().unwrap_or(&self.to));
        let output = git.output().map_err(|e| format!("`git` cannot be started: {e}"))?;
        let said = String::from_utf8_lossy(&output.stderr);
        let said = said.lines().next().unwrap_or_default();
        if output.status.success() { Ok(()) } else { Err(format!("the patch does not apply: {said}")) }
    }
}
