//! Rules of the manual, with the values of the configuration and the defaults of all other objects.

use super::code;
use super::pdo::Pdo;
use super::setting::{Setting, Settings};
use super::{Configuration, order};
use crate::diag::{Diagnostic, Sink};
use crate::model::{Fact, Model, Occasion, Rule};

/// Reports the rules that name an object of the configuration and are broken in the end: those that hold always, and
/// where process data changes those of that occasion.
pub(super) fn check(
    model: &Model,
    configuration: &Configuration,
    settings: &Settings,
    pdos: &[Pdo],
    sink: &mut Sink,
) {
    let values = configuration.values();
    let remaps = !pdos.is_empty() || settings.list.iter().any(|s| order::assigned(s.address).is_some());
    let concerns = |rule: &&Rule| match rule.on.as_ref().map(|on| on.value) {
        None => true,
        Some(occasion) => occasion == Occasion::Remap && remaps,
    };
    let value = |at| values.get(&at).copied().or_else(|| model.default_int(at));
    for rule in model.rules.iter().filter(concerns).filter(|rule| rule.broken(value)) {
        let objects = rule.objects();
        let mut all = settings.list.iter().chain(pdos.iter().flat_map(Pdo::settings));
        let Some(setting) = all.find(|s| objects.contains(&s.address)) else { continue };
        let shown = objects.iter().filter_map(|at| Some(format!("{at} = {}", value(*at)?)));
        let shown: Vec<String> = shown.collect();
        sink.push(broken(rule, setting, &shown.join(", ")));
    }
}

fn broken(rule: &Rule, setting: &Setting, values: &str) -> Diagnostic {
    let text = format!("`rule {}` does not hold with {values}", rule.id);
    let require = rule.require.as_ref().map_or(rule.text.span(), Fact::span);
    Diagnostic::new(code::RULE_BROKEN, setting.span, text)
        .related(require, "the rule")
        .why(format!("the manual: {}", rule.text.value))
        .help("correct one of the values; those that the configuration does not set are the drive's defaults")
}
