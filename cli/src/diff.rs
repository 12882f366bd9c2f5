//! `drivewright diff`: what a revision of a drive means to its users.

use std::io::IsTerminal;
use std::path::Path;

use drivewright_codegen::compile_folder;
use drivewright_codegen::diag::render::{self, Style};
use drivewright_codegen::diff::{
    Effect, Listing, Report, compare, json::json, markdown, markdown::markdown, text::text,
};

use crate::End;
use crate::arguments::{DiffArguments, DiffFormat, FailOn};
use crate::drives::{all, folder};
use crate::git::{Object, Revision};
use crate::output::{Shape, disk, print, tell, tell_all};

pub(crate) fn run(asked: &DiffArguments, shape: Shape) -> End {
    let format = if shape.json { DiffFormat::Json } else { asked.format };
    let reports = match &asked.base {
        Some(base) => since(base, &asked.sides),
        None => two(&asked.sides).map(|report| vec![report]),
    };
    match reports {
        Ok(reports) => print(&shown(&reports, format, shape.quiet)).max(end(&reports, asked.fail_on)),
        Err(end) => end,
    }
}

fn shown(reports: &[Report], format: DiffFormat, quiet: bool) -> String {
    let hint = "`drivewright diff` prints all of them";
    match format {
        DiffFormat::Json => json(reports),
        DiffFormat::Markdown => markdown(reports, hint, markdown::COMMENT),
        DiffFormat::Text if reports.is_empty() && !quiet => "no drive has changed\n".to_owned(),
        DiffFormat::Text => {
            let told = reports.iter().filter(|r| !quiet || !r.changes.is_empty());
            told.map(|report| text(report, style())).collect::<Vec<_>>().join("\n")
        }
    }
}

fn style() -> Style {
    let no_colour = std::env::var_os("NO_COLOR").is_some_and(|v| !v.is_empty());
    Style { colour: std::io::stdout().is_terminal() && !no_colour }
}

/// A difference is no finding unless it is asked for: a revision is the normal event.
fn end(reports: &[Report], fail_on: Option<FailOn>) -> End {
    let worst = reports.iter().filter_map(Report::worst).max();
    let found = match fail_on {
        None => false,
        Some(FailOn::Any) => worst.is_some(),
        Some(FailOn::Axis) => {
            worst >= Some(Effect::Axis) || reports.iter().any(|r| r.moving().next().is_some())
        }
        Some(FailOn::Breaking) => worst >= Some(Effect::Breaking),
        Some(FailOn::Version) => reports.iter().any(|r| !r.verdict.enough),
    };
    if found { End::Findings } else { End::Fine }
}

fn two(sides: &[String]) -> Result<Report, End> {
    let [old, new] = sides else {
        tell!("error: name two sides, OLD and NEW, or a revision with --base");
        return Err(End::Usage);
    };
    Ok(compare(&side(old)?, &side(new)?))
}

/// A profile's folder or drive id, a `model.json`, or either in a revision: `REV:PATH`.
fn side(named: &str) -> Result<Listing, End> {
    let path = Path::new(named);
    if path.is_file() {
        let text = std::fs::read_to_string(path).map_err(|e| disk(&format!("{named}: {e}")))?;
        return parsed(&text, named);
    }
    match named.split_once(':') {
        Some((revision, place)) if !path.exists() => {
            let revision = Revision::find(revision, Path::new("."))?;
            listed(revision.object(place)?, named)?.ok_or_else(|| {
                tell!("error: there is nothing at {named}");
                End::Usage
            })
        }
        _ => compiled(&folder(named)?, named),
    }
}

/// The profile in `folder`. Its findings are shown here: a revision's folder is gone when the program ends.
fn compiled(folder: &Path, named: &str) -> Result<Listing, End> {
    let (compiled, _) = compile_folder(folder);
    let Some(model) = compiled.sound() else {
        tell_all(&render::text(&compiled.diagnostics, &compiled.sources, Style::default()));
        let summary = render::summary(&compiled.diagnostics).unwrap_or_default();
        return Err(refused(named, &format!("it has {summary}")));
    };
    Listing::of(model).map_err(|error| refused(named, &error))
}

fn parsed(text: &str, named: &str) -> Result<Listing, End> {
    Listing::parse(text).map_err(|error| refused(named, &error))
}

fn refused(named: &str, error: &dyn std::fmt::Display) -> End {
    tell!("error: {named}: {error}");
    End::Findings
}

fn listed(object: Object, named: &str) -> Result<Option<Listing>, End> {
    match object {
        Object::Text(text) => parsed(&text, named).map(Some),
        Object::Folder(copied) => compiled(&copied.folder, named).map(Some),
        Object::Missing => Ok(None),
    }
}

/// The named drives, or all that differ, against a revision.
fn since(base: &str, drives: &[String]) -> Result<Vec<Report>, End> {
    let here = Revision::find(base, Path::new("."))?;
    if !drives.is_empty() {
        let folders: Result<Vec<_>, End> = drives.iter().map(|drive| folder(drive)).collect();
        return folders?.into_iter().map(|folder| drive_since(base, &folder)).collect();
    }
    let mut reports = Vec::new();
    for folder in all() {
        reports.push(drive_since(base, &folder)?);
    }
    for pair in here.pairs("./profiles")? {
        let place = format!("./profiles/{pair}");
        if !pair.starts_with("standard/") && !Path::new(&place).exists() {
            let gone = listed(here.object(&place)?, &format!("{base}:{place}"))?.unwrap_or_default();
            reports.push(compare(&gone, &Listing::default()));
        }
    }
    reports.retain(|report| !report.changes.is_empty());
    Ok(reports)
}

/// A drive against the same one in a revision. What was generated then says what its users had; where it is not
/// there, the profile of then is compiled by this program and with its bases.
fn drive_since(base: &str, folder: &Path) -> Result<Report, End> {
    let revision = Revision::find(base, folder)?;
    let new = compiled(folder, &folder.display().to_string())?;
    let file = format!("./../../../generated/{}/model.json", new.package);
    let old = match listed(revision.object(&file)?, &format!("{base}:{file}")) {
        Ok(Some(old)) => Some(old),
        Ok(None) | Err(_) => listed(revision.object("./")?, &format!("{base}:./"))?,
    };
    Ok(compare(&old.unwrap_or_default(), &new))
}
