//! W1403: a state or command of CiA 402 has other bits than in the standard.

use drivewright_runtime::cia402;

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Fact, Model};
use crate::name::Name;

const CODE: Code =
    Code::warning("W1403", "a state or command of CiA 402 has other bits than in the standard");
const WHY: &str = "every CiA 402 client decodes and writes the words of the standard: with others it would misread this drive";
const HELP: &str = "compare bit by bit with the manual; if it prints them so, accept the finding with the reason in `allow`, or add an erratum";

/// Compares states and commands that are called as in CiA 402 with those of CiA 402.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("standard_words.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for state in &model.states {
        let standard = cia402::State::ALL.iter().find(|s| is(&state.name, s.word())).map(|s| s.pattern());
        let own = (state.mask.value, state.value.value);
        let settled = super::settled(&state.mask) || super::settled(&state.value);
        if let Some((mask, value)) = standard.filter(|standard| *standard != own && !settled) {
            let standard = format!("{value:04X}h under {mask:04X}h");
            report(sink, "state", &state.name, &state.value, own, &standard);
        }
    }
    for command in &model.commands {
        let standard = cia402::Command::ALL.iter().find(|c| is(&command.name, c.word())).map(|c| c.bits());
        let own = (command.mask.value, command.value.value);
        let settled = super::settled(&command.mask) || super::settled(&command.value);
        // Bits outside the mask do not tell the command; which are inside, sources print differently.
        if let Some(bits) = standard.filter(|bits| (bits ^ own.1) & own.0 != 0 && !settled) {
            report(sink, "command", &command.name, &command.value, own, &format!("{bits:04X}h"));
        }
    }
}

/// Whether a printed name is that of the standard, but for upper and lower case.
fn is(name: &Fact<Name>, standard: &str) -> bool {
    Name::new(standard).is_some_and(|standard| standard.words() == name.value.words())
}

fn report(sink: &mut Sink, kind: &str, name: &Fact<Name>, at: &Fact<u16>, own: (u16, u16), standard: &str) {
    let row = format!("{kind} {}", name.value);
    let text = format!("`{row}` is {:04X}h under {:04X}h, and in CiA 402 {standard}", own.1, own.0);
    sink.push(super::finding(CODE, at.span(), &row, text, WHY, HELP));
}
