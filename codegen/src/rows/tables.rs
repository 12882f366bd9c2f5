//! Every table and every key, once.

use std::collections::{BTreeMap, BTreeSet};

use super::address::At;
use super::decode::{Decoder, FieldInfo, TableInfo};
use super::define::{Visit, VisitMut, tables};
use super::kind::FromRaw;
use super::value::{Bit, Count, Date, Ident, Reason, Sha256, Text, Version, Width};
use super::{Meta, Row};
use crate::diag::Sink;
use crate::model::{
    Access, Address, Cite, Direction, Edge, Effect, EmcyContent, EsmAfter, EsmState, Expr, FmmuUse,
    HomingSignal, HomingStart, HomingStatus, Led, Mapping, Moves, ObjectKind, Occasion, Reset, Side, Signal,
    Sure, SyncManagerUse, SyncMode, TerminalKind, Type, Unit, Value, When,
};
use crate::name::Name;
use crate::raw::{RawRow, RawTable, RawValue};
use crate::source::Sp;

tables! {
    /// The drive: one row.
    DriveRow in drive, key |_row| { "drive".to_owned() } {
        /// Version of the profile format: 1.
        format "format": required u32,
        /// Short id of the drive.
        id "id": required Ident,
        /// The maker's name.
        vendor "vendor": required Text,
        /// Short id of the maker; the generated package is `<vendor_id>-<id>`.
        vendor_id "vendor_id": required Ident,
        /// Product name.
        name "name": required Text,
        /// Bases whose objects the drive implements, in order.
        bases "bases": optional Vec<Ident>,
        /// Version of the generated crate.
        crate_version "crate_version": required Version,
        /// `FileVersion` of the EDS.
        eds_version "eds_version": required u8,
        /// `FileRevision` of the EDS.
        eds_revision "eds_revision": required u8,
        /// Date of the profile's last change.
        date "date": required Date,
        /// Most entries of one PDO.
        pdo_entries "pdo_entries": optional u8,
        /// Most bytes of one PDO.
        pdo_bytes "pdo_bytes": optional u16,
        /// Most PDOs of one direction that can be active together.
        pdos_per_direction "pdos_per_direction": optional u8,
        /// Where the limits of PDOs are printed.
        pdo_src "pdo_src": optional Cite,
        /// A remark for the reader.
        note "note": optional Text,
    }

    /// A document that facts cite. It is named, never contained.
    ManualRow in manuals, key |row| { format!("manual {}", row.id.value.0) } {
        /// Id in citations: `m1`.
        id "id": required Ident,
        /// Title as printed.
        title "title": required Text,
        /// Version as printed.
        version "version": required Text,
        /// Date as printed.
        date "date": optional Text,
        /// SHA-256 of the text extract whose lines are cited.
        sha256 "sha256": required Sha256,
        /// Lines of the text extract.
        lines "lines": required u32,
    }

    /// An entry of the object dictionary, several of one shape, or an index as a whole.
    ObjectRow in objects, key |row| { row.at.value.to_string() } {
        /// Address: `607D:01`, `3000:01..63`, or `607D` for the index as a whole.
        at "at": required At,
        /// Name as printed.
        name "name": optional Name,
        /// Data type.
        ty "type": optional Type,
        /// SDO access.
        access "access": optional Access,
        /// Process data that may carry it.
        pdo "pdo": optional Mapping,
        /// Unit of one count: `0.1 rpm`.
        unit "unit": optional Unit,
        /// Lowest raw value.
        min "min": optional Count,
        /// Highest raw value.
        max "max": optional Count,
        /// The only raw values allowed, where the manual lists them.
        allow "allow": optional Vec<Count>,
        /// Raw value after the first power-on.
        default "default": optional Value,
        /// Value table that names its values.
        values "values": optional Text,
        /// Bit table that names its bits.
        bits "bits": optional Text,
        /// Variable, array or record; only for an index as a whole.
        kind "kind": optional ObjectKind,
        /// The name that generated code uses, where the printed one clashes or starts with a digit.
        rename "rename": optional Name,
        /// What it is for, in your own words.
        text "text": optional Text,
        /// A remark for the reader.
        note "note": optional Text,
        /// Why the row may contradict the standard object.
        deviation "deviation": optional Text,
        /// Number of the parameter on the panel and in the drive's manual: `P1.01`.
        parameter "parameter": optional Text,
        /// When a written value takes effect.
        effect "effect": optional Effect,
        /// Fields that follow from the manual by a rule: `type: width from the range`.
        inferred "inferred": optional Vec<Reason>,
        /// Fields that a format demands and the manual never prints, with the reason for the value.
        assumed "assumed": optional Vec<Reason>,
        /// Where the manual prints a row for it again; the audit compares the values there.
        also "also": optional Cite,
        /// Where the manual prints it: `6.2 T6-2 L1230`.
        src "src": optional Cite,
    }

    /// A named value of a value table.
    EnumRow in enums, key |row| { format!("enum {}={}", row.name.value, row.value.value.0) } {
        /// The table's name.
        name "name": required Name,
        /// The value.
        value "value": required Count,
        /// The value's name.
        label "label": required Name,
        /// The name that generated code uses, where the printed one clashes or starts with a digit.
        rename "rename": optional Name,
        /// What the value does, in your own words.
        text "text": optional Text,
        /// Where the manual prints it.
        src "src": optional Cite,
    }

    /// A named bit, or several that belong together.
    BitRow in bits, key |row| {
        let mode = row.mode.map_or_else(String::new, |m| format!(" mode {}", m.value));
        format!("bits {}.{}{mode}", row.name.value, row.bit.value.0)
    } {
        /// The table's name.
        name "name": required Name,
        /// The lowest bit.
        bit "bit": required Bit,
        /// How many bits; 1 when left out.
        width "width": optional Width,
        /// The mode of operation (6060h) in which it has this meaning; every mode when left out.
        mode "mode": optional i8,
        /// The bit's name.
        label "label": required Name,
        /// The name that generated code uses, where the printed one clashes or starts with a digit.
        rename "rename": optional Name,
        /// What it does, in your own words.
        text "text": optional Text,
        /// Why the bit may differ from the standard.
        deviation "deviation": optional Text,
        /// Where the manual prints it.
        src "src": optional Cite,
    }

    /// A fault or warning.
    AlarmRow in alarms, key |row| { format!("alarm {}", row.display.value.0) } {
        /// What the panel shows.
        display "display": required Text,
        /// The maker's number.
        number "number": required u16,
        /// Error code, as 603Fh carries it.
        code "code": required u16,
        /// Auxiliary code of the emergency message.
        aux "aux": optional u16,
        /// Its name.
        name "name": required Name,
        /// The name that generated code uses, where the printed one clashes or starts with a digit.
        rename "rename": optional Name,
        /// How it is cleared.
        reset "reset": optional Reset,
        /// Causes, in your own words.
        causes "causes": optional Vec<Text>,
        /// Remedies, in your own words.
        remedies "remedies": optional Vec<Text>,
        /// States of the EtherCAT state machine in which it is detected.
        esm "esm": optional Vec<EsmState>,
        /// State of the EtherCAT state machine after it.
        esm_after "esm_after": optional EsmAfter,
        /// Synchronization in which it is detected.
        sync "sync": optional SyncMode,
        /// AL status code that it sets.
        al_status "al_status": optional u16,
        /// What the error indicator shows.
        led "led": optional Led,
        /// Where the manual prints the row.
        src "src": optional Cite,
        /// Where the manual prints causes and remedies.
        detail "detail": optional Cite,
    }

    /// An entry of a default PDO mapping.
    PdoRow in pdo, key |row| { format!("pdo {:04X}:{}", row.map.value, row.pos.value) } {
        /// Index of the mapping object.
        map "map": required u16,
        /// Direction, seen from the drive.
        dir "dir": required Direction,
        /// Place in the mapping, from 1.
        pos "pos": required u8,
        /// The mapped entry.
        entry "entry": required Address,
        /// Its length in bits.
        bits "bits": required u8,
        /// Where the manual prints it.
        src "src": optional Cite,
    }

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

    /// A SyncManager of the EtherCAT slave controller.
    SyncManagerRow in sync_managers, key |row| { format!("sync manager {}", row.number.value) } {
        /// Its number.
        number "number": required u8,
        /// What it carries.
        use_ "use": required SyncManagerUse,
        /// Where the manual prints it.
        src "src": optional Cite,
    }

    /// A fieldbus memory management unit of the EtherCAT slave controller.
    FmmuRow in fmmus, key |row| { format!("fmmu {}", row.number.value) } {
        /// Its number.
        number "number": required u8,
        /// What it maps.
        use_ "use": required FmmuUse,
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

    /// A place where the manual is wrong or contradicts itself.
    ErratumRow in errata, key |row| { format!("erratum {}", row.id.value.0) } {
        /// Id, unique in the profile.
        id "id": required Text,
        /// The row: `607D:01`, `alarm OF`, `pdo 1600:1`, `enum NAME=1`, `bits NAME.4`, `drive`.
        at "at": required Text,
        /// The key of that row.
        field "field": required Text,
        /// What is printed; the row must hold this.
        was "was": required RawValue,
        /// Where it is printed.
        seen "seen": required Cite,
        /// The value to use instead; left out, the printed one is kept.
        set "set": optional RawValue,
        /// `true`: the printed value is dropped and nothing takes its place, since no reading of it can be trusted.
        unset "unset": optional bool,
        /// Where the other reading is printed.
        by "by": optional Cite,
        /// Why.
        why "why": required Text,
        /// How sure.
        sure "sure": required Sure,
    }

    /// How a column of a printed table is read: the audit compares facts with the cells below its heading.
    ColumnRow in columns, key |row| { format!("column {}", row.header.value.0) } {
        /// The heading as printed, or the word in front of a cell.
        header "header": required Text,
        /// What its cells hold: `index`, `sub`, `name`, `unit`, `type`, `access`, `pdo`, `range`, `default`, or a key of a row.
        field "field": required Text,
        /// Whether the word stands in front of its cell and not above.
        beside "beside": optional bool,
    }

    /// What a printed word means in a column: the audit compares facts with the meaning.
    PrintedRow in printed, key |row| { format!("printed {}", row.word.value.0) } {
        /// The key that it is a value of.
        field "field": required Text,
        /// The word as printed.
        word "word": required Text,
        /// The word of profiles.
        means "means": required Text,
    }

    /// Lines of a printed table whose cells are out of place.
    ShiftedRow in shifted, key |row| { format!("shifted {}", row.lines.value.first().copied().unwrap_or(0)) } {
        /// The lines.
        lines "lines": required Vec<u32>,
        /// What their cells hold, in order; `-` for nothing.
        fields "fields": required Vec<Text>,
        /// What is out of place.
        why "why": required Text,
    }

    /// A fact that the audit cannot prove, or a difference between two places that is none, with the reason.
    UnprovedRow in unproved, key |row| { format!("unproved {}", row.at.value.0) } {
        /// The row, as `map.txt` names it; a `*` at the end stands for any rest.
        at "at": required Text,
        /// The key; all of the row when left out.
        field "field": optional Text,
        /// Why it is right all the same.
        why "why": required Text,
    }

    /// Lines of printed tables that no fact cites, with the reason.
    UncitedRow in uncited, key |row| { format!("uncited {}", row.lines.value.first().copied().unwrap_or(0)) } {
        /// The lines.
        lines "lines": required Vec<u32>,
        /// Why they hold no fact.
        why "why": required Text,
    }

    /// The last audit: written by `drivewright audit --record`.
    AuditedRow in audited, key |row| { format!("audited {}", row.manual.value.0) } {
        /// Id of the manual.
        manual "manual": required Ident,
        /// SHA-256 of the text extract that was read.
        extract "extract": required Sha256,
        /// SHA-256 of the list of facts.
        facts "facts": required Sha256,
        /// Facts that the cited lines hold.
        proved "proved": required u32,
        /// Facts that they do not, accepted with a reason.
        accepted "accepted": required u32,
        /// Lines of printed tables that facts cite.
        cited_lines "cited_lines": required u32,
        /// Lines of printed tables that none cites, accepted with a reason.
        uncited_lines "uncited_lines": required u32,
    }

    /// A finding of a lint that is accepted, with the reason.
    AllowRow in allow, key |row| { format!("allow {} {}", row.lint.value.0, row.at.value.0) } {
        /// The lint's code.
        lint "lint": required Text,
        /// The row that it concerns, as messages name it.
        at "at": required Text,
        /// Why it is accepted.
        why "why": required Text,
    }
}

impl ErratumRow {
    /// Whether the printed value is dropped.
    pub fn drops(&self) -> bool {
        self.unset.is_some_and(|unset| unset.value)
    }
}
