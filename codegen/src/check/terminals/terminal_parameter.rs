//! W1602: a terminal names a parameter that no object has.

use std::collections::BTreeSet;

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Fact, Model};

const CODE: Code = Code::warning("W1602", "a terminal names a parameter that no object has");
const WHY: &str = "the function of the terminal cannot be set over the bus as far as the profile tells";
const HELP: &str = "add `parameter` to the object, or correct the number";

/// Looks for the parameter of each terminal among those of the objects, in drives whose objects state parameters.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("terminal_parameter.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let parameters = model.entries.iter().filter_map(|(_, entry)| entry.parameter.as_ref());
    let known: BTreeSet<&str> = parameters.map(|parameter| parameter.value.as_str()).collect();
    for terminal in model.terminals.iter().filter(|_| !known.is_empty()) {
        let unknown = |parameter: &&Fact<String>| !known.contains(parameter.value.as_str());
        let parameter = super::unsettled(terminal.parameter.as_ref()).filter(unknown);
        let Some(parameter) = parameter else { continue };
        let text = format!("`terminal {}` names {}, which no object has", terminal.name, parameter.value);
        sink.push(super::finding(
            CODE,
            parameter.span(),
            &format!("terminal {}", terminal.name),
            text,
            WHY,
            HELP,
        ));
    }
}
