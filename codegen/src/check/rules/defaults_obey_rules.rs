//! E1801: the defaults of a drive break a rule of its manual.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Address, Model, Rule};

const CODE: Code = Code::error("E1801", "the defaults of a drive break a rule of its manual");
const WHY: &str = "a drive as delivered obeys its own manual: the rule or a default is read wrongly";
const HELP: &str = "compare the rule and each default with the manual; if it prints them so, add an erratum for the one that is wrong";

/// Evaluates each rule that holds on every occasion with the defaults of the objects that it names.
pub(in crate::check) const LINT: Lint =
    Lint { code: CODE, page: include_str!("defaults_obey_rules.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for rule in model.rules.iter().filter(|rule| rule.on.is_none() && broken(model, rule)) {
        let Some(require) = &rule.require else { continue };
        let values: Vec<String> = rule
            .objects()
            .into_iter()
            .filter_map(|object| Some(format!("{object} = {}", model.default_int(object)?)))
            .collect();
        let text = format!("`rule {}` does not hold with the defaults {}", rule.id, values.join(", "));
        sink.push(super::finding(CODE, require.span(), &format!("rule {}", rule.id), text, WHY, HELP));
    }
}

/// Whether the defaults break a rule; never where one of them is settled by an erratum.
fn broken(model: &Model, rule: &Rule) -> bool {
    let known = |object: &Address| {
        let default = model.entry(*object).and_then(|(_, entry)| entry.default.as_ref());
        !default.is_some_and(super::settled)
    };
    let unsettled =
        !rule.require.iter().chain(&rule.when).any(super::settled) && rule.objects().iter().all(known);
    unsettled && rule.broken(|object| model.default_int(object))
}
