//! The neighbours: each a small program of its own below `peers/`, so that one that cannot be fetched stops nothing.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::{child, feed, synthetic};

/// A neighbour whose program stands ready.
pub struct Peer {
    pub name: &'static str,
    program: PathBuf,
}

/// What it makes of a drive.
pub struct Made {
    pub seconds: f64,
    pub memory: u64,
    /// The file that it wrote.
    pub code: String,
}

/// Builds the program of `name`.
pub fn build(name: &'static str, here: &Path, target: &Path) -> Result<Peer, Box<dyn Error>> {
    let mut cargo = Command::new("cargo");
    cargo.args(["build", "--release", "--locked", "--quiet"]).current_dir(here.join("peers").join(name));
    child::run(cargo.arg("--target-dir").arg(target))?;
    let program = format!("peer-{name}{}", std::env::consts::EXE_SUFFIX);
    Ok(Peer { name, program: target.join("release").join(program) })
}

impl Peer {
    /// Feeds it a drive of `entries`; the time is the least of `runs`.
    pub fn make(&self, entries: usize, runs: usize, scratch: &Path) -> Result<Made, Box<dyn Error>> {
        let drive = synthetic::drive(entries);
        let text =
            if self.name == "svd2rust" { feed::svd::write(&drive) } else { feed::zencan::write(&drive) };
        let (input, output) =
            (scratch.join(format!("{}.in", self.name)), scratch.join(format!("{}.rs", self.name)));
        std::fs::write(&input, text)?;
        let run = |runs: usize| {
            child::run(Command::new(&self.program).args([&input, &output]).arg(runs.to_string()))
        };
        let memory = run(1)?.memory;
        let seconds = run(runs)?.text.lines().filter_map(|l| l.parse().ok()).collect();
        Ok(Made { seconds: child::least(seconds), memory, code: std::fs::read_to_string(&output)? })
    }

    /// The manifest of a crate that holds what it generates.
    pub fn manifest(&self) -> &'static str {
        match self.name {
            "svd2rust" => {
                "[package]\nname = \"made-svd2rust\"\nversion = \"0.0.0\"\nedition = \"2021\"\n[workspace]\n[features]\nrt = []\n[dependencies]\nvcell = \"0.1.3\"\n"
            }
            _ => {
                "[package]\nname = \"made-zencan\"\nversion = \"0.0.0\"\nedition = \"2021\"\n[workspace]\n[dependencies]\nzencan-node = \"0.0.5\"\n"
            }
        }
    }
}
