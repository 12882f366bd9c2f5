//! What each command does.

use std::io::IsTerminal;
use std::path::Path;

use clap::CommandFactory;
use drivewright_codegen::backend::{self, Backend};
use drivewright_codegen::check::LINTS;
use drivewright_codegen::diag::{Code, Diagnostic, Severity, code, github, json, page, render};
use drivewright_codegen::emit::FileSet;
use drivewright_codegen::model::Model;
use drivewright_codegen::sink::{self, Difference, SinkError, State};
use drivewright_codegen::{Compiled, compile_folder, emit, schema};

use crate::arguments::{Arguments, Command, Format, SchemaFormat};
use crate::drives::folder;
use crate::output::{counted, disk, print, several};
use crate::{End, audit, convert, coverage};

/// Runs the command.
pub(crate) fn run(arguments: &Arguments) -> End {
    let quiet = arguments.quiet;
    match &arguments.command {
        Command::Check { drive, format } => {
            folder(drive).map_or_else(|end| end, |folder| check(&folder, *format, quiet))
        }
        Command::Build { drive, out, prune, only, check, diff, format } => {
            let mode = if *check { Mode::Check } else { Mode::Write };
            let mode = if *diff { Mode::Diff } else { mode };
            let to = Target { folder: out, prune: *prune, mode };
            folder(drive).map_or_else(|end| end, |folder| build(&folder, &to, only, *format, quiet))
        }
        Command::Explain { code } => explain(code),
        Command::Audit(asked) => audit::run(asked, quiet),
        Command::Convert(asked) => convert::run(asked, quiet),
        Command::Coverage { drives, json } => coverage::run(drives, *json),
        Command::Lints => print(&codes()),
        Command::Schema { format: SchemaFormat::Json } => print(&schema::profile_schema()),
        Command::Schema { format: SchemaFormat::Xsd } => print(&schema::xsd::profile_xsd()),
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
    match format {
        Format::Json => print(&json::lines(diagnostics, sources)),
        Format::Github => print(&github::commands(diagnostics, sources, &folder)),
        Format::Human => {
            eprint!("{}", render::text(diagnostics, sources, style()));
            if let Some(summary) = render::summary(diagnostics) {
                eprintln!("{folder}: {summary}; `drivewright explain CODE` tells more");
            } else if let (Some(model), false) = (&compiled.model, quiet) {
                return print(&counts(model, &folder));
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

pub(crate) fn style() -> render::Style {
    let no_colour = std::env::var_os("NO_COLOR").is_some_and(|v| !v.is_empty());
    render::Style { colour: std::io::stderr().is_terminal() && !no_colour }
}

fn check(folder: &Path, format: Format, quiet: bool) -> End {
    let (compiled, _) = compile_folder(folder);
    show(&compiled, folder, format, quiet).max(end(&compiled))
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
        eprintln!(
            "error: {} and the profile {} lie in one another: --prune would remove the profile; name another folder",
            to.folder.display(),
            folder.display()
        );
        return End::Usage;
    }
    let (mut compiled, _) = compile_folder(folder);
    let Some(model) = compiled.sound().cloned() else {
        let shown = show(&compiled, folder, format, quiet);
        eprintln!("nothing was written");
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
        eprintln!("nothing was written");
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
        eprint!("{text}");
        End::Fine
    };
    shown.max(if mode == Mode::Check && !found.is_empty() { End::Findings } else { End::Fine })
}

fn explain(wanted: &str) -> End {
    let wanted = wanted.to_ascii_uppercase();
    if let Some(lint) = LINTS.iter().find(|l| l.code.id() == wanted) {
        return print(lint.page);
    }
    if let Some(text) = plain_codes().find(|c| c.id() == wanted).and_then(page::text) {
        return print(&text);
    }
    eprintln!("error: there is no code `{wanted}`; `drivewright lints` lists them");
    End::Usage
}

/// The codes without a page beside a lint: those of the stages before the lints, and those of the backends.
fn plain_codes() -> impl Iterator<Item = Code> {
    code::ALL.iter().copied().chain(backend::ALL.iter().flat_map(|b| b.codes()).copied())
}

fn codes() -> String {
    let mut codes: Vec<_> = plain_codes().chain(LINTS.iter().map(|l| l.code)).collect();
    codes.sort_by_key(|c| c.id()[1..].to_owned());
    let line = |c: &Code| format!("{}  {:<7}  {}", c.id(), c.severity().word(), c.title());
    codes.iter().map(line).collect::<Vec<_>>().join("\n") + "\n"
}
