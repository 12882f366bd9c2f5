//! The object dictionary, named values and bits, alarms and process data.

use std::collections::BTreeMap;

use crate::diag::Sink;
use crate::model::{
    Access, Address, Cite, Direction, Effect, EsmAfter, EsmState, Led, Mapping, ObjectKind, Reset, SyncMode,
    Type, Unit, Value,
};
use crate::name::Name;
use crate::raw::RawRow;
use crate::rows::address::At;
use crate::rows::decode::{Decoder, FieldInfo, TableInfo};
use crate::rows::define::rows;
use crate::rows::kind::FromRaw;
use crate::rows::value::{Bit, Count, Printed, Reason, Text, Width};
use crate::rows::{Meta, Row};
use crate::source::Sp;

rows! {
    /// An entry of the object dictionary, several of one shape, or an index as a whole.
    ObjectRow in objects, key |row| { row.at.value.to_string() } {
        /// Address: `607D:01`, `3000:01..63`, or `607D` for the index as a whole.
        at "at": required At,
        /// Name as printed.
        name "name": optional Printed,
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
        /// The name that generated code uses, where the printed one clashes, starts with a digit or is in another script.
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
        label "label": required Printed,
        /// The name that generated code uses, where the printed one clashes, starts with a digit or is in another script.
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
        label "label": required Printed,
        /// The name that generated code uses, where the printed one clashes, starts with a digit or is in another script.
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
        name "name": required Printed,
        /// The name that generated code uses, where the printed one clashes, starts with a digit or is in another script.
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
}
