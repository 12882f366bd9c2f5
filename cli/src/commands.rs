//! What each command does.

use std::path::{Path, PathBuf};

use clap::CommandFactory;
use drivewright_codegen::backend::{self, Backend};
use drivewright_codegen::check::LINTS;
use drivewright_codegen::diag::{Code, Diagnostic, Severity, code, github, json, render};
use drivewright_codegen::emit::FileSet;
use drivewright_codegen::model::Model;
use drivewright_codegen::sink::{self, Difference, SinkError, State};
use drivewright_codegen::source::SourceMap;
use drivewright_codegen::{Compiled, compile_folder, configuration, emit, schema};

use crate::arguments::{Arguments, Command, Format, SchemaFormat};
use crate::drives::{folder, folders};
use crate::output::{Shape, colour, counted, disk, print, several, tell, tell_all, working};
use crate::{End, audit, convert, coverage, dcf, demo, diff, explain, simulate, todo};

/// Runs the command.
pub(crate) fn run(arguments: &Arguments) -> End {
    let Arguments { quiet, json, .. } = *arguments;
    let shape = Shape { quiet, json };
    let asked = |format: Format| if json { Format::Json } else { format };
    match &arguments.command {
        Command::Check { drives, format } => check(drives, asked(*format), quiet),
        Command::Build { drive, out, prune, only, check, diff, format } => {
            let mode = if *check { Mode::Check } else { Mode::Write };
            let mode = if *diff { Mode::Diff } else { mode };
            let to = Target { folder: out, prune: *prune, mode };
            folder(drive).map_or_else(|end| end, |folder| build(&folder, &to, only, asked(*format), quiet))
        }
        Command::Explain { of, what } => explain::run(of, what, json),
        Command::Audit(wanted) => audit::run(wanted, shape),
        Command::Convert(wanted) => convert::run(wanted, asked(Format::Human), quiet),
        Command::Coverage { drives } => coverage::run(drives, json),
        Command::Todo { drives } => todo::run(drives, json),
        Command::Diff(wanted) => diff::run(wanted, shape),
        Command::Demo(wanted) => demo::run(wanted, shape),
        Command::Simulate(wanted) => simulate::run(wanted, shape),
        Command::Lints => print(&if json { codes_json() } else { codes() }),
        Command::Dcf(wanted) => dcf::run(wanted, asked(wanted.format), quiet),
        Command::Schema { format: SchemaFormat::Xsd, .. } if json => {
            tell!("error: an XSD is no JSON: leave out --json, or --format xsd");
            End::Usage
        }
        Command::Schema { configuration: true, .. } => print(&schema::configuration_schema()),
        Command::Schema { format: SchemaFormat::Xsd, .. } => print(&schema::xsd::profile_xsd()),
        Command::Schema { .. } => print(&schema::profile_schema()),
        Command::Completions { .. } if json => {
            tell!("error: a completion script is no JSON: leave out --json");
            End::Usage
        }
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(*shell, &mut Arguments::command(), "drivewright", &mut script);
            print(&String::from_utf8_lossy(&script))
        }
    }
}

fn end(compiled: &Compiled) -> End {
    let has = |of: fn(&Diagnostic) -> bool| compiled.diagnostics.iter().any(of);
    match has(|d| d.severity() == Severity::Error) {
        _ if has(|d| d.code == code::FILE_MISSING) => End::Disk,
        true => End::Findings,
        false => End::Fine,
    }
}

/// Prints the findings, and for people a summary of what they are.
fn show(compiled: &Compiled, folder: &Path, format: Format, quiet: bool) -> End {
    let Compiled { diagnostics, sources, .. } = compiled;
    let folder = folder.display().to_string().replace('\\', "/");
    let shown = findings(diagnostics, sources, &folder, &folder, format);
    match &compiled.model {
        Some(model) if diagnostics.is_empty() && format == Format::Human && !quiet => {
            print(&counts(model, &folder))
        }
        _ => shown,
    }
}

/// Prints findings; for people also a summary of what they are in `of`. The paths of the sources are below `folder`.
pub(crate) fn findings(
    found: &[Diagnostic],
    sources: &SourceMap,
    folder: &str,
    of: &str,
    format: Format,
) -> End {
    match format {
        Format::Json => print(&json::lines(found, sources, folder)),
        Format::Github => print(&github::commands(found, sources, folder)),
        Format::Human => {
            tell_all(&render::text(found, sources, render::Style { colour: colour() }));
            if let Some(summary) = render::summary(found) {
                tell!("{of}: {summary}; `drivewright explain CODE` tells more");
            }
            End::Fine
        }
    }
}

fn counts(model: &Model, folder: &str) -> String {
    format!(
        "{folder}: {} {}: {}, {}, {}, {}, {}, no findings\n",
        model.drive.vendor,
        model.drive.name,
        counted(model.objects.len(), "object"),
        several(model.entries.len(), "entry", "entries"),
        counted(model.pdos.len(), "PDO"),
        counted(model.alarms.len(), "alarm"),
        several(model.errata.len(), "erratum", "errata")
    )
}

fn check(drives: &[String], format: Format, quiet: bool) -> End {
    let folders = match folders(drives) {
        Ok(folders) => folders,
        Err(end) => return end,
    };
    let one = |folder: &PathBuf| {
        let working = working(&format!("checking {}", folder.display()), quiet);
        let (compiled, _) = compile_folder(folder);
        drop(working);
        show(&compiled, folder, format, quiet).max(end(&compiled))
    };
    folders.iter().map(one).max().unwrap_or(End::Fine)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Mode {
    Write,
    Check,
    Diff,
}

/// Where a build goes.
struct Target<'a> {
    folder: &'a Path,
    /// Whether files that are not of the build go.
    prune: bool,
    mode: Mode,
}

impl Target<'_> {
    fn deliver(&self, files: &FileSet) -> Result<Vec<Difference>, SinkError> {
        match (self.mode, self.prune) {
            (Mode::Write, true) => sink::write(files, self.folder),
            (Mode::Write, false) => sink::add(files, self.folder),
            _ => {
                let mut found = sink::check(files, self.folder)?;
                found.retain(|d| self.prune || d.state != State::Orphaned);
                Ok(found)
            }
        }
    }

    /// Whether pruning would remove the profile itself.
    fn holds(&self, profile: &Path) -> bool {
        let whole = |path: &Path| path.canonicalize().ok();
        let (Some(out), Some(profile)) = (whole(self.folder), whole(profile)) else { return false };
        out.starts_with(&profile) || profile.starts_with(&out)
    }
}

fn build(folder: &Path, to: &Target<'_>, only: &[String], format: Format, quiet: bool) -> End {
    if to.prune && to.holds(folder) {
        tell!(
            "error: {} and the profile {} lie in one another: --prune would remove the profile; name another folder",
            to.folder.display(),
            folder.display()
        );
        return End::Usage;
    }
    let (mut compiled, _) = compile_folder(folder);
    let Some(model) = compiled.sound().cloned() else {
        let shown = show(&compiled, folder, format, quiet);
        tell!("nothing was written");
        return shown.max(end(&compiled));
    };
    let chosen: Vec<&dyn Backend> = backend::ALL
        .iter()
        .copied()
        .filter(|b| only.is_empty() || only.iter().any(|id| id == b.id()))
        .collect();
    let (files, losses) = emit(&model, &chosen);
    compiled.diagnostics.extend(losses);
    let shown = show(&compiled, folder, format, true);
    if compiled.sound().is_none() {
        tell!("nothing was written");
        return shown.max(End::Findings);
    }
    shown.max(match to.deliver(&files) {
        Ok(found) => told(&files, to, &found, format, quiet),
        Err(error) => disk(&error),
    })
}

/// Says what was done: on standard output for people, else beside the findings that a program reads there.
fn told(files: &FileSet, to: &Target<'_>, found: &[Difference], format: Format, quiet: bool) -> End {
    let (out, mode) = (to.folder, to.mode);
    let place = out.display().to_string().replace('\\', "/");
    let mut text = String::new();
    for difference in found.iter().filter(|_| mode != Mode::Write) {
        text.extend([difference.state.word(), ": ", &place, "/", difference.path.as_str(), "\n"]);
        if mode == Mode::Diff {
            text += &sink::unified(files, out, &difference.path);
        }
    }
    if !quiet {
        let gone = found.iter().filter(|d| d.state == State::Orphaned).count();
        let rest = found.len() - gone;
        let would = if mode == Mode::Write { "" } else { "would be " };
        let pruned = if to.prune { format!(", {gone} {would}removed") } else { String::new() };
        text.extend([format!("{place}: {}, {rest} {would}written{pruned}\n", counted(files.len(), "file"))]);
    }
    let shown = if format == Format::Human {
        print(&text)
    } else {
        tell_all(&text);
        End::Fine
    };
    shown.max(if mode == Mode::Check && !found.is_empty() { End::Findings } else { End::Fine })
}

/// The codes without a page beside a lint: those of the stages before the lints, of the backends and of configurations.
pub(crate) fn plain_codes() -> impl Iterator<Item = Code> {
    let backends = backend::ALL.iter().flat_map(|b| b.codes());
    code::ALL.iter().chain(backends).chain(configuration::code::ALL).copied()
}

fn every_code() -> Vec<Code> {
    let mut codes: Vec<_> = plain_codes().chain(LINTS.iter().map(|l| l.code)).collect();
    codes.sort_by_key(|c| c.id()[1..].to_owned());
    codes
}

fn codes() -> String {
    let line = |c: &Code| format!("{}  {:<7}  {}\n", c.id(), c.severity().word(), c.title());
    every_code().iter().map(line).collect()
}

/// One object a line.
fn codes_json() -> String {
    let line = |c: &Code| {
        let one = serde_json::json!({ "code": c.id(), "severity": c.severity().word(), "title": c.title() });
        format!("{one}\n")
    };
    every_code().iter().map(line).collect()
}
