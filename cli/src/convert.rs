//! `drivewright convert`: profile files from one format into the other. All of them are converted before one is written.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use drivewright_codegen::convert::convert;
use drivewright_codegen::diag::render;
use drivewright_codegen::load::{self, Loaded};
use drivewright_codegen::source::{self, FileId, SourceMap};
use drivewright_codegen::{rows, sink};

use crate::End;
use crate::commands::style;
use crate::drives::folder;
use crate::output::{counted, disk, print};

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
pub(crate) fn run(asked: &ConvertArguments, quiet: bool) -> End {
    let out = asked.out.as_deref().filter(|out| *out != Path::new("-"));
    let done = if Path::new(&asked.from).is_file() {
        one(asked, out, quiet)
    } else {
        folder(&asked.from).and_then(|from| all(asked, &from, out, quiet))
    };
    done.unwrap_or_else(|end| end)
}

/// Converts one file.
fn one(asked: &ConvertArguments, out: Option<&Path>, quiet: bool) -> Result<End, End> {
    let converted = texts(load::file(Path::new(&asked.from)), asked.to.into())?;
    let Some((_, text)) = converted.first() else { return Ok(End::Fine) };
    match out {
        None => Ok(print(text)),
        Some(out) => write(&[(out.to_owned(), text)], asked.force, quiet),
    }
}

/// Converts every file of a profile into another folder: two files with the same facts would contradict in one.
fn all(asked: &ConvertArguments, from: &Path, out: Option<&Path>, quiet: bool) -> Result<End, End> {
    let whole = |path: &Path| path.canonicalize().ok();
    let Some(out) = out.filter(|out| whole(out).is_none_or(|out| Some(out) != whole(from))) else {
        eprintln!("error: {} is a profile: name another folder for its files with --out", from.display());
        return Err(End::Usage);
    };
    let converted = texts(load::folder(from), asked.to.into())?;
    let places: Vec<(PathBuf, &str)> =
        converted.iter().map(|(name, text)| (out.join(name), text.as_str())).collect();
    let names: BTreeSet<&PathBuf> = places.iter().map(|(place, _)| place).collect();
    if names.len() < places.len() {
        eprintln!("error: {} has files that differ in their endings only: rename one", from.display());
        return Err(End::Usage);
    }
    write(&places, asked.force, quiet)
}

/// Name and text of each file in the format `to`. Findings are printed.
fn texts(loaded: Loaded, to: source::Format) -> Result<Vec<(String, String)>, End> {
    if !loaded.diagnostics.is_empty() {
        eprint!("{}", render::text(&loaded.diagnostics, &SourceMap::default(), style()));
        return Err(End::Disk);
    }
    let mut sources = SourceMap::default();
    let files: Vec<FileId> = loaded.sources.into_iter().map(|s| sources.add(s.path, s.text)).collect();
    let (mut converted, mut found) = (Vec::new(), Vec::new());
    for file in files {
        match convert(file, &sources, rows::shape, to) {
            Ok(text) => converted.push((renamed(sources.path(file), to), text)),
            Err(findings) => found.extend(findings),
        }
    }
    if found.is_empty() {
        return Ok(converted);
    }
    eprint!("{}", render::text(&found, &sources, style()));
    eprintln!("nothing was written");
    Err(End::Findings)
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
        eprintln!("error: {} is there already: --force replaces it; nothing was written", place.display());
        return Err(End::Usage);
    }
    for (place, text) in files {
        sink::write_file(place, text.as_ref().as_bytes()).map_err(|error| disk(&error))?;
    }
    Ok(if quiet { End::Fine } else { print(&format!("{} written\n", counted(files.len(), "file"))) })
}
