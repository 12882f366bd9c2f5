//! Lints: findings on a resolved model. A new one is a file pair here and a line in [`LINTS`].

mod citations;
mod dictionary;
mod modes;
mod names;
mod process_data;
mod tables;
mod value;

use std::collections::BTreeSet;

use crate::diag::{Code, Diagnostic, Sink, code};
use crate::model::{Entry, Model, Pdo, PdoEntry, Type};
use crate::rows::tables::AllowRow;
use crate::source::Span;

/// A lint.
pub struct Lint {
    /// Its code.
    pub code: Code,
    /// Its documentation: why it is there, an example that fails and one that passes. Both are run as tests.
    pub page: &'static str,
    /// Reports its findings.
    pub run: fn(&Model, &mut Sink),
}

/// Every lint, ascending by number.
#[rustfmt::skip]
pub const LINTS: &[Lint] = &[
    value::default_in_range::LINT,
    value::default_fits_type::LINT,
    value::limits_fit_type::LINT,
    value::limits_in_order::LINT,
    value::default_allowed::LINT,
    value::allowed_in_range::LINT,
    value::values_fit_type::LINT,
    value::bits_fit_type::LINT,
    value::bits_apart::LINT,
    value::limits_on_numbers::LINT,
    value::default_of_kind::LINT,
    dictionary::count_is_u8::LINT,
    dictionary::count_is_highest::LINT,
    dictionary::count_present::LINT,
    dictionary::identity_present::LINT,
    dictionary::kind_fits_entries::LINT,
    process_data::pdo_entry_mappable::LINT,
    process_data::pdo_bits_fit::LINT,
    process_data::pdo_fits_entries::LINT,
    process_data::pdo_fits_bytes::LINT,
    process_data::pdo_entry_accessible::LINT,
    process_data::pdo_matches_object::LINT,
    process_data::pdo_positions_in_row::LINT,
    modes::modes_agree::LINT,
    tables::tables_differ::LINT,
    tables::allowed_named::LINT,
    citations::facts_cited::LINT,
    citations::lines_in_manual::LINT,
    names::name_starts_with_letter::LINT,
];

/// Runs every lint, then takes out the findings that the profile accepts with a reason.
pub fn run(model: &Model, allowed: &[AllowRow], sink: &mut Sink) {
    let mut found = Sink::default();
    for lint in LINTS {
        (lint.run)(model, &mut found);
    }
    let key = |row: &AllowRow| (row.lint.value.0.clone(), row.at.value.0.clone());
    let allowances: BTreeSet<(String, String)> = allowed.iter().map(key).collect();
    let mut used = BTreeSet::new();
    sink.absorb(found, |finding| {
        let row = (finding.code.id().to_owned(), row_of(&finding.message).to_owned());
        let accepted = allowances.contains(&row);
        accepted.then(|| used.insert(row));
        !accepted
    });
    for row in allowed.iter().filter(|row| !used.contains(&key(row))) {
        sink.push(idle(row));
    }
}

/// The row that a finding concerns: what its message has between the first backquotes.
fn row_of(message: &str) -> &str {
    message.split('`').nth(1).unwrap_or("")
}

fn idle(row: &AllowRow) -> Diagnostic {
    let text = format!("`{}` finds nothing at `{}`", row.lint.value.0, row.at.value.0);
    Diagnostic::new(code::ALLOW_UNUSED, row.lint.span, text)
        .why("an allowance that matches nothing may hide the next real finding")
        .help("remove it, or correct `lint` and `at`")
}

/// A finding of a lint. `message` names the row between backquotes.
fn finding(code: Code, span: Span, message: String, why: &str, help: &str) -> Diagnostic {
    Diagnostic::new(code, span, message).why(why).help(help)
}

/// Whether `value` fits a whole-number type; `None` for other types.
fn fits(ty: Type, value: i128) -> Option<bool> {
    ty.range().map(|(low, high)| (low..=high).contains(&value))
}

/// Every mapped entry of every PDO.
fn mapped(model: &Model) -> impl Iterator<Item = (&Pdo, &PdoEntry, &Entry)> {
    model.pdos.iter().flat_map(move |pdo| pdo.entries.iter().map(move |e| (pdo, e, &model.entries[e.entry])))
}

/// How messages and allowances name a mapped entry.
fn mapped_row(pdo: &Pdo, mapped: &PdoEntry) -> String {
    format!("pdo {:04X}:{}", pdo.index, mapped.position)
}
