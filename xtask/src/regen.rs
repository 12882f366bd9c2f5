//! Compiles every profile to every output. One line a drive.

use std::fs;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};

use drivewright_codegen::diag::{Diagnostic, Severity, render};
use drivewright_codegen::emit::FileSet;
use drivewright_codegen::schema::profile_schema;
use drivewright_codegen::sink::{self, Difference, SinkError, State};
use drivewright_codegen::source::SourceMap;
use drivewright_codegen::{backend, compile, emit, load};

use crate::{End, Options};

/// Compiles the profiles that `options` names, or all, and brings `generated/` in line or compares it.
pub fn run(root: &Path, options: &Options) -> End {
    let profiles = match profiles(root) {
        Ok(profiles) => profiles,
        Err(error) => return disk(&error),
    };
    let unknown = options.drives.iter().find(|d| !profiles.iter().any(|p| &p.id == *d));
    if let Some(drive) = unknown {
        let known: Vec<&str> = profiles.iter().map(|p| p.id.as_str()).collect();
        eprintln!("error: there is no drive `{drive}`; known: {}", known.join(", "));
        return End::Usage;
    }
    let mut end = End::Fine;
    let mut packages = Vec::new();
    for profile in &profiles {
        let wanted = options.drives.is_empty() || options.drives.contains(&profile.id);
        match self::profile(profile, root, options, wanted) {
            Ok((package, one)) => {
                packages.extend(package);
                end = end.max(one);
            }
            Err(error) => return disk(&error),
        }
    }
    if options.drives.is_empty() {
        end = end.max(strays(root, &packages, options));
        match schemas(root, options) {
            Ok(one) => end = end.max(one),
            Err(error) => return disk(&error),
        }
    }
    end
}

/// The JSON schemas of profiles and of `model.json`.
fn schemas(root: &Path, options: &Options) -> Result<End, SinkError> {
    let mut files = FileSet::default();
    for (path, text) in
        [("profile.schema.json", profile_schema()), ("model.schema.json", backend::json::model_schema())]
    {
        // Both paths are literals that every RelPath rule allows.
        let _ = files.add(path, text);
    }
    let folder = root.join("codegen/schema");
    let found = if options.check || options.diff {
        sink::check(&files, &folder)?
    } else {
        sink::write(&files, &folder)?
    };
    if !found.is_empty() {
        println!("schemas: {}", changes(&found, options));
    }
    Ok(report(&files, &folder, &found, options))
}

fn disk(error: &dyn std::fmt::Display) -> End {
    eprintln!("error: {error}");
    End::Disk
}

struct Profile {
    /// `sdv3-e`
    id: String,
    folder: PathBuf,
}

/// Every `profiles/<vendor>/<drive>`, in path order.
fn profiles(root: &Path) -> std::io::Result<Vec<Profile>> {
    let mut found = Vec::new();
    for vendor in folders(&root.join("profiles"))? {
        if vendor.file_name().is_some_and(|n| n == "standard") {
            continue;
        }
        for folder in folders(&vendor)? {
            let id = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
            found.push(Profile { id, folder });
        }
    }
    Ok(found)
}

/// The id of every drive; none where the folder of profiles cannot be read, which `regen` reports.
pub fn drives(root: &Path) -> Vec<String> {
    profiles(root).unwrap_or_default().into_iter().map(|profile| profile.id).collect()
}

fn folders(of: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(of)? {
        let entry = entry?;
        if entry.file_type()?.is_dir() {
            found.push(entry.path());
        }
    }
    found.sort();
    Ok(found)
}

/// Compiles one profile; gives the package's name, so that folders that no profile makes can be found.
fn profile(
    profile: &Profile,
    root: &Path,
    options: &Options,
    wanted: bool,
) -> Result<(Option<String>, End), SinkError> {
    let loaded = load::folder(&profile.folder);
    let compiled = compile(loaded.sources);
    let mut findings = loaded.diagnostics;
    findings.extend(compiled.diagnostics.iter().cloned());
    let unreadable = findings.iter().any(|d| d.severity() == Severity::Error);
    let package = compiled.model.as_ref().map(|m| m.drive.package.clone());
    let (Some(model), false) = (compiled.sound(), unreadable) else {
        if wanted {
            show(profile, root, &findings, &compiled.sources);
            eprintln!(
                "{}: {}; nothing was written",
                profile.id,
                render::summary(&findings).unwrap_or_default()
            );
        }
        return Ok((package, if wanted { End::Findings } else { End::Fine }));
    };
    if !wanted {
        return Ok((package, End::Fine));
    }
    let (files, losses) = emit(model, backend::ALL);
    findings.extend(losses);
    show(profile, root, &findings, &compiled.sources);
    let folder = root.join("generated").join(&model.drive.package);
    let found = if options.check || options.diff {
        sink::check(&files, &folder)?
    } else {
        sink::write(&files, &folder)?
    };
    let end = report(&files, &folder, &found, options);
    let quiet = options.quiet && found.is_empty();
    if !quiet {
        let warnings = render::summary(&findings).map_or_else(String::new, |s| format!(", {s}"));
        println!(
            "{:<10} {} objects, {} entries, {} PDOs, {} alarms, {} errata -> {} files{warnings}, {}",
            model.drive.id,
            model.objects.len(),
            model.entries.len(),
            model.pdos.len(),
            model.alarms.len(),
            model.errata.len(),
            files.len(),
            changes(&found, options)
        );
    }
    Ok((package, end))
}

fn show(profile: &Profile, root: &Path, findings: &[Diagnostic], sources: &SourceMap) {
    let style =
        render::Style { colour: std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none() };
    let text = render::text(findings, sources, style);
    if !text.is_empty() {
        let folder = profile.folder.strip_prefix(root).unwrap_or(&profile.folder);
        eprintln!("in {}:\n{text}", folder.display().to_string().replace('\\', "/"));
    }
}

fn changes(found: &[Difference], options: &Options) -> String {
    let count = |state| found.iter().filter(|d| d.state == state).count();
    let (new, changed, gone) = (count(State::Missing), count(State::Changed), count(State::Orphaned));
    match (found.is_empty(), options.check || options.diff) {
        (true, _) => "up to date".to_owned(),
        (false, true) => format!("{new} missing, {changed} changed, {gone} orphaned"),
        (false, false) => format!("wrote {}, removed {gone}", new + changed),
    }
}

/// Names what differs; with `--diff`, shows it.
fn report(files: &FileSet, folder: &Path, found: &[Difference], options: &Options) -> End {
    if !options.check && !options.diff {
        return End::Fine;
    }
    let name = place(folder);
    for difference in found {
        let line = difference.line.map_or_else(String::new, |l| format!(" (first in line {l})"));
        println!("{}: {name}/{}{line}", difference.state.word(), difference.path);
        if options.diff {
            print!("{}", sink::unified(files, folder, &difference.path));
        }
    }
    if found.is_empty() || !options.check {
        return End::Fine;
    }
    println!("run `cargo xtask regen` and commit the result");
    End::Findings
}

/// The last two parts of a folder's path: `generated/savch-sdv3-e`, `codegen/schema`.
fn place(folder: &Path) -> String {
    let parts: Vec<_> = folder.iter().rev().take(2).map(|p| p.to_string_lossy()).collect();
    parts.into_iter().rev().collect::<Vec<_>>().join("/")
}

/// Folders below `generated/` that no profile makes.
fn strays(root: &Path, packages: &[String], options: &Options) -> End {
    let Ok(found) = folders(&root.join("generated")) else { return End::Fine };
    let mut end = End::Fine;
    for folder in found {
        let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if packages.contains(&name) {
            continue;
        }
        if options.check || options.diff {
            println!("orphaned: generated/{name}/ (no profile makes it)");
            if options.check {
                println!("run `cargo xtask regen` and commit the result");
                end = End::Findings;
            }
        } else if let Err(error) = fs::remove_dir_all(&folder) {
            return disk(&error);
        } else {
            println!("removed generated/{name}/, which no profile makes");
        }
    }
    end
}
