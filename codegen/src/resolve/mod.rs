//! Turns merged rows into a model: every reference found, every name unique, every value with its origin.

mod alarms;
mod behaviour;
mod contradiction;
mod drive;
mod ethercat;
mod homing;
mod names;
mod objects;
mod origin;
mod process_data;
mod stated;
mod tables;

use crate::diag::Sink;
use crate::merge::Profile;
use crate::model::{EtherCat, Model};

/// Resolves `profile`. `None` only when there is no drive row to make a model of; everything else that cannot be
/// resolved is reported and left out, so that later findings are still found.
pub fn resolve(profile: &Profile, sink: &mut Sink) -> Option<Model> {
    let drive = drive::drive(profile.rows.drive.first()?, &profile.rows.errata);
    let tables = tables::Tables::new(profile, sink);
    let resolved = objects::resolve(profile, tables, sink);
    let mut model = Model {
        drive,
        manuals: drive::manuals(profile, sink),
        objects: resolved.objects,
        entries: resolved.entries,
        enums: resolved.enums,
        bits: resolved.bits,
        pdos: Vec::new(),
        alarms: alarms::alarms(profile, sink),
        homing: homing::methods(profile, sink),
        modes: Vec::new(),
        states: Vec::new(),
        commands: Vec::new(),
        aborts: Vec::new(),
        terminals: Vec::new(),
        ethercat: EtherCat::default(),
        sync_managers: Vec::new(),
        fmmus: Vec::new(),
        coe: Vec::new(),
        dc_modes: Vec::new(),
        startup: Vec::new(),
        emcy: Vec::new(),
        rules: Vec::new(),
        examples: Vec::new(),
        errata: drive::errata(profile),
    };
    model.pdos = process_data::pdos(profile, &model, sink);
    behaviour::fill(&mut model, profile, sink);
    names::check_unique(&model, sink);
    Some(model)
}
