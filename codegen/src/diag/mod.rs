//! Diagnostics as data: what is wrong, where, why, and what to do.
//!
//! Stages push into a [`Sink`]; [`render`], [`json`] and [`github`] turn the result into text. No stage prints.

pub mod code;
pub mod github;
pub mod json;
pub mod page;
pub mod render;

pub use code::Code;

use crate::limits;
use crate::source::{SourceMap, Span};

/// How bad a finding is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Severity {
    /// Nothing may be emitted.
    Error,
    /// Something a reader should look at; output is still right.
    Warning,
}

impl Severity {
    /// `error` or `warning`.
    pub fn word(self) -> &'static str {
        match self {
            Self::Error => "error",
            Self::Warning => "warning",
        }
    }
}

/// A second place that explains the first.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Label {
    /// Where.
    pub span: Span,
    /// What stands there, in a few words.
    pub text: String,
}

/// One finding.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Diagnostic {
    /// Stable code: severity, title and page hang on it.
    pub code: Code,
    /// The whole finding in one sentence, with the values in it.
    pub message: String,
    /// Where it stands.
    pub span: Span,
    /// The row that it concerns, as allowances name it. Only findings of lints can be allowed, and have it.
    pub row: Option<String>,
    /// What to read at that place; may be empty.
    pub label: String,
    /// Other places that matter.
    pub related: Vec<Label>,
    /// Why this is a finding.
    pub why: String,
    /// What to do about it.
    pub help: String,
}

impl Diagnostic {
    /// A finding of `code` at `span`.
    pub fn new(code: Code, span: Span, message: impl Into<String>) -> Self {
        Self {
            code,
            message: message.into(),
            span,
            row: None,
            label: String::new(),
            related: Vec::new(),
            why: String::new(),
            help: String::new(),
        }
    }

    /// Names the row that an allowance of this finding would name.
    #[must_use]
    pub fn row(mut self, row: impl Into<String>) -> Self {
        self.row = Some(row.into());
        self
    }

    /// Says what the reader sees at the main place.
    #[must_use]
    pub fn label(mut self, text: impl Into<String>) -> Self {
        self.label = text.into();
        self
    }

    /// Adds a second place.
    #[must_use]
    pub fn related(mut self, span: Span, text: impl Into<String>) -> Self {
        self.related.push(Label { span, text: text.into() });
        self
    }

    /// Says why this is a finding.
    #[must_use]
    pub fn why(mut self, text: impl Into<String>) -> Self {
        self.why = text.into();
        self
    }

    /// Says what to do.
    #[must_use]
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.help = text.into();
        self
    }

    /// How bad it is.
    pub fn severity(&self) -> Severity {
        self.code.severity()
    }
}

/// One finding that stands for those beyond the limit.
fn more([errors, warnings]: [usize; 2]) -> Option<Diagnostic> {
    let code = if errors > 0 { code::MORE_ERRORS } else { code::MORE_WARNINGS };
    (errors + warnings > 0).then(|| {
        Diagnostic::new(code, Span::nowhere(), format!("{errors} more errors and {warnings} more warnings"))
            .why(format!("a run keeps the first {} findings", limits::FINDINGS))
            .help("correct those shown and run again")
    })
}

/// Collects the findings of a run.
#[derive(Clone, Default, Debug)]
pub struct Sink {
    list: Vec<Diagnostic>,
    /// Errors and warnings beyond the ones kept.
    more: [usize; 2],
}

impl Sink {
    /// Adds a finding.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        self.report(diagnostic.code, || diagnostic);
    }

    /// Adds a finding of `code`, which is made only if it is kept: for findings whose words take work.
    pub fn report(&mut self, code: Code, diagnostic: impl FnOnce() -> Diagnostic) {
        if self.list.len() < limits::FINDINGS {
            self.list.push(diagnostic());
        } else {
            self.more[code.severity() as usize] += 1;
        }
    }

    /// Whether an error was found.
    pub fn has_errors(&self) -> bool {
        self.count(Severity::Error) > 0
    }

    /// How many findings of a severity there are.
    pub fn count(&self, severity: Severity) -> usize {
        self.list.iter().filter(|d| d.severity() == severity).count() + self.more[severity as usize]
    }

    /// The findings so far.
    pub fn as_slice(&self) -> &[Diagnostic] {
        &self.list
    }

    /// Adds the findings of `other` for which `keep` is true, and its count of further ones.
    pub(crate) fn absorb(&mut self, other: Self, mut keep: impl FnMut(&Diagnostic) -> bool) {
        other.list.into_iter().filter(|d| keep(d)).for_each(|d| self.push(d));
        self.more = [self.more[0] + other.more[0], self.more[1] + other.more[1]];
    }

    /// The findings in the order of their places, so that the order in which stages ran cannot be seen.
    pub fn into_sorted(mut self, sources: &SourceMap) -> Vec<Diagnostic> {
        self.list.sort_by(|a, b| {
            let key = |d: &Diagnostic| (d.span.start, d.span.end, d.code.id());
            (sources.path(a.span.file), key(a), &a.message).cmp(&(
                sources.path(b.span.file),
                key(b),
                &b.message,
            ))
        });
        self.list.dedup();
        self.list.extend(more(self.more));
        self.list
    }
}
