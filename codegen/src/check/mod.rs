//! Lints: findings on a resolved model. A new one is a file pair here and a line in [`LINTS`].

use crate::diag::{Code, Diagnostic, Sink, code};
use crate::model::Model;
use crate::rows::tables::AllowRow;

/// A lint.
pub struct Lint {
    /// Its code.
    pub code: Code,
    /// Its documentation: why it is there, an example that fails and one that passes. Both are run as tests.
    pub page: &'static str,
    /// Reports its findings.
    pub run: fn(&Model, &mut Sink),
}

/// Every lint, ascending by code.
pub const LINTS: &[Lint] = &[];

/// Runs every lint, then takes out the findings that the profile accepts with a reason.
pub fn run(model: &Model, allowed: &[AllowRow], sink: &mut Sink) {
    let mut found = Sink::default();
    for lint in LINTS {
        (lint.run)(model, &mut found);
    }
    for row in allowed {
        let before = found.as_slice().len();
        found.retain(|d| !accepts(row, d));
        if found.as_slice().len() == before {
            sink.push(
                Diagnostic::new(
                    code::ALLOW_UNUSED,
                    row.lint.span,
                    format!("`{}` finds nothing at `{}`", row.lint.value.0, row.at.value.0),
                )
                .why("an allowance that matches nothing may hide the next real finding")
                .help("remove it, or correct `lint` and `at`"),
            );
        }
    }
    for finding in found.as_slice() {
        sink.push(finding.clone());
    }
}

/// Findings name the row that they concern between backquotes.
fn accepts(row: &AllowRow, finding: &Diagnostic) -> bool {
    finding.code.id() == row.lint.value.0 && finding.message.contains(&format!("`{}`", row.at.value.0))
}
