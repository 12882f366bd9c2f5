//! The model as the structs of [`super::shape`].

use super::behaviour;
use super::ethercat;
use super::known::{known, maybe};
use super::shape::{
    Alarm, BitField, Bits, Document, Drive, Entry, Enum, EnumValue, Erratum, Identity, Manual, Object, Pdo,
    PdoEntry, Unit,
};
use super::value::{Integer, Known, Word};
use crate::facts::by_name;
use crate::model::{self, Address, Fact, Model, Value};
use crate::name::{Case, Name};

const ABOUT: &str = "Facts of the drive for other programs. Written by drivewright with `cargo xtask regen`: edit the profile, not this file.";

/// The whole file.
pub(super) fn document(model: &Model) -> Document<'_> {
    Document {
        format: super::FORMAT,
        about: ABOUT,
        drive: drive(model),
        identity: identity(model),
        manuals: model.manuals.iter().map(manual).collect(),
        objects: model.objects.as_slice().iter().map(|o| object(model, o)).collect(),
        enums: by_name(model.enums.as_slice(), |e| &e.name).map(|e| enumeration(model, e)).collect(),
        bits: by_name(model.bits.as_slice(), |b| &b.name).map(|b| bits(model, b)).collect(),
        pdos: model.pdos.iter().map(|p| pdo(model, p)).collect(),
        alarms: model.alarms.iter().map(|a| alarm(model, a)).collect(),
        homing: model.homing.iter().map(|m| behaviour::homing(model, m)).collect(),
        modes: model.modes.iter().map(|m| behaviour::mode(model, m)).collect(),
        states: model.states.iter().map(|s| behaviour::state(model, s)).collect(),
        commands: model.commands.iter().map(|c| behaviour::command(model, c)).collect(),
        aborts: model.aborts.iter().map(|a| behaviour::abort(model, a)).collect(),
        terminals: model.terminals.iter().map(|t| behaviour::terminal(model, t)).collect(),
        ethercat: ethercat::ethercat(model),
        sync_managers: model.sync_managers.iter().map(|s| ethercat::sync_manager(model, s)).collect(),
        fmmus: model.fmmus.iter().map(|f| ethercat::fmmu(model, f)).collect(),
        coe: model.coe.iter().map(|c| ethercat::coe(model, c)).collect(),
        dc_modes: model.dc_modes.iter().map(|d| ethercat::dc_mode(model, d)).collect(),
        startup: model.startup.iter().map(|s| ethercat::startup(model, s)).collect(),
        emcy: model.emcy.iter().map(|e| behaviour::emcy(model, e)).collect(),
        rules: model.rules.iter().map(|r| behaviour::rule(model, r)).collect(),
        examples: model.examples.iter().map(|e| behaviour::example(model, e)).collect(),
        errata: model.errata.as_slice().iter().map(erratum).collect(),
    }
}

fn handle(name: &Name) -> String {
    name.to_case(Case::Snake)
}

fn drive(model: &Model) -> Drive<'_> {
    let drive = &model.drive;
    Drive {
        id: &drive.id,
        package: &drive.package,
        vendor: &drive.vendor,
        name: &drive.name,
        crate_version: &drive.crate_version,
        eds_version: drive.eds_version,
        eds_revision: drive.eds_revision,
        date: &drive.date,
        bases: drive.bases.iter().map(String::as_str).collect(),
        pdo_entries: maybe(model, drive.limits.pdo_entries.as_ref(), |n| *n),
        pdo_bytes: maybe(model, drive.limits.pdo_bytes.as_ref(), |n| *n),
        pdos_per_direction: maybe(model, drive.limits.pdos_per_direction.as_ref(), |n| *n),
        note: drive.note.as_deref(),
    }
}

fn identity(model: &Model) -> Identity {
    let default = |index, sub| model.default_int(Address::new(index, sub)).map(Integer);
    Identity {
        device_type: default(0x1000, 0),
        vendor_id: default(0x1018, 1),
        product_code: default(0x1018, 2),
        revision: default(0x1018, 3),
    }
}

fn manual(manual: &model::Manual) -> Manual<'_> {
    Manual {
        id: &manual.id,
        title: &manual.title,
        version: &manual.version,
        date: manual.date.as_deref(),
        sha256: &manual.sha256,
        lines: manual.lines,
    }
}

fn object<'m>(model: &'m Model, object: &'m model::Object) -> Object<'m> {
    Object {
        at: format!("{:04X}", object.index),
        index: object.index,
        name: known(model, object.name.value.original(), &object.name.origin),
        kind: known(model, Word(object.kind.value), &object.kind.origin),
        text: object.text.as_deref(),
        note: object.note.as_deref(),
        deviation: object.deviation.as_deref(),
        also: object.also.as_ref().map(ToString::to_string),
        entries: object.entries.iter().map(|id| entry(model, &model.entries[*id])).collect(),
    }
}

fn entry<'m>(model: &'m Model, entry: &'m model::Entry) -> Entry<'m> {
    let (default, default_text) = default(model, entry);
    Entry {
        at: entry.address.to_string(),
        index: entry.address.index,
        sub: entry.address.sub,
        handle: handle(&entry.handle),
        name: known(model, &entry.name.value, &entry.name.origin),
        ty: known(model, Word(entry.ty.value), &entry.ty.origin),
        width: entry.ty.value.bits(),
        access: known(model, Word(entry.access.value), &entry.access.origin),
        pdo: maybe(model, entry.mapping.as_ref(), |m| Word(*m)),
        unit: maybe(model, entry.unit.as_ref(), unit),
        min: maybe(model, entry.min.as_ref(), |n| Integer(*n)),
        max: maybe(model, entry.max.as_ref(), |n| Integer(*n)),
        allow: maybe(model, entry.allow.as_ref(), |list| list.iter().copied().map(Integer).collect()),
        default,
        default_text,
        values: maybe(model, entry.values.as_ref(), |id| model.enums[*id].name.original()),
        bits: maybe(model, entry.bits.as_ref(), |id| model.bits[*id].name.original()),
        text: entry.text.as_deref(),
        note: entry.note.as_deref(),
        deviation: entry.deviation.as_deref(),
        parameter: maybe(model, entry.parameter.as_ref(), String::as_str),
        effect: maybe(model, entry.effect.as_ref(), |e| Word(*e)),
        also: entry.also.as_ref().map(ToString::to_string),
    }
}

/// The default as a number or as a text.
fn default<'m>(
    model: &'m Model,
    entry: &'m model::Entry,
) -> (Option<Known<'m, Integer>>, Option<Known<'m, &'m str>>) {
    match entry.default.as_ref() {
        None => (None, None),
        Some(Fact { value: Value::Int(n), origin }) => (Some(known(model, Integer(*n), origin)), None),
        Some(Fact { value: Value::Text(t), origin }) => (None, Some(known(model, t, origin))),
    }
}

fn unit(unit: &model::Unit) -> Unit<'_> {
    Unit {
        text: &unit.text,
        quantity: Word(unit.quantity),
        base: unit.quantity.base(),
        num: unit.num,
        den: unit.den,
    }
}

fn enumeration<'m>(model: &'m Model, table: &'m model::EnumDef) -> Enum<'m> {
    let value = |v: &'m model::EnumValue| EnumValue {
        value: Integer(v.value),
        handle: handle(&v.name.value),
        name: known(model, &v.printed, &v.name.origin),
        text: v.text.as_deref(),
    };
    Enum { name: table.name.original(), values: table.values.iter().map(value).collect() }
}

fn bits<'m>(model: &'m Model, table: &'m model::BitsDef) -> Bits<'m> {
    let field = |f: &'m model::BitField| BitField {
        bit: f.bit,
        width: f.width,
        mode: f.mode,
        handle: handle(&f.name.value),
        name: known(model, &f.printed, &f.name.origin),
        text: f.text.as_deref(),
        deviation: f.deviation.as_deref(),
    };
    Bits { name: table.name.original(), fields: table.fields.iter().map(field).collect() }
}

fn pdo<'m>(model: &'m Model, pdo: &'m model::Pdo) -> Pdo<'m> {
    let mut offset = 0;
    let mut entries = Vec::with_capacity(pdo.entries.len());
    for mapped in &pdo.entries {
        entries.push(pdo_entry(model, mapped, offset));
        offset += u32::from(mapped.bits.value);
    }
    Pdo {
        at: format!("{:04X}", pdo.index),
        index: pdo.index,
        direction: known(model, Word(pdo.direction), &pdo.origin),
        bits: offset,
        bytes: offset.div_ceil(8),
        entries,
    }
}

fn pdo_entry<'m>(model: &'m Model, mapped: &'m model::PdoEntry, offset: u32) -> PdoEntry<'m> {
    let address = model.entries[mapped.entry].address;
    PdoEntry {
        position: mapped.position,
        index: address.index,
        sub: address.sub,
        entry: known(model, address.to_string(), &mapped.origin),
        byte: offset / 8,
        bit: offset % 8,
        bits: known(model, mapped.bits.value, &mapped.bits.origin),
    }
}

fn alarm<'m>(model: &'m Model, alarm: &'m model::Alarm) -> Alarm<'m> {
    let texts = |list: &'m [Fact<String>]| -> Vec<Known<'m, &'m str>> {
        list.iter().map(|t| known(model, t.value.as_str(), &t.origin)).collect()
    };
    Alarm {
        key: format!("{} 0x{:02X}", alarm.display, alarm.number.value),
        display: &alarm.display,
        handle: handle(&alarm.name.value),
        name: known(model, &alarm.printed, &alarm.name.origin),
        number: known(model, alarm.number.value, &alarm.number.origin),
        code: known(model, alarm.code.value, &alarm.code.origin),
        aux: maybe(model, alarm.aux.as_ref(), |n| *n),
        reset: maybe(model, alarm.reset.as_ref(), |r| Word(*r)),
        causes: texts(&alarm.causes),
        remedies: texts(&alarm.remedies),
        esm: maybe(model, alarm.detection.esm.as_ref(), |s| s.iter().copied().map(Word).collect()),
        esm_after: maybe(model, alarm.detection.esm_after.as_ref(), |s| Word(*s)),
        sync: maybe(model, alarm.detection.sync.as_ref(), |s| Word(*s)),
        al_status: maybe(model, alarm.detection.al_status.as_ref(), |n| *n),
        led: maybe(model, alarm.detection.led.as_ref(), |l| Word(*l)),
    }
}

fn erratum(erratum: &model::Erratum) -> Erratum<'_> {
    Erratum {
        id: &erratum.id,
        at: &erratum.at,
        field: &erratum.field,
        was: &erratum.was,
        seen: erratum.seen.to_string(),
        set: erratum.set.as_deref(),
        unset: erratum.unset.then_some(true),
        by: erratum.by.as_ref().map(ToString::to_string),
        why: &erratum.why,
        sure: Word(erratum.sure),
    }
}
