//! `drivewright audit`: proves facts against the text extract of a manual.

use std::path::{Path, PathBuf};

use drivewright_codegen::audit::{
    Contradiction, Finding, Kind, Record, Report, audit, contradictions, text_hash,
};
use drivewright_codegen::facts::{FactLine, Totals, facts};
use drivewright_codegen::model::{Manual, Model};
use serde_json::json;

use crate::arguments::AuditArguments;
use crate::drives::{Found, find};
use crate::output::{Shape, counted, disk, print, tell, working};
use crate::{End, convert};

/// Names the folder of text extracts.
const MANUALS: &str = "DRIVEWRIGHT_MANUALS";

/// A profile and the text that it is read against.
struct Reading<'a> {
    found: &'a Found,
    model: &'a Model,
    manual: &'a Manual,
    text: String,
    facts: Vec<FactLine<'a>>,
}

pub(crate) fn run(asked: &AuditArguments, shape: Shape) -> End {
    match find(&asked.drive).and_then(|found| read(&found, asked, shape)) {
        Ok(end) | Err(end) => end,
    }
}

fn read(found: &Found, asked: &AuditArguments, shape: Shape) -> Result<End, End> {
    let Some(model) = found.compiled.model.as_ref() else { return Err(End::Findings) };
    let manual = manual(model, asked)?;
    let file = file(found, asked)?;
    let text = std::fs::read_to_string(&file).map_err(|e| disk(&format!("{}: {e}", file.display())))?;
    if text_hash(&text) != manual.sha256 {
        tell!(
            "error: {} is another text than the one that the profile cites\n  its SHA-256 is {}\n  `manuals` says   {}\n\
             note: line numbers hold for one extract only\n\
             help: use that extract, or cite this one anew and correct `sha256` and `lines`",
            file.display(),
            text_hash(&text),
            manual.sha256
        );
        return Err(End::Findings);
    }
    Ok(Reading { found, model, manual, text, facts: facts(model) }.report(asked, shape))
}

fn manual<'m>(model: &'m Model, asked: &AuditArguments) -> Result<&'m Manual, End> {
    let wanted = |m: &&Manual| asked.id.as_ref().is_none_or(|id| *id == m.id);
    let wanted: Vec<&Manual> = model.manuals.iter().filter(wanted).collect();
    if let [only] = wanted.as_slice() {
        return Ok(only);
    }
    let known: Vec<&str> = model.manuals.iter().map(|m| m.id.as_str()).collect();
    tell!("error: name one manual with --id; known: {}", known.join(", "));
    Err(End::Usage)
}

fn file(found: &Found, asked: &AuditArguments) -> Result<PathBuf, End> {
    if let Some(file) = &asked.manual {
        return Ok(file.clone());
    }
    let Some(folder) = std::env::var_os(MANUALS) else {
        tell!("error: name the text extract with --manual, or its folder in {MANUALS}");
        return Err(End::Usage);
    };
    Ok(Path::new(&folder).join(format!("{}.txt", found.id)))
}

impl Reading<'_> {
    fn report(&self, asked: &AuditArguments, shape: Shape) -> End {
        let working = working(&format!("auditing {}", self.found.id), shape.quiet);
        let rows = &self.found.compiled.rows;
        let Some(report) = audit(self.model, &self.facts, rows, &self.manual.id, &self.text) else {
            return End::Usage;
        };
        let differing = contradictions(self.model, &self.facts, rows, &self.manual.id, &self.text);
        drop(working);
        let open = report.open().count() + differing.iter().filter(|c| !c.settled()).count();
        let mut text = String::new();
        if shape.json {
            text = format!("{}\n", json(&report, &differing, open));
        } else {
            text += &Self::list(asked, &report, &differing);
            if !shape.quiet {
                text += &self.sum_up(&report, &differing, open);
            }
        }
        let shown = print(&text);
        let end = if open == 0 { End::Fine } else { End::Findings };
        shown.max(if asked.record { self.record(&report, end) } else { end })
    }

    fn list(asked: &AuditArguments, report: &Report, differing: &[Contradiction]) -> String {
        let findings = report.findings.iter().filter(|f| asked.accepted || f.accepted.is_none()).map(line);
        let differing = differing.iter().filter(|c| asked.contradictions || !c.settled()).map(side_by_side);
        findings.chain(differing).map(|line| line + "\n").collect()
    }

    fn sum_up(&self, report: &Report, differing: &[Contradiction], open: usize) -> String {
        let totals = Totals::of(&self.facts);
        let facts = format!(
            "{}: {}: {} stated, {} inferred, {} standard, {} assumed",
            self.found.id,
            counted(totals.facts(), "fact"),
            totals.stated,
            totals.inferred,
            totals.standard,
            totals.assumed
        );
        let proved = format!(
            "{} proved by their lines, {} with words of our own on lines that belong to them, {} accepted without proof",
            report.proved,
            report.worded,
            report.accepted()
        );
        let lines = format!(
            "rows of printed tables: {} cited, {} not cited and without a fact; {} between places, {} open",
            report.cited_lines,
            report.uncited_lines,
            counted(differing.len(), "difference"),
            differing.iter().filter(|c| !c.settled()).count()
        );
        let open = match open {
            0 => "nothing is open".to_owned(),
            1 => "1 finding is open".to_owned(),
            n => format!("{n} findings are open"),
        };
        format!("{facts}\n{proved}\n{lines}\n{open}\n")
    }

    fn record(&self, report: &Report, end: End) -> End {
        if end != End::Fine {
            tell!("error: nothing was recorded: settle what is open first");
            return end;
        }
        let record = Record::new(&self.manual.id, &self.text, &self.facts, report);
        let (place, text) = convert::in_place_of(&self.found.folder, "audit.toml", record.to_toml());
        match drivewright_codegen::sink::write_file(&place, text.as_bytes()) {
            Ok(()) => End::Fine,
            Err(error) => disk(&error),
        }
    }
}

fn line(finding: &Finding) -> String {
    let Finding { kind, at, field, what, accepted } = finding;
    let field = if field.is_empty() { String::new() } else { format!(" {field}") };
    let why = accepted.as_ref().map_or_else(String::new, |why| format!(" (accepted: {why})"));
    format!("{}: {at}{field}: {what}{why}", kind.word())
}

fn side_by_side(one: &Contradiction) -> String {
    let places: Vec<String> = one.places.iter().map(|p| format!("L{} {}", p.line, p.printed)).collect();
    let settled = match (&one.harmless, one.errata.as_slice()) {
        (Some(why), _) => format!("harmless: {why}"),
        (None, []) => "open".to_owned(),
        (None, errata) => errata.join(", "),
    };
    format!("differs: {} {}: {} | {} | {settled}", one.at, one.field, one.value, places.join(" | "))
}

fn json(report: &Report, differing: &[Contradiction], open: usize) -> serde_json::Value {
    let finding = |f: &Finding| json!({ "kind": f.kind.word(), "at": f.at, "field": f.field, "what": f.what, "accepted": f.accepted });
    let difference = |c: &Contradiction| {
        let places: Vec<_> =
            c.places.iter().map(|p| json!({ "line": p.line, "printed": p.printed })).collect();
        json!({ "at": c.at, "field": c.field, "value": c.value, "places": places, "errata": c.errata,
                "harmless": c.harmless })
    };
    json!({
        "proved": report.proved,
        "worded": report.worded,
        "accepted": report.accepted(),
        "cited_lines": report.cited_lines,
        "uncited_lines": report.uncited_lines,
        "open": open,
        "unproved": report.open().filter(|f| f.kind == Kind::Unproved).count(),
        "findings": report.findings.iter().map(finding).collect::<Vec<_>>(),
        "contradictions": differing.iter().map(difference).collect::<Vec<_>>(),
    })
}
