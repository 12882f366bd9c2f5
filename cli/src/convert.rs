//! `drivewright convert`: profile files from one format into the other. All of them are converted before one is written.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use drivewright_codegen::convert::convert;
use drivewright_codegen::diag::Diagnostic;
use drivewright_codegen::load::{self, Loaded};
use drivewright_codegen::source::{self, FileId, SourceMap};
use drivewright_codegen::{rows, sink};

use crate::End;
use crate::arguments::Format as Findings;
use crate::commands::findings;
use crate::drives::folder;
use crate::output::{counted, disk, print, tell};

/// What `convert` is asked for.
#[derive(Args)]
pub(crate) struct ConvertArguments {
    /// A file, the id of a drive below `profiles/`, or a profile's folder.
    from: String,
    /// The format to write.
    #[arg(long, value_enum)]
    to: Format,
    /// The file to write, or for a drive the folder. Left out or `-`, the text of a file goes to standard output.
    #[arg(long)]
    out: Option<PathBuf>,
    /// Replace files that are there.
    #[arg(long)]
    force: bool,
}

/// A format of profile files.
#[derive(Clone, Copy, ValueEnum)]
enum Format {
    Toml,
    Xml,
}

impl From<Format> for source::Format {
    fn from(format: Format) -> Self {
        match format {
            Format::Toml => Self::Toml,
            Format::Xml => Self::Xml,
        }
    }
}

/// Runs the command.
pub(crate) fn run(asked: &ConvertArguments, findings: Findings, quiet: bool) -> End {
    // For programs, standard output is for findings.
    let quiet = quiet || findings != Findings::Human;
    let out = asked.out.as_deref().filter(|out| *out != Path::new("-"));
    let done = if Path::new(&asked.from).is_file() {
        one(asked, out, findings, quiet)
    } else {
        folder(&asked.from).and_then(|from| all(asked, &from, out, findings, quiet))
    };
    done.unwrap_or_else(|end| end)
}

/// Converts one file.
fn one(asked: &ConvertArguments, out: Option<&Path>, findings: Findings, quiet: bool) -> Result<End, End> {
    let converted = texts(load::file(Path::new(&asked.from)), asked, findings)?;
    let Some((_, text)) = converted.first() else { return Ok(End::Fine) };
    match out {
        None => Ok(print(text)),
        Some(out) => write(&[(out.to_owned(), text)], asked.force, quiet),
    }
}

/// Converts every file of a profile into another folder: two files with the same facts would contradict in one.
fn all(
    asked: &ConvertArguments,
    from: &Path,
    out: Option<&Path>,
    findings: Findings,
    quiet: bool,
) -> Result<End, End> {
    let whole = |path: &Path| path.canonicalize().ok();
    let Some(out) = out.filter(|out| whole(out).is_none_or(|out| Some(out) != whole(from))) else {
        tell!("error: {} is a profile: name another folder for its files with --out", from.display());
        return Err(End::Usage);
    };
    let converted = texts(load::folder(from), asked, findings)?;
    let places: Vec<(PathBuf, &str)> =
        converted.iter().map(|(name, text)| (out.join(name), text.as_str())).collect();
    let names: BTreeSet<&PathBuf> = places.iter().map(|(place, _)| place).collect();
    if names.len() < places.len() {
        tell!("error: {} has files that differ in their endings only: rename one", from.display());
        return Err(End::Usage);
    }
    write(&places, asked.force, quiet)
}

/// Name and text of each file in the format that is asked for. Findings are printed.
fn texts(loaded: Loaded, asked: &ConvertArguments, format: Findings) -> Result<Vec<(String, String)>, End> {
    let to = asked.to.into();
    let mut sources = SourceMap::default();
    let refuse = |found: &[Diagnostic], sources: &SourceMap, end: End| {
        let shown = findings(found, sources, "", &asked.from, format);
        tell!("nothing was written");
        Err(shown.max(end))
    };
    if !loaded.diagnostics.is_empty() {
        return refuse(&loaded.diagnostics, &sources, End::Disk);
    }
    let files: Vec<FileId> = loaded.sources.into_iter().map(|s| sources.add(s.path, s.text)).collect();
    let (mut converted, mut found) = (Vec::new(), Vec::new());
    for file in files {
        match convert(file, &sources, rows::shape, to) {
            Ok(text) => converted.push((renamed(sources.path(file), to), text)),
            Err(findings) => found.extend(findings),
        }
    }
    if found.is_empty() { Ok(converted) } else { refuse(&found, &sources, End::Findings) }
}

/// Place and text of the file `name` of TOML in a profile: as XML where that file is there as XML, so that there is one.
pub(crate) fn in_place_of(profile: &Path, name: &str, text: String) -> (PathBuf, String) {
    let place = profile.join(renamed(name, source::Format::Xml));
    let mut sources = SourceMap::default();
    let file = sources.add(name, text.as_str());
    match convert(file, &sources, rows::shape, source::Format::Xml) {
        Ok(xml) if place.exists() => (place, xml),
        _ => (profile.join(name), text),
    }
}

/// The name of a file in another format.
fn renamed(name: &str, to: source::Format) -> String {
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    format!("{stem}.{}", to.extension())
}

fn write<T: AsRef<str>>(files: &[(PathBuf, T)], force: bool, quiet: bool) -> Result<End, End> {
    if let Some((place, _)) = files.iter().find(|(place, _)| place.exists() && !force) {
        tell!("error: {} is there already: --force replaces it; nothing was written", place.display());
        return Err(End::Usage);
    }
    for (place, text) in files {
        sink::write_file(place, text.as_ref().as_bytes()).map_err(|error| disk(&error))?;
    }
    Ok(if quiet { End::Fine } else { print(&format!("{} written\n", counted(files.len(), "file"))) })
}
