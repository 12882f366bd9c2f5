//! Findings as text for people, in the manner of rustc. The only module that knows `annotate-snippets`.

use std::fmt::Write;

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Renderer, Snippet};

use super::{Diagnostic, Severity};
use crate::source::{SourceMap, Span};

/// How the text looks.
#[derive(Clone, Copy, Default, PartialEq, Eq, Debug)]
pub struct Style {
    /// With colours, for a terminal.
    pub colour: bool,
}

/// Findings one after the other, each ending with an empty line.
pub fn text(findings: &[Diagnostic], sources: &SourceMap, style: Style) -> String {
    let renderer = if style.colour { Renderer::styled() } else { Renderer::plain() };
    let renderer = renderer.decor_style(DecorStyle::Ascii).term_width(120);
    let mut out = String::new();
    for finding in findings {
        let shown = renderer.render(&[report(finding, sources)]);
        let _ = writeln!(out, "{}\n", shown.trim_end());
    }
    out
}

/// `2 errors, 1 warning`, or nothing.
pub fn summary(findings: &[Diagnostic]) -> Option<String> {
    let count = |severity| findings.iter().filter(|d| d.severity() == severity).count();
    let words =
        |n: usize, word: &str| (n > 0).then(|| format!("{n} {word}{}", if n == 1 { "" } else { "s" }));
    let parts: Vec<String> =
        [words(count(Severity::Error), "error"), words(count(Severity::Warning), "warning")]
            .into_iter()
            .flatten()
            .collect();
    (!parts.is_empty()).then(|| parts.join(", "))
}

fn report<'a>(finding: &'a Diagnostic, sources: &'a SourceMap) -> Group<'a> {
    let level = match finding.severity() {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let mut group = Group::with_title(level.primary_title(finding.message.as_str()).id(finding.code.id()));
    for snippet in snippets(finding, sources) {
        group = group.element(snippet);
    }
    if !finding.why.is_empty() {
        group = group.element(Level::NOTE.message(finding.why.as_str()));
    }
    if !finding.help.is_empty() {
        group = group.element(Level::HELP.message(finding.help.as_str()));
    }
    group
}

/// One snippet for the main place, and one for each other place. Places without a file have none.
fn snippets<'a>(finding: &'a Diagnostic, sources: &'a SourceMap) -> Vec<Snippet<'a, Annotation<'a>>> {
    let main = snippet(finding.span, AnnotationKind::Primary, &finding.label, sources);
    let related =
        finding.related.iter().filter_map(|l| snippet(l.span, AnnotationKind::Context, &l.text, sources));
    main.into_iter().chain(related).collect()
}

/// The lines that a span touches. Only these are handed over: a file may be large, and findings many.
fn snippet<'a>(
    span: Span,
    kind: AnnotationKind,
    label: &'a str,
    sources: &'a SourceMap,
) -> Option<Snippet<'a, Annotation<'a>>> {
    let path = sources.path(span.file);
    if path.is_empty() {
        return None;
    }
    let (from, lines) = sources.lines_of(span);
    let inside = |byte: u32| (byte as usize).saturating_sub(from).min(lines.len());
    let (start, end) = (inside(span.start), inside(span.end));
    let annotation = kind.span(start..end.max(start));
    let annotation = if label.is_empty() { annotation } else { annotation.label(label) };
    let line = sources.line_column(span.file, span.start).line;
    Some(Snippet::source(lines).line_start(line).path(path).annotation(annotation))
}
