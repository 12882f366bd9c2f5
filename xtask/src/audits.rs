//! Every profile against the text of its manual, where the manuals lie on this machine. They are their makers' and not part
//! of the project: `DRIVEWRIGHT_MANUALS` names their folder.

use std::path::Path;
use std::process::{Command, Stdio};

use crate::Options;
use crate::outcome::Outcome;
use crate::outside::{self, MANUALS};

/// Audits each of `drives`. `step` runs and reports one of them.
pub fn run(
    root: &Path,
    drives: &[String],
    options: &Options,
    step: &mut dyn FnMut(&str, &mut dyn FnMut() -> Outcome),
) {
    for drive in drives {
        step(&format!("audit {drive}"), &mut || audit(root, drive, options.quiet));
    }
}

fn audit(root: &Path, drive: &str, quiet: bool) -> Outcome {
    let Some(folder) = outside::folder(MANUALS) else {
        return Outcome::Skipped(format!("{MANUALS} names no folder with the text of the manual"));
    };
    let manual = folder.join(format!("{drive}.txt"));
    if !manual.exists() {
        return Outcome::Skipped(format!("{} is not there", manual.display()));
    }
    let mut command = Command::new("cargo");
    command.args(["run", "--quiet", "-p", "drivewright", "--", "audit", drive, "--manual"]).arg(manual);
    command.current_dir(root);
    if quiet {
        command.stdout(Stdio::null());
    }
    match command.status() {
        Ok(status) if status.success() => Outcome::Passed,
        Ok(status) => Outcome::Failed(format!("`drivewright audit {drive}` ended with {status}")),
        Err(error) => Outcome::Failed(format!("cargo cannot be started: {error}")),
    }
}
