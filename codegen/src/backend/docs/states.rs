//! The CiA 402 state machine: how the statusword tells a state, what the controlword commands, and from where to where.

use serde::Serialize;

use super::book::Book;
use super::table::Table;

/// The page.
#[derive(Serialize)]
pub(super) struct States {
    words: String,
    commands: String,
    transitions: String,
}

/// Transitions of CiA 402 by number: from, to.
const TRANSITIONS: [(&str, &str); 17] = [
    ("power-on", "Not ready to switch on"),
    ("Not ready to switch on", "Switch on disabled"),
    ("Switch on disabled", "Ready to switch on"),
    ("Ready to switch on", "Switched on"),
    ("Switched on", "Operation enabled"),
    ("Operation enabled", "Switched on"),
    ("Switched on", "Ready to switch on"),
    ("Ready to switch on", "Switch on disabled"),
    ("Operation enabled", "Ready to switch on"),
    ("Operation enabled", "Switch on disabled"),
    ("Switched on", "Switch on disabled"),
    ("Operation enabled", "Quick stop active"),
    ("Quick stop active", "Switch on disabled"),
    ("any state", "Fault reaction active"),
    ("Fault reaction active", "Fault"),
    ("Fault", "Switch on disabled"),
    ("Quick stop active", "Operation enabled"),
];

pub(super) fn page(book: &Book<'_>) -> Option<States> {
    let model = book.model;
    (!model.states.is_empty() || !model.commands.is_empty()).then(|| States {
        words: words(book),
        commands: commands(book),
        transitions: transitions(book),
    })
}

fn words(book: &Book<'_>) -> String {
    let rows = book.model.states.iter().map(|s| {
        let pattern = book.marked(&pattern(s.mask.value, s.value.value), &[&s.mask.origin, &s.value.origin]);
        let masked = format!("{:04X}h", s.mask.value);
        let equal = format!("{:04X}h", s.value.value);
        [book.name(&s.name.value), pattern, masked, equal, book.source(&s.value.origin)]
    });
    Table::of(&["State", "Statusword", "Mask", "Masked value", "Manual"], rows).text(book.plain)
}

fn commands(book: &Book<'_>) -> String {
    let rows = book.model.commands.iter().map(|c| {
        let pattern = book.marked(&pattern(c.mask.value, c.value.value), &[&c.mask.origin, &c.value.origin]);
        let edge = book.fact(c.edge.as_ref(), |e| if *e { "rising edge" } else { "" }.to_owned());
        let list = |n: &Vec<u8>| n.iter().map(u8::to_string).collect::<Vec<_>>().join(", ");
        let transitions = book.fact(c.transitions.as_ref(), list);
        let written = format!("{:04X}h", c.value.value);
        [book.name(&c.name.value), pattern, written, edge, transitions, book.source(&c.value.origin)]
    });
    let head = ["Command", "Controlword", "Others 0", "How", "Transitions", "Manual"];
    Table::of(&head, rows).text(book.plain)
}

/// The transitions that a command triggers, by number.
fn transitions(book: &Book<'_>) -> String {
    let rows = TRANSITIONS.iter().enumerate().filter_map(|(number, (from, to))| {
        let triggers = book.model.commands.iter().filter(|c| {
            c.transitions.as_ref().is_some_and(|t| t.value.iter().any(|n| usize::from(*n) == number))
        });
        let names: Vec<String> = triggers.map(|c| book.name(&c.name.value)).collect();
        let row = [number.to_string(), (*from).to_owned(), (*to).to_owned(), names.join(", or ")];
        (!names.is_empty()).then_some(row)
    });
    Table::of(&["Transition", "From", "To", "Command"], rows).text(book.plain)
}

/// The bits that tell, with `x` for those that do not: `xxxx xxxx x01x 0111`.
fn pattern(mask: u16, value: u16) -> String {
    let bit = |n: u32| match (mask >> n & 1, value >> n & 1) {
        (0, _) => 'x',
        (_, 0) => '0',
        _ => '1',
    };
    let nibble = |n: u32| (0..4).rev().map(|b| bit(n * 4 + b)).collect::<String>();
    (0..4).rev().map(nibble).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_of_words() {
        assert_eq!(pattern(0x6F, 0x27), "xxxx xxxx x01x 0111");
        assert_eq!(pattern(0x80, 0x80), "xxxx xxxx 1xxx xxxx");
    }
}
