//! Compiles every profile to every output. One line a drive.

use std::collections::BTreeMap;
use std::fs;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};

use drivewright_codegen::diag::{Diagnostic, Severity, render};
use drivewright_codegen::emit::FileSet;
use drivewright_codegen::schema::{configuration_schema, profile_schema, xsd::profile_xsd};
use drivewright_codegen::sink::{self, Difference, SinkError, State};
use drivewright_codegen::{Compiled, backend, compile_folder, emit, load};

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
    let wrong = misplaced(&profiles);
    if !wrong.is_empty() {
        wrong.iter().for_each(|text| eprintln!("error: {text}"));
        eprintln!("nothing was written");
        return End::Findings;
    }
    let mut end = End::Fine;
    for profile in profiles.iter().filter(|p| options.drives.is_empty() || options.drives.contains(&p.id)) {
        match deliver(profile, root, options) {
            Ok(one) => end = end.max(one),
            Err(error) => return disk(&error),
        }
    }
    if options.drives.is_empty() {
        end = end.max(strays(root, &profiles, options));
        match schemas(root, options) {
            Ok(one) => end = end.max(one),
            Err(error) => return disk(&error),
        }
    }
    end
}

/// The schemas of profiles, of configurations and of `model.json`.
fn schemas(root: &Path, options: &Options) -> Result<End, SinkError> {
    let mut files = FileSet::default();
    for (path, text) in [
        ("profile.schema.json", profile_schema()),
        ("profile.xsd", profile_xsd()),
        ("configuration.schema.json", configuration_schema()),
        ("model.schema.json", backend::json::model_schema()),
    ] {
        // The paths are literals that every RelPath rule allows.
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
    /// `savch`
    vendor: String,
    /// `sdv3-e`
    id: String,
    compiled: Compiled,
}

impl Profile {
    /// The folder as people write it: `profiles/savch/sdv3-e`.
    fn place(&self) -> String {
        format!("profiles/{}/{}", self.vendor, self.id)
    }

    /// The package that it makes. Not known where an error hides the drive row.
    fn package(&self) -> Option<&str> {
        self.compiled.model.as_ref().map(|m| m.drive.package.as_str())
    }
}

/// Every `profiles/<vendor>/<drive>`, in path order.
fn places(root: &Path) -> std::io::Result<Vec<PathBuf>> {
    load::drives(&root.join("profiles"))
}

/// Every profile, compiled.
fn profiles(root: &Path) -> std::io::Result<Vec<Profile>> {
    let compiled = |folder: &PathBuf| Profile {
        vendor: folder.parent().map(name).unwrap_or_default(),
        id: name(folder),
        compiled: compile_folder(folder).0,
    };
    Ok(places(root)?.iter().map(compiled).collect())
}

/// The last part of a path.
fn name(folder: &Path) -> String {
    folder.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// Profiles that are not where their ids say, or make the same package: one would overwrite what the other makes.
fn misplaced(profiles: &[Profile]) -> Vec<String> {
    let mut wrong = Vec::new();
    let mut makers: BTreeMap<&str, &Profile> = BTreeMap::new();
    for profile in profiles {
        let (Some(package), Some(model)) = (profile.package(), &profile.compiled.model) else { continue };
        let (place, id) = (profile.place(), &model.drive.id);
        if *id != profile.id || package != format!("{}-{id}", profile.vendor) {
            let vendor = package.strip_suffix(&format!("-{id}")).unwrap_or(package);
            wrong.push(format!(
                "{place} describes `{vendor}` `{id}`: move it to profiles/{vendor}/{id}, or correct the ids"
            ));
        }
        if let Some(first) = makers.insert(package, profile) {
            wrong.push(format!(
                "{} and {place} both make generated/{package}: change an id of one",
                first.place()
            ));
        }
    }
    wrong
}

/// The id of every drive; none where the folder of profiles cannot be read, which `regen` reports.
pub fn drives(root: &Path) -> Vec<String> {
    places(root).unwrap_or_default().iter().map(|folder| name(folder)).collect()
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

/// Brings the files of one profile in line or compares them.
fn deliver(profile: &Profile, root: &Path, options: &Options) -> Result<End, SinkError> {
    let mut findings = profile.compiled.diagnostics.clone();
    let Some(model) = profile.compiled.sound() else { return Ok(refuse(profile, &findings)) };
    let (files, losses) = emit(model, backend::ALL);
    let failed = losses.iter().any(|d| d.severity() == Severity::Error);
    findings.extend(losses);
    if failed {
        return Ok(refuse(profile, &findings));
    }
    show(profile, &findings);
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
    Ok(end)
}

fn refuse(profile: &Profile, findings: &[Diagnostic]) -> End {
    show(profile, findings);
    eprintln!("{}: {}; nothing was written", profile.id, render::summary(findings).unwrap_or_default());
    End::Findings
}

fn show(profile: &Profile, findings: &[Diagnostic]) {
    let no_colour = std::env::var_os("NO_COLOR").is_some_and(|v| !v.is_empty());
    let style = render::Style { colour: std::io::stderr().is_terminal() && !no_colour };
    let text = render::text(findings, &profile.compiled.sources, style);
    if !text.is_empty() {
        eprintln!("in {}:\n{text}", profile.place());
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
fn strays(root: &Path, profiles: &[Profile], options: &Options) -> End {
    let Some(packages) = profiles.iter().map(Profile::package).collect::<Option<Vec<_>>>() else {
        eprintln!("generated/: no folder is removed: a profile that cannot be read may have made it");
        return End::Fine;
    };
    let Ok(found) = folders(&root.join("generated")) else { return End::Fine };
    let mut end = End::Fine;
    for folder in found {
        let name = name(&folder);
        if packages.contains(&name.as_str()) {
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
