//! Facts of homing, modes, states, terminals, rules, examples, and the errata.

use super::{Lines, Table, words};
use crate::model::{
    Abort, Address, Command, EmcyPart, Erratum, Example, HomingMethod, Mode, Rule, State, Terminal,
};

pub(super) fn homing<'m>(method: &'m HomingMethod, lines: &mut Lines<'m>) {
    lines.row(Table::Homing, format!("homing {}", method.number));
    lines.said("status", method.status.value.word(), &method.status.origin);
    lines.fact("same", method.same.as_ref(), i8::to_string);
    lines.fact("start", method.start.as_ref(), |w| w.word().to_owned());
    lines.fact("approach", method.approach.as_ref(), |w| w.word().to_owned());
    lines.fact("reference", method.reference.as_ref(), |w| w.word().to_owned());
    lines.fact("side", method.side.as_ref(), |w| w.word().to_owned());
    lines.fact("edge", method.edge.as_ref(), |w| w.word().to_owned());
    lines.own_text("text", method.text.as_ref());
    lines.own_text("note", method.note.as_ref());
    lines.own_text("deviation", method.deviation.as_ref());
    for (n, case) in (1_u8..).zip(&method.cases) {
        lines.row(Table::Homing, format!("homing {}.{}", method.number, case.number.unwrap_or(n)));
        lines.said("when", &case.when.value, &case.when.origin);
        lines.said("moves", &case.moves.value, &case.moves.origin);
        lines.fact("abort", case.abort.as_ref(), ToString::to_string);
        lines.fact("mask", case.mask.as_ref(), |s| words(s));
    }
}

pub(super) fn mode<'m>(mode: &'m Mode, lines: &mut Lines<'m>) {
    lines.row(Table::Modes, format!("mode {}", mode.number));
    lines.said("name", &mode.name.value, &mode.name.origin);
    let list =
        |addresses: &Vec<Address>| addresses.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
    lines.fact("objects", mode.objects.as_ref(), list);
    lines.own_text("text", mode.text.as_ref());
}

pub(super) fn state<'m>(state: &'m State, lines: &mut Lines<'m>) {
    lines.row(Table::States, format!("state {}", state.name.value));
    lines.fact("mask", Some(&state.mask), |n| format!("0x{n:04X}"));
    lines.fact("value", Some(&state.value), |n| format!("0x{n:04X}"));
}

pub(super) fn command<'m>(command: &'m Command, lines: &mut Lines<'m>) {
    lines.row(Table::Commands, format!("command {}", command.name.value));
    lines.fact("mask", Some(&command.mask), |n| format!("0x{n:04X}"));
    lines.fact("value", Some(&command.value), |n| format!("0x{n:04X}"));
    lines.fact("edge", command.edge.as_ref(), bool::to_string);
    let list = |numbers: &Vec<u8>| numbers.iter().map(u8::to_string).collect::<Vec<_>>().join(" ");
    lines.fact("transitions", command.transitions.as_ref(), list);
}

pub(super) fn abort<'m>(abort: &'m Abort, lines: &mut Lines<'m>) {
    lines.row(Table::Aborts, format!("abort {:08X}", abort.code.value));
    lines.said("name", &abort.name.value, &abort.name.origin);
}

pub(super) fn terminal<'m>(terminal: &'m Terminal, lines: &mut Lines<'m>) {
    lines.row(Table::Terminals, format!("terminal {}", terminal.name));
    lines.said("kind", terminal.kind.value.word(), &terminal.kind.origin);
    lines.fact("pin", terminal.pin.as_ref(), u8::to_string);
    lines.fact("object", terminal.object.as_ref(), Address::to_string);
    lines.fact("bit", terminal.bit.as_ref(), u8::to_string);
    lines.fact("parameter", terminal.parameter.as_ref(), Clone::clone);
    lines.own_text("text", terminal.text.as_ref());
    lines.own_text("note", terminal.note.as_ref());
}

pub(super) fn emcy<'m>(part: &'m EmcyPart, lines: &mut Lines<'m>) {
    lines.row(Table::Emcy, format!("emcy {}", part.byte));
    lines.fact("bytes", Some(&part.bytes), u8::to_string);
    lines.said("holds", part.holds.value.word(), &part.holds.origin);
    lines.own_text("text", part.text.as_ref());
}

pub(super) fn rule<'m>(rule: &'m Rule, lines: &mut Lines<'m>) {
    lines.row(Table::Rules, format!("rule {}", rule.id));
    lines.said("text", &rule.text.value, &rule.text.origin);
    lines.fact("require", rule.require.as_ref(), ToString::to_string);
    lines.fact("when", rule.when.as_ref(), ToString::to_string);
    lines.fact("on", rule.on.as_ref(), |o| o.word().to_owned());
}

pub(super) fn example<'m>(example: &'m Example, lines: &mut Lines<'m>) {
    lines.row(Table::Examples, format!("example {}", example.label()));
    lines.fact("write", example.write.as_ref(), ToString::to_string);
    lines.fact("entry", example.entry.as_ref(), Address::to_string);
    lines.fact("bits", example.bits.as_ref(), u8::to_string);
    lines.fact("parameter", example.parameter.as_ref(), Clone::clone);
    // Mapping words are read by their digits; a number below 0 has none.
    let digits = |n: &i128| if *n < 0 { n.to_string() } else { format!("0x{n:X}") };
    lines.fact("value", example.value.as_ref(), digits);
    lines.fact("min", example.min.as_ref(), i128::to_string);
    lines.fact("max", example.max.as_ref(), i128::to_string);
    lines.own_text("text", example.text.as_ref());
}

/// The values of an erratum carry the places where they are printed, and are no facts of their own.
pub(super) fn erratum<'m>(erratum: &'m Erratum, lines: &mut Lines<'m>) {
    lines.row(Table::Errata, format!("erratum {}", erratum.id));
    lines.own("at", &erratum.at);
    lines.own("field", &erratum.field);
    lines.line("was".into(), erratum.was.clone(), (None, Some(&erratum.seen), None));
    let kept = if erratum.unset { "the printed value is dropped" } else { "the printed value is kept" };
    let set = erratum.set.clone().unwrap_or_else(|| kept.to_owned());
    lines.line("set".into(), set, (None, erratum.by.as_ref(), None));
    lines.own("why", &erratum.why);
    lines.own("sure", erratum.sure.word());
}
