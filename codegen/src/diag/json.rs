//! Findings as JSON, one object a line, for editors and scripts.

use serde::Serialize;

use super::Diagnostic;
use crate::emit::escape;
use crate::source::{SourceMap, Span};

/// A finding as JSON has it. The shape is stable: keys are added, never changed.
#[derive(Serialize)]
struct Finding<'a> {
    /// The profile's folder, as it was named.
    #[serde(skip_serializing_if = "str::is_empty")]
    folder: &'a str,
    code: &'static str,
    severity: &'static str,
    title: &'static str,
    message: &'a str,
    #[serde(flatten)]
    place: Option<Place<'a>>,
    label: &'a str,
    related: Vec<Related<'a>>,
    why: &'a str,
    help: &'a str,
}

/// Lines and columns count from 1, columns in characters; bytes from 0. The end is one past the last.
#[derive(Serialize)]
struct Place<'a> {
    path: &'a str,
    line: usize,
    column: usize,
    end_line: usize,
    end_column: usize,
    start_byte: u32,
    end_byte: u32,
}

#[derive(Serialize)]
struct Related<'a> {
    #[serde(flatten)]
    place: Option<Place<'a>>,
    text: &'a str,
}

/// One JSON object a line. `folder` is the profile's, from which paths go on; it is left out where it is empty. A message
/// may name what nobody sees: that is an escape in it.
pub fn lines(findings: &[Diagnostic], sources: &SourceMap, folder: &str) -> String {
    let text = |d: &Diagnostic| serde_json::to_string(&finding(d, sources, folder)).unwrap_or_default();
    let line = |d: &Diagnostic| {
        escape::json(&text(d))
            + "
"
    };
    findings.iter().map(line).collect()
}

fn finding<'a>(d: &'a Diagnostic, sources: &'a SourceMap, folder: &'a str) -> Finding<'a> {
    Finding {
        folder,
        code: d.code.id(),
        severity: d.severity().word(),
        title: d.code.title(),
        message: &d.message,
        place: place(d.span, sources),
        label: &d.label,
        related: d.related.iter().map(|l| Related { place: place(l.span, sources), text: &l.text }).collect(),
        why: &d.why,
        help: &d.help,
    }
}

fn place(span: Span, sources: &SourceMap) -> Option<Place<'_>> {
    let path = sources.path(span.file);
    let (start, end) = (sources.line_column(span.file, span.start), sources.line_column(span.file, span.end));
    (!path.is_empty()).then_some(Place {
        path,
        line: start.line,
        column: start.column,
        end_line: end.line,
        end_column: end.column,
        start_byte: span.start,
        end_byte: span.end,
    })
}
