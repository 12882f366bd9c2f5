//! Every table and every key, once.

use std::collections::BTreeSet;

use super::address::At;
use super::decode::{Decoder, FieldInfo, TableInfo};
use super::define::{Visit, VisitMut, tables};
use super::kind::FromRaw;
use super::value::{Bit, Count, Date, Ident, Reason, Sha256, Text, Version, Width};
use super::{Meta, Row};
use crate::diag::Sink;
use crate::model::{Access, Address, Cite, Direction, Mapping, ObjectKind, Reset, Sure, Type, Unit, Value};
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
        /// Fields that follow from the manual by a rule: `type: width from the range`.
        inferred "inferred": optional Vec<Reason>,
        /// Fields that a format demands and the manual never prints, with the reason for the value.
        assumed "assumed": optional Vec<Reason>,
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
        /// Where the other reading is printed.
        by "by": optional Cite,
        /// Why.
        why "why": required Text,
        /// How sure.
        sure "sure": required Sure,
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
