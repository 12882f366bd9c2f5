//! Homing, modes, states, terminals, rules and examples: their shape, and how the model becomes it.

use super::known::{known, maybe};
use super::schema::{Field, Shape, Struct};
use super::value::{Integer, Known, Word, shapes};
use super::write::{Json, Writer};
use crate::model::{
    self, Address, Edge, EmcyContent, HomingSignal, HomingStart, HomingStatus, Model, Occasion, Side, Signal,
    TerminalKind,
};

shapes! {
    /// A homing method (6098h). A method with `same` has the cases of that one.
    Homing<'m> {
        /// The value of 6098h.
        number "number": required i8,
        /// Whether the drive has it.
        status "status": required Known<'m, Word<HomingStatus>>,
        /// The method that it is the same as.
        same "same": optional Known<'m, i8>,
        /// Direction of the first move, as the manual's table has it.
        start "start": optional Known<'m, Word<HomingStart>>,
        /// Signal that ends the fast move, as the manual's table has it.
        approach "approach": optional Known<'m, Word<HomingSignal>>,
        /// Signal that is the home, as the manual's table has it.
        reference "reference": optional Known<'m, Word<HomingSignal>>,
        /// Side of the approach signal on which home lies.
        side "side": optional Known<'m, Word<Side>>,
        /// Edge of the approach signal that counts.
        edge "edge": optional Known<'m, Word<Edge>>,
        /// What the axis does, told apart by the start.
        cases "cases": required Vec<HomingCase<'m>>,
        /// What to know about it.
        text "text": optional &'m str,
        /// A remark for the reader.
        note "note": optional &'m str,
        /// Why it may differ from the standard method.
        deviation "deviation": optional &'m str,
    }

    /// A case of a homing method. The language is described in the documentation of profiles.
    HomingCase<'m> {
        /// Its number, from 1.
        number "number": required u8,
        /// At which start it holds: levels with commas between, or `any`.
        when "when": required Known<'m, String>,
        /// Steps with `; ` between.
        moves "moves": required Known<'m, String>,
        /// What ends it with an error.
        abort "abort": optional Known<'m, String>,
        /// Signals without effect while it runs.
        mask "mask": optional Known<'m, Vec<Word<Signal>>>,
    }

    /// A mode of operation.
    Mode<'m> {
        /// The value of 6060h.
        number "number": required i8,
        /// The printed name.
        name "name": required Known<'m, &'m str>,
        /// Objects that its section lists, in the order printed.
        objects "objects": optional Known<'m, Vec<String>>,
        /// What it does.
        text "text": optional &'m str,
    }

    /// A state of the CiA 402 state machine: the statusword under a mask has a value.
    State<'m> {
        /// Its name.
        name "name": required &'m str,
        /// The bits that tell.
        mask "mask": required Known<'m, u16>,
        /// Their value.
        value "value": required Known<'m, u16>,
    }

    /// A command of the CiA 402 state machine: the controlword under a mask has a value.
    Command<'m> {
        /// Its name.
        name "name": required &'m str,
        /// The bits that tell.
        mask "mask": required Known<'m, u16>,
        /// Their value.
        value "value": required Known<'m, u16>,
        /// Whether a rising edge of these bits is the command.
        edge "edge": optional Known<'m, bool>,
        /// Transitions that it triggers.
        transitions "transitions": optional Known<'m, Vec<u8>>,
    }

    /// An abort code of SDO transfers.
    Abort<'m> {
        /// The code as text: eight hexadecimal digits.
        at "at": required String,
        /// The code.
        code "code": required u32,
        /// What it means.
        name "name": required Known<'m, &'m str>,
    }

    /// A terminal of the drive.
    Terminal<'m> {
        /// Its printed name.
        name "name": required &'m str,
        /// What it is.
        kind "kind": required Known<'m, Word<TerminalKind>>,
        /// Number of the pin.
        pin "pin": optional Known<'m, u8>,
        /// Object in which its state is read.
        object "object": optional Known<'m, String>,
        /// Bit of that object.
        bit "bit": optional Known<'m, u8>,
        /// Parameter that gives it its function.
        parameter "parameter": optional Known<'m, &'m str>,
        /// What it is for.
        text "text": optional &'m str,
        /// A remark for the reader.
        note "note": optional &'m str,
    }

    /// Bytes of the emergency message.
    Emcy<'m> {
        /// The first byte, from 0.
        byte "byte": required u8,
        /// How many bytes.
        bytes "bytes": required Known<'m, u8>,
        /// What they hold.
        holds "holds": required Known<'m, Word<EmcyContent>>,
        /// What to know about them.
        text "text": optional &'m str,
    }

    /// A rule between values.
    Rule<'m> {
        /// Its id.
        id "id": required &'m str,
        /// The rule in words.
        text "text": required Known<'m, &'m str>,
        /// What must hold: an expression over objects.
        require "require": optional Known<'m, &'m str>,
        /// Under which condition: an expression over objects.
        when "when": optional Known<'m, &'m str>,
        /// On which occasion; left out for always.
        on "on": optional Known<'m, Word<Occasion>>,
    }

    /// A step of a worked example.
    Example<'m> {
        /// Id of the example.
        id "id": required &'m str,
        /// Number of the step, where it has several.
        step "step": optional u8,
        /// The objects that are written: one address, or a range of sub-indexes.
        write "write": optional Known<'m, String>,
        /// The object that a mapping word names, or where a parameter is.
        entry "entry": optional Known<'m, String>,
        /// Length in bits in a mapping word.
        bits "bits": optional Known<'m, u8>,
        /// Parameter whose place is shown.
        parameter "parameter": optional Known<'m, &'m str>,
        /// The value that is written, or the mapping word.
        value "value": optional Known<'m, Integer>,
        /// Lowest value of those that may be written.
        min "min": optional Known<'m, Integer>,
        /// Highest value of those that may be written.
        max "max": optional Known<'m, Integer>,
        /// What it shows.
        text "text": optional &'m str,
    }
}

pub(super) fn homing<'m>(model: &'m Model, method: &'m model::HomingMethod) -> Homing<'m> {
    let cases = (1..).zip(&method.cases).map(|(n, case)| HomingCase {
        number: case.number.unwrap_or(n),
        when: known(model, case.when.value.to_string(), &case.when.origin),
        moves: known(model, case.moves.value.to_string(), &case.moves.origin),
        abort: maybe(model, case.abort.as_ref(), ToString::to_string),
        mask: maybe(model, case.mask.as_ref(), |s| s.iter().copied().map(Word).collect()),
    });
    Homing {
        number: method.number,
        status: known(model, Word(method.status.value), &method.status.origin),
        same: maybe(model, method.same.as_ref(), |n| *n),
        start: maybe(model, method.start.as_ref(), |w| Word(*w)),
        approach: maybe(model, method.approach.as_ref(), |w| Word(*w)),
        reference: maybe(model, method.reference.as_ref(), |w| Word(*w)),
        side: maybe(model, method.side.as_ref(), |w| Word(*w)),
        edge: maybe(model, method.edge.as_ref(), |w| Word(*w)),
        cases: cases.collect(),
        text: method.text.as_deref(),
        note: method.note.as_deref(),
        deviation: method.deviation.as_deref(),
    }
}

pub(super) fn mode<'m>(model: &'m Model, mode: &'m model::Mode) -> Mode<'m> {
    let list = |objects: &'m Vec<Address>| objects.iter().map(ToString::to_string).collect();
    Mode {
        number: mode.number,
        name: known(model, mode.name.value.original(), &mode.name.origin),
        objects: maybe(model, mode.objects.as_ref(), list),
        text: mode.text.as_deref(),
    }
}

pub(super) fn state<'m>(model: &'m Model, state: &'m model::State) -> State<'m> {
    State {
        name: state.name.value.original(),
        mask: known(model, state.mask.value, &state.mask.origin),
        value: known(model, state.value.value, &state.value.origin),
    }
}

pub(super) fn command<'m>(model: &'m Model, command: &'m model::Command) -> Command<'m> {
    Command {
        name: command.name.value.original(),
        mask: known(model, command.mask.value, &command.mask.origin),
        value: known(model, command.value.value, &command.value.origin),
        edge: maybe(model, command.edge.as_ref(), |e| *e),
        transitions: maybe(model, command.transitions.as_ref(), Clone::clone),
    }
}

pub(super) fn abort<'m>(model: &'m Model, abort: &'m model::Abort) -> Abort<'m> {
    Abort {
        at: format!("{:08X}", abort.code.value),
        code: abort.code.value,
        name: known(model, &abort.name.value, &abort.name.origin),
    }
}

pub(super) fn terminal<'m>(model: &'m Model, terminal: &'m model::Terminal) -> Terminal<'m> {
    Terminal {
        name: &terminal.name,
        kind: known(model, Word(terminal.kind.value), &terminal.kind.origin),
        pin: maybe(model, terminal.pin.as_ref(), |p| *p),
        object: maybe(model, terminal.object.as_ref(), ToString::to_string),
        bit: maybe(model, terminal.bit.as_ref(), |b| *b),
        parameter: maybe(model, terminal.parameter.as_ref(), String::as_str),
        text: terminal.text.as_deref(),
        note: terminal.note.as_deref(),
    }
}

pub(super) fn emcy<'m>(model: &'m Model, part: &'m model::EmcyPart) -> Emcy<'m> {
    Emcy {
        byte: part.byte,
        bytes: known(model, part.bytes.value, &part.bytes.origin),
        holds: known(model, Word(part.holds.value), &part.holds.origin),
        text: part.text.as_deref(),
    }
}

pub(super) fn rule<'m>(model: &'m Model, rule: &'m model::Rule) -> Rule<'m> {
    Rule {
        id: &rule.id,
        text: known(model, &rule.text.value, &rule.text.origin),
        require: maybe(model, rule.require.as_ref(), |e| e.text.as_str()),
        when: maybe(model, rule.when.as_ref(), |e| e.text.as_str()),
        on: maybe(model, rule.on.as_ref(), |o| Word(*o)),
    }
}

pub(super) fn example<'m>(model: &'m Model, example: &'m model::Example) -> Example<'m> {
    Example {
        id: &example.id,
        step: example.step,
        write: maybe(model, example.write.as_ref(), ToString::to_string),
        entry: maybe(model, example.entry.as_ref(), ToString::to_string),
        bits: maybe(model, example.bits.as_ref(), |b| *b),
        parameter: maybe(model, example.parameter.as_ref(), String::as_str),
        value: maybe(model, example.value.as_ref(), |n| Integer(*n)),
        min: maybe(model, example.min.as_ref(), |n| Integer(*n)),
        max: maybe(model, example.max.as_ref(), |n| Integer(*n)),
        text: example.text.as_deref(),
    }
}
