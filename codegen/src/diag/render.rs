//! Findings as text for people, in the manner of rustc. The only module that knows `annotate-snippets`.

use std::fmt::Write;

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Element, Group, Level, Origin, Renderer, Snippet};

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
    for element in elements(finding, sources) {
        group = group.element(element);
    }
    if !finding.why.is_empty() {
        group = group.element(Level::NOTE.message(finding.why.as_str()));
    }
    if !finding.help.is_empty() {
        group = group.element(Level::HELP.message(finding.help.as_str()));
    }
    group
}

/// Bytes of lines that are handed over as they are. Of longer ones only a part is: a line of megabytes costs no finding
/// more than this.
const LONG: usize = 2_000;
/// What stands for the rest of a line that is cut.
const CUT: &str = "...";

/// One snippet for the main place, and one for each other place. Places without a file have none.
fn elements<'a>(finding: &'a Diagnostic, sources: &'a SourceMap) -> Vec<Element<'a>> {
    let mut out = elements_of(finding.span, AnnotationKind::Primary, &finding.label, sources);
    for label in &finding.related {
        out.extend(elements_of(label.span, AnnotationKind::Context, &label.text, sources));
    }
    out
}

/// The lines that a span touches, or what is near it in them. Only these are handed over: a file may be large, its lines
/// long, and findings many.
fn elements_of<'a>(
    span: Span,
    kind: AnnotationKind,
    label: &'a str,
    sources: &'a SourceMap,
) -> Vec<Element<'a>> {
    let path = sources.path(span.file);
    if path.is_empty() {
        return Vec::new();
    }
    let excerpt = sources.excerpt(span, LONG);
    let place = sources.line_column(span.file, span.start);
    let inside = |byte: u32| (byte as usize).saturating_sub(excerpt.from).min(excerpt.text.len());
    let (start, end) = (inside(span.start), inside(span.end));
    let annotate = |range| {
        let annotation = kind.span(range);
        if label.is_empty() { annotation } else { annotation.label(label) }
    };
    let before = if excerpt.cut_before { CUT } else { "" };
    let after = if excerpt.cut_after { CUT } else { "" };
    let (start, end) = (start + before.len(), end.max(start) + before.len());
    let text = format!("{before}{}{after}", excerpt.text);
    let snippet = Snippet::source(text).line_start(place.line).annotation(annotate(start..end));
    if !excerpt.cut_before {
        return vec![snippet.path(path).into()];
    }
    // The column is that of the file, which a part of a line does not show.
    vec![Origin::path(path).line(place.line).char_column(place.column).into(), snippet.into()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::code;

    #[test]
    fn a_long_line_is_cut_around_the_place() {
        let mut sources = SourceMap::default();
        let long = "µ".repeat(2_000);
        let file = sources.add("a.toml", format!("one\n{long}here{long}\nthree\n"));
        let at = 4 + long.len();
        let finding = Diagnostic::new(code::SYNTAX, Span::new(file, at..at + 4), "M").label("L");
        let text = text(&[finding], &sources, Style::default());
        assert!(text.contains("a.toml:2:2001\n"), "{text}");
        assert!(text.contains("here") && text.len() < 1_000, "{text}");
    }
}
