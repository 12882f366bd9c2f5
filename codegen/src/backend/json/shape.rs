//! The shape of `model.json`, format 1. The comments of the fields are the descriptions in its schema.
//!
//! Keys come in the order of the fields. A key whose value nobody states is left out; lists are always there.

use super::behaviour::{Abort, Command, Emcy, Example, Homing, Mode, Rule, State, Terminal};
use super::ethercat::{Coe, DcMode, EtherCat, Fmmu, StartUp, SyncManager};
use super::schema::{Field, Shape, Struct};
use super::value::{Integer, Known, Word, shapes};
use super::write::{Json, Writer};
use crate::model::{
    Access, Direction, Effect, EsmAfter, EsmState, Led, Mapping, ObjectKind, Quantity, Reset, Sure, SyncMode,
    Type,
};

shapes! {
    /// Facts of a drive for other programs. Written by drivewright; the profile is what people edit.
    Document<'m> {
        /// Version of this format. Another number means another shape; a reader ignores keys that it does not know.
        format "format": required u8,
        /// What this file is.
        about "about": required &'m str,
        /// The drive.
        drive "drive": required Drive<'m>,
        /// What the drive says about itself: the defaults of 1000h and 1018h, whose entries say who states them.
        identity "identity": required Identity,
        /// The documents that citations name.
        manuals "manuals": required Vec<Manual<'m>>,
        /// The object dictionary, ascending.
        objects "objects": required Vec<Object<'m>>,
        /// Value tables, by name.
        enums "enums": required Vec<Enum<'m>>,
        /// Bit tables, by name.
        bits "bits": required Vec<Bits<'m>>,
        /// Default process data, by index.
        pdos "pdos": required Vec<Pdo<'m>>,
        /// Faults and warnings, by number and display.
        alarms "alarms": required Vec<Alarm<'m>>,
        /// Homing methods, ascending.
        homing "homing": required Vec<Homing<'m>>,
        /// Modes of operation, ascending.
        modes "modes": required Vec<Mode<'m>>,
        /// States of the CiA 402 state machine.
        states "states": required Vec<State<'m>>,
        /// Commands of the CiA 402 state machine.
        commands "commands": required Vec<Command<'m>>,
        /// Abort codes of SDO transfers, ascending.
        aborts "aborts": required Vec<Abort<'m>>,
        /// Terminals.
        terminals "terminals": required Vec<Terminal<'m>>,
        /// What device files say of an EtherCAT drive as a whole.
        ethercat "ethercat": required EtherCat<'m>,
        /// SyncManagers of the EtherCAT slave controller, by number.
        sync_managers "sync_managers": required Vec<SyncManager<'m>>,
        /// FMMUs of the EtherCAT slave controller, by number.
        fmmus "fmmus": required Vec<Fmmu<'m>>,
        /// What CoE can and cannot do, where somebody says it.
        coe "coe": required Vec<Coe<'m>>,
        /// Ways to synchronize, the first by default.
        dc_modes "dc_modes": required Vec<DcMode<'m>>,
        /// What a master must write at start-up, in order.
        startup "startup": required Vec<StartUp<'m>>,
        /// The emergency message, by byte.
        emcy "emcy": required Vec<Emcy<'m>>,
        /// Rules between values, by id.
        rules "rules": required Vec<Rule<'m>>,
        /// Worked examples of the manual, by id and step.
        examples "examples": required Vec<Example<'m>>,
        /// Where the manual is wrong or contradicts itself, by id.
        errata "errata": required Vec<Erratum<'m>>,
    }

    /// Who made the drive, and the versions of what is generated.
    Drive<'m> {
        /// Short id.
        id "id": required &'m str,
        /// Name of the generated crate and folder.
        package "package": required &'m str,
        /// Maker.
        vendor "vendor": required &'m str,
        /// Product name.
        name "name": required &'m str,
        /// Version of the generated crate.
        crate_version "crate_version": required &'m str,
        /// `FileVersion` of the EDS.
        eds_version "eds_version": required u8,
        /// `FileRevision` of the EDS.
        eds_revision "eds_revision": required u8,
        /// Date of the profile's last change.
        date "date": required &'m str,
        /// Bases whose objects the drive implements, in order.
        bases "bases": required Vec<&'m str>,
        /// Most entries of one PDO.
        pdo_entries "pdo_entries": optional Known<'m, u8>,
        /// Most bytes of one PDO.
        pdo_bytes "pdo_bytes": optional Known<'m, u16>,
        /// Most PDOs of one direction that can be active together.
        pdos_per_direction "pdos_per_direction": optional Known<'m, u8>,
        /// A remark for the reader.
        note "note": optional &'m str,
    }

    /// What the drive says about itself; a key that is left out is stated by nobody.
    Identity {
        /// Device type, 1000:00.
        device_type "device_type": optional Integer,
        /// Vendor id, 1018:01.
        vendor_id "vendor_id": optional Integer,
        /// Product code, 1018:02.
        product_code "product_code": optional Integer,
        /// Revision number, 1018:03.
        revision "revision": optional Integer,
    }

    /// A document that facts cite.
    Manual<'m> {
        /// Id in citations.
        id "id": required &'m str,
        /// Title as printed.
        title "title": required &'m str,
        /// Version as printed.
        version "version": required &'m str,
        /// Date as printed.
        date "date": optional &'m str,
        /// SHA-256 of the text extract whose lines are cited.
        sha256 "sha256": required &'m str,
        /// Lines of the text extract.
        lines "lines": required u32,
    }

    /// An index of the dictionary.
    Object<'m> {
        /// The index as text: four hexadecimal digits.
        at "at": required String,
        /// The index.
        index "index": required u16,
        /// What it is called.
        name "name": required Known<'m, &'m str>,
        /// Variable, array or record.
        kind "kind": required Known<'m, Word<ObjectKind>>,
        /// What it is for as a whole.
        text "text": optional &'m str,
        /// A remark for the reader on the object as a whole.
        note "note": optional &'m str,
        /// Why the object as a whole may differ from the standard one.
        deviation "deviation": optional &'m str,
        /// Where the manual prints a row for the object as a whole again.
        also "also": optional String,
        /// Its entries, ascending by sub-index.
        entries "entries": required Vec<Entry<'m>>,
    }

    /// An index and sub-index of the dictionary.
    Entry<'m> {
        /// Index and sub-index as text, hexadecimal: `607D:01`.
        at "at": required String,
        /// The index.
        index "index": required u16,
        /// The sub-index.
        sub "sub": required u8,
        /// The name in generated code, words joined by `_`; unique among all entries.
        handle "handle": required String,
        /// The printed name.
        name "name": required Known<'m, &'m str>,
        /// Data type: `i8` to `u64` are integers of that width, `f32` and `f64` floating point.
        ty "type": required Known<'m, Word<Type>>,
        /// Width in process data in bits; left out for texts and domains.
        width "width": optional u8,
        /// SDO access.
        access "access": required Known<'m, Word<Access>>,
        /// Process data that may carry it, seen from the drive.
        pdo "pdo": optional Known<'m, Word<Mapping>>,
        /// Unit of one raw count.
        unit "unit": optional Known<'m, Unit<'m>>,
        /// Lowest raw value.
        min "min": optional Known<'m, Integer>,
        /// Highest raw value.
        max "max": optional Known<'m, Integer>,
        /// The only raw values allowed, where the manual lists them.
        allow "allow": optional Known<'m, Vec<Integer>>,
        /// Raw value after the first power-on, of an object that is a number.
        default "default": optional Known<'m, Integer>,
        /// The same, of an object that is a text, and `$NODEID+0x200` where a number depends on the node.
        default_text "default_text": optional Known<'m, &'m str>,
        /// Name of the value table that names its values.
        values "values": optional Known<'m, &'m str>,
        /// Name of the bit table that names its bits.
        bits "bits": optional Known<'m, &'m str>,
        /// Number of the parameter on the panel and in the drive's manual.
        parameter "parameter": optional Known<'m, &'m str>,
        /// When a written value takes effect.
        effect "effect": optional Known<'m, Word<Effect>>,
        /// What it is for.
        text "text": optional &'m str,
        /// A remark for the reader.
        note "note": optional &'m str,
        /// Why it may differ from the standard object.
        deviation "deviation": optional &'m str,
        /// Where the manual prints a row for it again.
        also "also": optional String,
    }

    /// One raw count is `num / den` base units. A count of `0.1 rpm` has `num` 1, `den` 10 and base unit `rpm`.
    Unit<'m> {
        /// As the profile writes it.
        text "text": required &'m str,
        /// What is measured.
        quantity "quantity": required Word<Quantity>,
        /// Symbol of the base unit; `1` for a bare share.
        base "base_unit": required &'m str,
        /// Numerator, not 0.
        num "num": required u32,
        /// Denominator, not 0.
        den "den": required u32,
    }

    /// A value table.
    Enum<'m> {
        /// Its name.
        name "name": required &'m str,
        /// Its values, ascending.
        values "values": required Vec<EnumValue<'m>>,
    }

    /// A named value.
    EnumValue<'m> {
        /// The raw value.
        value "value": required Integer,
        /// The name in generated code, words joined by `_`; unique in its table.
        handle "handle": required String,
        /// The printed name.
        name "name": required Known<'m, &'m str>,
        /// What it does.
        text "text": optional &'m str,
    }

    /// A bit table.
    Bits<'m> {
        /// Its name.
        name "name": required &'m str,
        /// Its fields, those of every mode first, then by mode and bit.
        fields "fields": required Vec<BitField<'m>>,
    }

    /// One or more bits with a name.
    BitField<'m> {
        /// Lowest bit.
        bit "bit": required u8,
        /// How many bits.
        width "width": required u8,
        /// Mode of operation (6060h) in which the bits have this meaning; left out for every mode.
        mode "mode": optional i8,
        /// The name in generated code, words joined by `_`; unique among the fields of its mode.
        handle "handle": required String,
        /// The printed name.
        name "name": required Known<'m, &'m str>,
        /// What it does.
        text "text": optional &'m str,
        /// Why it may differ from the standard.
        deviation "deviation": optional &'m str,
    }

    /// A process data object with its default mapping. Byte 0 is the first on the wire; bit 0 the lowest of a byte.
    Pdo<'m> {
        /// Index of the mapping object as text.
        at "at": required String,
        /// Index of the mapping object.
        index "index": required u16,
        /// `rx`: the drive receives it. `tx`: the drive sends it.
        direction "direction": required Known<'m, Word<Direction>>,
        /// Length in bits.
        bits "bits": required u32,
        /// Length in bytes, the last one full or not.
        bytes "bytes": required u32,
        /// What it carries, in order.
        entries "entries": required Vec<PdoEntry<'m>>,
    }

    /// A mapped entry.
    PdoEntry<'m> {
        /// Place in the mapping, from 1.
        position "position": required u8,
        /// Index of the entry.
        index "index": required u16,
        /// Sub-index of the entry.
        sub "sub": required u8,
        /// The entry as text.
        entry "entry": required Known<'m, String>,
        /// Byte in which it starts.
        byte "byte": required u32,
        /// Bit of that byte in which it starts: 0 unless bits are packed.
        bit "bit": required u32,
        /// Length in bits.
        bits "bits": required Known<'m, u8>,
    }

    /// A fault or warning. Several alarms can share one `code` (603Fh): display and number together tell them apart.
    Alarm<'m> {
        /// Display and number as text: `OF 0x25`. Unique.
        key "key": required String,
        /// What the panel shows.
        display "display": required &'m str,
        /// The name in generated code, words joined by `_`; unique among alarms.
        handle "handle": required String,
        /// The printed name.
        name "name": required Known<'m, &'m str>,
        /// The maker's number.
        number "number": required Known<'m, u16>,
        /// Error code, as 603Fh and the emergency message carry it.
        code "code": required Known<'m, u16>,
        /// Auxiliary code of the emergency message.
        aux "aux": optional Known<'m, u16>,
        /// How it is cleared.
        reset "reset": optional Known<'m, Word<Reset>>,
        /// Causes.
        causes "causes": required Vec<Known<'m, &'m str>>,
        /// Remedies.
        remedies "remedies": required Vec<Known<'m, &'m str>>,
        /// States of the EtherCAT state machine in which it is detected.
        esm "esm": optional Known<'m, Vec<Word<EsmState>>>,
        /// State of the EtherCAT state machine after it.
        esm_after "esm_after": optional Known<'m, Word<EsmAfter>>,
        /// Synchronization in which it is detected.
        sync "sync": optional Known<'m, Word<SyncMode>>,
        /// AL status code that it sets.
        al_status "al_status": optional Known<'m, u16>,
        /// What the error indicator shows.
        led "led": optional Known<'m, Word<Led>>,
    }

    /// A place where the manual is wrong or contradicts itself. Values are written as in a profile.
    Erratum<'m> {
        /// Its id, which facts name.
        id "id": required &'m str,
        /// The row that it concerns.
        at "at": required &'m str,
        /// The key of that row.
        field "field": required &'m str,
        /// What is printed.
        was "was": required &'m str,
        /// Where it is printed.
        seen "seen": required String,
        /// The value used instead; left out, the printed one is kept or dropped.
        set "set": optional &'m str,
        /// `true`: the printed value is dropped, and nothing takes its place.
        unset "unset": optional bool,
        /// Where the other reading is printed.
        by "by": optional String,
        /// Why.
        why "why": required &'m str,
        /// How sure.
        sure "sure": required Word<Sure>,
    }
}
