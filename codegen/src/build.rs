//! Compiles profiles from a build script. One of the few modules that touch the file system and the environment.
//!
//! Cargo is told every file and folder that was read, and nothing else. Only `OUT_DIR` is written, and only where the
//! text differs, so that nothing is compiled again without a reason.

#![allow(
    clippy::disallowed_methods,
    clippy::print_stdout,
    reason = "a build script talks to cargo on its standard output and is told its folder by the environment"
)]

use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};

use crate::backend::rust;
use crate::compile_folder;
use crate::diag::{Diagnostic, Severity, Sink, render};
use crate::sink::{self, SinkError};
use crate::source::SourceMap;

/// Compiles the profile in `folder`, given from the package's root, into `OUT_DIR/<vendor>_<drive>.rs`.
///
/// ```no_run
/// // The whole of `fn main` in build.rs:
/// drivewright_codegen::build("profiles/acme/x1");
/// ```
///
/// ```ignore
/// // src/lib.rs
/// pub mod x1 {
///     include!(concat!(env!("OUT_DIR"), "/acme_x1.rs"));
/// }
/// ```
///
/// Findings become errors and warnings of cargo. With an error the build script ends; nothing is written then.
#[allow(clippy::needless_doctest_main, reason = "a build script has one")]
pub fn build(folder: impl AsRef<Path>) {
    if Build::new().profile(folder).run().is_err() {
        // What is wrong has been said.
        std::process::exit(1);
    }
}

/// A build with more than one profile, or with another folder to write to.
///
/// ```no_run
/// # fn main() -> Result<(), drivewright_codegen::BuildError> {
/// drivewright_codegen::Build::new().profile("profiles/acme/x1").profile("profiles/acme/x2").run()?;
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Default, Debug)]
pub struct Build {
    profiles: Vec<PathBuf>,
    out: Option<PathBuf>,
}

/// Why a build wrote nothing or not all.
#[derive(Debug)]
#[non_exhaustive]
pub enum BuildError {
    /// Profiles have errors: how many.
    Findings(usize),
    /// There is no folder to write to: cargo did not set `OUT_DIR`.
    NoFolder,
    /// Two profiles would write one file.
    SameFile {
        /// The file's name.
        name: String,
        /// Folders of the two profiles.
        profiles: [PathBuf; 2],
    },
    /// The disk refused.
    Disk(SinkError),
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Findings(1) => f.write_str("a profile has an error; nothing was written"),
            Self::Findings(n) => write!(f, "profiles have {n} errors; nothing was written"),
            Self::NoFolder => f.write_str(
                "OUT_DIR is not set: call this from a build script, or name a folder with `out_dir`",
            ),
            Self::SameFile { name, profiles: [first, second] } => write!(
                f,
                "{} and {} both make {name}; nothing was written: change an id of one, or build each into its own folder",
                first.display(),
                second.display()
            ),
            Self::Disk(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for BuildError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Disk(error) => Some(error),
            Self::Findings(_) | Self::NoFolder | Self::SameFile { .. } => None,
        }
    }
}

impl Build {
    /// A build without profiles.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds the profile in `folder`, given from the package's root.
    #[must_use]
    pub fn profile(mut self, folder: impl AsRef<Path>) -> Self {
        self.profiles.push(folder.as_ref().to_owned());
        self
    }

    /// Writes to `folder` and not to `OUT_DIR`.
    #[must_use]
    pub fn out_dir(mut self, folder: impl AsRef<Path>) -> Self {
        self.out = Some(folder.as_ref().to_owned());
        self
    }

    /// Compiles every profile and tells cargo what was read and found. All profiles are compiled before the first file is
    /// written. Returns the files, in the order of the profiles.
    pub fn run(&self) -> Result<Vec<PathBuf>, BuildError> {
        let result = self.files();
        if let Err(error) = &result {
            println!("cargo::error={error}");
        }
        result
    }

    fn files(&self) -> Result<Vec<PathBuf>, BuildError> {
        let compiled: Vec<_> = self.profiles.iter().map(|folder| one(folder)).collect();
        let errors = compiled.iter().filter_map(|c| c.as_ref().err()).sum();
        if errors > 0 {
            return Err(BuildError::Findings(errors));
        }
        let names: Vec<&str> = compiled.iter().flatten().map(|(name, _)| name.as_str()).collect();
        self.apart(&names)?;
        let out = self.out.clone().or_else(|| std::env::var_os("OUT_DIR").map(PathBuf::from));
        let out = out.ok_or(BuildError::NoFolder)?;
        let write = |(name, text): (String, String)| {
            let place = out.join(name);
            sink::write_file(&place, text.as_bytes()).map_err(BuildError::Disk)?;
            Ok(place)
        };
        compiled.into_iter().flatten().map(write).collect()
    }

    /// Each profile has a file of its own: the second of two with one name would replace the first.
    fn apart(&self, names: &[&str]) -> Result<(), BuildError> {
        let mut makers = BTreeMap::new();
        for (name, folder) in names.iter().zip(&self.profiles) {
            if let Some(first) = makers.insert(*name, folder) {
                let profiles = [first.clone(), folder.clone()];
                return Err(BuildError::SameFile { name: (*name).to_owned(), profiles });
            }
        }
        Ok(())
    }
}

/// Name and text of the file that the profile in `folder` gives, or the number of errors. Tells cargo what it reads and
/// finds.
fn one(folder: &Path) -> Result<(String, String), usize> {
    let (compiled, read) = compile_folder(folder);
    for path in &read {
        println!("cargo::rerun-if-changed={}", path.display());
    }
    let mut findings = compiled.diagnostics.clone();
    let emitted = compiled.sound().map(|model| {
        let mut losses = Sink::default();
        let text = rust::single_file(model, &mut losses);
        findings.extend(losses.into_sorted(&SourceMap::default()));
        (format!("{}.rs", model.drive.package.replace('-', "_")), text)
    });
    tell(folder, &findings, &compiled.sources);
    let errors = findings.iter().filter(|d| d.severity() == Severity::Error).count();
    emitted.filter(|_| errors == 0).ok_or(errors.max(1))
}

/// Each finding as a line of its own that names file, line and code; errors once more as they look in a terminal, since
/// cargo shows the standard output of a script that failed.
fn tell(folder: &Path, findings: &[Diagnostic], sources: &SourceMap) {
    for finding in findings {
        println!("cargo::{}={}", finding.severity().word(), line(folder, finding, sources));
    }
    let errors: Vec<Diagnostic> =
        findings.iter().filter(|d| d.severity() == Severity::Error).cloned().collect();
    for line in render::text(&errors, sources, render::Style::default()).lines() {
        println!("  {line}");
    }
}

/// `profiles/x1/objects.toml:3:5: E0402: the message. why. help`.
fn line(folder: &Path, finding: &Diagnostic, sources: &SourceMap) -> String {
    let place = if sources.path(finding.span.file).is_empty() {
        String::new()
    } else {
        let folder = folder.display().to_string().replace('\\', "/");
        format!("{}/{}: ", folder.trim_end_matches('/'), sources.place(finding.span))
    };
    let Diagnostic { code, message, why, help, .. } = finding;
    let text = format!("{place}{}: {message}. Why: {why}. To do: {help}", code.id());
    text.replace(['\n', '\r'], " ")
}
