//! Lints: findings on a resolved model. A new one is a file pair here and a line in [`LINTS`].

mod citations;
mod dictionary;
mod ethercat;
mod examples;
mod homing;
mod modes;
mod names;
mod parameters;
mod process_data;
mod rules;
mod states;
mod tables;
mod terminals;
mod value;

use std::collections::BTreeSet;
use std::fmt::Display;

use crate::diag::{Code, Diagnostic, Sink, code};
use crate::model::{Entry, Fact, Model, Pdo, PdoEntry, Type};
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
    value::quantities_have_units::LINT,
    dictionary::count_is_u8::LINT,
    dictionary::count_is_highest::LINT,
    dictionary::count_present::LINT,
    dictionary::identity_present::LINT,
    dictionary::kind_fits_entries::LINT,
    dictionary::device_type_whole::LINT,
    process_data::pdo_entry_mappable::LINT,
    process_data::pdo_bits_fit::LINT,
    process_data::pdo_fits_entries::LINT,
    process_data::pdo_fits_bytes::LINT,
    process_data::pdo_entry_accessible::LINT,
    process_data::pdo_matches_object::LINT,
    process_data::pdo_positions_in_row::LINT,
    process_data::pdo_fits_frame::LINT,
    process_data::assigned_pdos_exist::LINT,
    modes::modes_agree::LINT,
    modes::modes_listed::LINT,
    modes::modes_have_objects::LINT,
    tables::tables_differ::LINT,
    tables::allowed_named::LINT,
    citations::facts_cited::LINT,
    citations::lines_in_manual::LINT,
    names::name_starts_with_letter::LINT,
    homing::ends_at_home::LINT,
    homing::edges_alternate::LINT,
    homing::one_home::LINT,
    homing::abort_not_awaited::LINT,
    homing::columns_agree::LINT,
    homing::cases_apart::LINT,
    homing::methods_in_range::LINT,
    homing::default_method_there::LINT,
    examples::mapping_words_agree::LINT,
    examples::writes_accepted::LINT,
    parameters::parameters_in_place::LINT,
    states::states_apart::LINT,
    states::commands_fit::LINT,
    states::standard_words::LINT,
    ethercat::emcy_whole::LINT,
    ethercat::sync_managers_apart::LINT,
    ethercat::control_fits_use::LINT,
    ethercat::startup_accepted::LINT,
    terminals::pins_differ::LINT,
    terminals::terminal_parameter::LINT,
    ethercat::sync_managers_whole::LINT,
    rules::defaults_obey_rules::LINT,
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
        let Some(row) = &finding.row else { return true };
        let row = (finding.code.id().to_owned(), row.clone());
        let accepted = allowances.contains(&row);
        accepted.then(|| used.insert(row));
        !accepted
    });
    for row in allowed.iter().filter(|row| !used.contains(&key(row))) {
        sink.push(idle(row));
    }
}

fn idle(row: &AllowRow) -> Diagnostic {
    let text = format!("`{}` finds nothing at `{}`", row.lint.value.0, row.at.value.0);
    Diagnostic::new(code::ALLOW_UNUSED, row.lint.span, text)
        .why("an allowance that matches nothing may hide the next real finding")
        .help("remove it, or correct `lint` and `at`")
}

/// A finding of a lint. `row` is what an allowance names; `message` has it between backquotes, so that its reader can write
/// one.
fn finding(code: Code, span: Span, row: &dyn Display, message: String, why: &str, help: &str) -> Diagnostic {
    Diagnostic::new(code, span, message).row(row.to_string()).why(why).help(help)
}

/// Whether an erratum set or explained a fact, so that its difference from another one is known.
fn settled<T>(fact: &Fact<T>) -> bool {
    fact.origin.erratum.is_some()
}

/// A fact that no erratum set or explained.
fn unsettled<T>(fact: Option<&Fact<T>>) -> Option<&Fact<T>> {
    fact.filter(|fact| !settled(fact))
}

/// Whether the drive names the base `name`.
fn based_on(model: &Model, name: &str) -> bool {
    model.drive.bases.iter().any(|base| base == name)
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
