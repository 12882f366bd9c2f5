//! `drivewright dcf`: a configuration as a DCF and as a concise DCF.

use std::path::{Path, PathBuf};

use drivewright_codegen::configuration::{self, Configuration};
use drivewright_codegen::diag::{Diagnostic, Severity, code};
use drivewright_codegen::model::Model;
use drivewright_codegen::source::SourceMap;
use drivewright_codegen::{dcf, load, sink};

use crate::End;
use crate::arguments::{DcfArguments, Format};
use crate::commands::findings;
use crate::drives;
use crate::output::{counted, disk, print, tell};

/// Runs the command.
pub(crate) fn run(asked: &DcfArguments, format: Format, quiet: bool) -> End {
    let unnamed = asked.out.is_none() && asked.concise.is_none();
    if unnamed && format != Format::Human {
        tell!("error: findings go to standard output, so the DCF cannot: name --out or --concise");
        return End::Usage;
    }
    if unnamed && asked.check {
        tell!("error: --check compares files: name --out or --concise");
        return End::Usage;
    }
    let mut found = match drives::find(&asked.drive) {
        Ok(found) => found,
        Err(end) => return end,
    };
    let of = asked.config.display().to_string().replace('\\', "/");
    let mut loaded = load::file(&asked.config);
    let Some(source) = loaded.sources.pop() else {
        return show(&loaded.diagnostics, &SourceMap::default(), &of, format);
    };
    let Some(model) = found.compiled.sound().cloned() else { return End::Findings };
    let (read, findings) = configuration::read(source, &model, &mut found.compiled.sources);
    let shown = show(&findings, &found.compiled.sources, &of, format);
    let Some(configuration) = read else {
        tell!("nothing was written");
        return shown;
    };
    shown.max(deliver(asked, &model, &configuration, quiet || format != Format::Human))
}

fn show(found: &[Diagnostic], sources: &SourceMap, of: &str, format: Format) -> End {
    let shown = findings(found, sources, "", of, format);
    shown.max(match found.iter().any(|d| d.severity() == Severity::Error) {
        _ if found.iter().any(|d| d.code == code::FILE_MISSING) => End::Disk,
        true => End::Findings,
        false => End::Fine,
    })
}

/// Writes what is asked for, or compares it with what is there.
fn deliver(asked: &DcfArguments, model: &Model, configuration: &Configuration, quiet: bool) -> End {
    let files = files(asked, model, configuration);
    if files.is_empty() {
        return print(&dcf::file(model, configuration, &called(&asked.config.with_extension("dcf"))));
    }
    let mut end = End::Fine;
    for (place, bytes) in &files {
        end = end.max(if asked.check { check(place, bytes) } else { write(place, bytes) });
    }
    if !quiet && end == End::Fine {
        let places: Vec<String> = files.iter().map(|(place, _)| place.display().to_string()).collect();
        let done = if asked.check { "as written" } else { "written" };
        let writes = counted(configuration.writes.len(), "write");
        return print(&format!(
            "{}: {done}, {writes} for node {}\n",
            places.join(", "),
            configuration.node_id
        ));
    }
    end
}

/// The files that are asked for.
fn files<'a>(
    asked: &'a DcfArguments,
    model: &Model,
    configuration: &Configuration,
) -> Vec<(&'a PathBuf, Vec<u8>)> {
    let whole = |place: &'a PathBuf| (place, dcf::file(model, configuration, &called(place)).into_bytes());
    let concise = |place: &'a PathBuf| (place, dcf::concise(configuration));
    asked.out.iter().map(whole).chain(asked.concise.iter().map(concise)).collect()
}

/// The name of a file without its folder.
fn called(place: &Path) -> String {
    place.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn write(place: &Path, bytes: &[u8]) -> End {
    sink::write_file(place, bytes).map_or_else(|error| disk(&error), |()| End::Fine)
}

fn check(place: &Path, bytes: &[u8]) -> End {
    if sink::holds(place, bytes) {
        return End::Fine;
    }
    let state = if place.exists() { sink::State::Changed } else { sink::State::Missing };
    print(&format!("{}: {}\n", state.word(), place.display())).max(End::Findings)
}
