//! Homing, modes, states, terminals, rules and examples.

use std::collections::BTreeMap;

use crate::diag::Sink;
use crate::model::{
    Address, Cite, Edge, EmcyContent, Expr, HomingSignal, HomingStart, HomingStatus, Moves, Occasion, Side,
    Signal, TerminalKind, When,
};
use crate::name::Name;
use crate::raw::RawRow;
use crate::rows::address::At;
use crate::rows::decode::{Decoder, FieldInfo, TableInfo};
use crate::rows::define::rows;
use crate::rows::kind::FromRaw;
use crate::rows::value::{Bit, Count, Reason, Text};
use crate::rows::{Meta, Row};
use crate::source::Sp;

rows! {
    /// A case of a homing method, or what the manual says of a method without cases.
    HomingRow in homing, key |row| {
        let case = row.case.map_or_else(String::new, |c| format!(".{}", c.value));
        format!("homing {}{case}", row.method.value)
    } {
        /// The value of 6098h.
        method "method": required i8,
        /// Number of the case, where a method has several.
        case "case": optional u8,
        /// Whether the drive has it; it has it when left out.
        status "status": optional HomingStatus,
        /// The method that the manual calls it the same as.
        same "same": optional i8,
        /// Direction of the first move, as a column of the manual's table.
        start "start": optional HomingStart,
        /// Signal that ends the fast move, as a column of the manual's table.
        approach "approach": optional HomingSignal,
        /// Signal that is the home, as a column of the manual's table.
        reference "reference": optional HomingSignal,
        /// Side of the approach signal on which home lies, as a column of the manual's table.
        side "side": optional Side,
        /// Edge of the approach signal that counts, as a column of the manual's table.
        edge "edge": optional Edge,
        /// At which start the case holds: `home off, negative_limit off`, `any`.
        when "when": optional When,
        /// What the axis does: `- fast until negative_limit on; + slow until negative_limit off; latch`.
        moves "moves": optional Moves,
        /// What ends homing with an error: `positive_limit on`.
        abort "abort": optional When,
        /// Signals without effect while homing runs.
        mask "mask": optional Vec<Signal>,
        /// What to know about it, in your own words.
        text "text": optional Text,
        /// A remark for the reader.
        note "note": optional Text,
        /// Why it may differ from the standard method.
        deviation "deviation": optional Text,
        /// Fields that follow from the manual by a rule.
        inferred "inferred": optional Vec<Reason>,
        /// Where the manual prints it.
        src "src": optional Cite,
    }

    /// A mode of operation.
    ModeRow in modes, key |row| { format!("mode {}", row.mode.value) } {
        /// The value of 6060h.
        mode "mode": required i8,
        /// Its name as printed.
        name "name": required Name,
        /// Objects that its section lists, in the order printed.
        objects "objects": optional Vec<Address>,
        /// What it does, in your own words.
        text "text": optional Text,
        /// Where the manual prints its name.
        src "src": optional Cite,
        /// Where the manual lists its objects.
        objects_src "objects_src": optional Cite,
    }

    /// A state of the CiA 402 state machine: the statusword under a mask.
    StateRow in states, key |row| { format!("state {}", row.name.value) } {
        /// Its name.
        name "name": required Name,
        /// The bits that tell.
        mask "mask": required u16,
        /// Their value.
        value "value": required u16,
        /// Where the manual prints it.
        src "src": optional Cite,
    }

    /// A command of the CiA 402 state machine: the controlword under a mask.
    CommandRow in commands, key |row| { format!("command {}", row.name.value) } {
        /// Its name.
        name "name": required Name,
        /// The bits that tell.
        mask "mask": required u16,
        /// Their value.
        value "value": required u16,
        /// `true`: a rising edge of these bits is the command.
        edge "edge": optional bool,
        /// Transitions that it triggers, by their numbers in CiA 402.
        transitions "transitions": optional Vec<u8>,
        /// Where the manual prints it.
        src "src": optional Cite,
    }

    /// An abort code that the drive answers SDO transfers with.
    AbortRow in aborts, key |row| { format!("abort {:08X}", row.code.value) } {
        /// The code.
        code "code": required u32,
        /// What it means, in your own words.
        name "name": required Text,
        /// Where the manual prints it.
        src "src": optional Cite,
    }

    /// A terminal of the drive.
    TerminalRow in io, key |row| { format!("terminal {}", row.terminal.value.0) } {
        /// Its name as printed.
        terminal "terminal": required Text,
        /// What it is.
        kind "kind": required TerminalKind,
        /// Number of the pin.
        pin "pin": optional u8,
        /// Object in which its state is read.
        object "object": optional Address,
        /// Bit of that object.
        bit "bit": optional Bit,
        /// Parameter that gives it its function.
        parameter "parameter": optional Text,
        /// What it is for, in your own words.
        text "text": optional Text,
        /// A remark for the reader.
        note "note": optional Text,
        /// Fields that follow from the manual by a rule.
        inferred "inferred": optional Vec<Reason>,
        /// Where the manual prints it.
        src "src": optional Cite,
    }

    /// Bytes of the emergency message.
    EmcyRow in emcy, key |row| { format!("emcy {}", row.byte.value) } {
        /// The first byte, from 0.
        byte "byte": required u8,
        /// How many bytes.
        bytes "bytes": required u8,
        /// What they hold.
        holds "holds": required EmcyContent,
        /// What to know about them, in your own words.
        text "text": optional Text,
        /// Fields that follow from the manual by a rule.
        inferred "inferred": optional Vec<Reason>,
        /// Where the manual prints it.
        src "src": optional Cite,
    }

    /// A rule between values.
    RuleRow in rules, key |row| { format!("rule {}", row.id.value.0) } {
        /// Id, unique in the profile.
        id "id": required Text,
        /// The rule, in your own words.
        text "text": required Text,
        /// What must hold: `1C33:03 % 62500 == 0`.
        require "require": optional Expr,
        /// Under which condition.
        when "when": optional Expr,
        /// On which occasion; always when left out.
        on "on": optional Occasion,
        /// Where the manual prints it.
        src "src": optional Cite,
    }

    /// A step of a worked example of the manual: a test vector.
    ExampleRow in examples, key |row| {
        let step = row.step.map_or_else(String::new, |s| format!(".{}", s.value));
        format!("example {}{step}", row.id.value.0)
    } {
        /// Id of the example.
        id "id": required Text,
        /// Number of the step, where it has several.
        step "step": optional u8,
        /// The object that is written; a range of sub-indexes for several.
        write "write": optional At,
        /// The object that a mapping word names, or where a parameter is.
        entry "entry": optional Address,
        /// Length in bits in a mapping word.
        bits "bits": optional u8,
        /// Parameter whose place is shown.
        parameter "parameter": optional Text,
        /// The value that is written, or the mapping word.
        value "value": optional Count,
        /// Lowest value of those that may be written.
        min "min": optional Count,
        /// Highest value of those that may be written.
        max "max": optional Count,
        /// What it shows, in your own words.
        text "text": optional Text,
        /// Where the manual prints it.
        src "src": optional Cite,
    }
}
