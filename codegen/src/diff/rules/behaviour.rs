//! Rules of the drive, alarms, homing, modes, states, terminals, the bus, and of what is text.

use super::{Case, Rule, VERSION, added, removed, rule};
use crate::diff::Effect::{Axis, Breaking, Documentation, New};

#[rustfmt::skip]
pub(super) const DRIVE: &[Rule] = &[
    rule("drive_added", New, "There was no such drive.", added),
    rule("drive_removed", Breaking, "The generated crate is gone.", removed),
    rule("crate_renamed", Breaking, "The generated crate has another name.", |c| c.field_is(&["id", "package"])),
    rule("pdo_limits_lowered", Breaking, "A layout that was allowed may not be any more.", |c| c.field_is(PDO_LIMITS) && lowered(c)),
    rule("pdo_limits_raised", New, "Layouts are allowed that were not.", |c| c.field_is(PDO_LIMITS)),
    rule(VERSION.name, VERSION.effect, VERSION.why, VERSION.holds),
    rule("wording", Documentation, "Texts only.", |c| c.field_is(&["vendor", "name", "bases", "note"])),
];

const PDO_LIMITS: &[&str] = &["pdo_entries", "pdo_bytes", "pdos_per_direction"];

/// A limit that nobody states is none.
fn lowered(case: &Case<'_>) -> bool {
    let (old, new) = case.numbers();
    new.is_some_and(|new| old.is_none_or(|old| new < old))
}

#[rustfmt::skip]
pub(super) const ALARMS: &[Rule] = &[
    rule("alarm_added", New, "There was no such alarm.", added),
    rule("alarm_removed", Breaking, "Programs that look it up by display, number or code do not find it.", removed),
    rule("alarm_code_changed", Breaking, "Programs that know it by the former code do not find it.", |c| c.field_is(&["code", "aux", "number", "al_status"])),
    rule("alarm_reaction_changed", Axis, "The drive reacts, or is reset, in another way.", |c| c.field_is(&["reset", "esm", "esm_after", "sync", "led"])),
    rule("alarm_renamed", Documentation, "Alarms are found by display, number and code: their names are texts.", |c| c.field_is(&["name", "handle"])),
    rule("wording", Documentation, "Causes and remedies are texts.", |c| c.field.is_some_and(|f| f.starts_with("cause ") || f.starts_with("remedy "))),
];

#[rustfmt::skip]
pub(super) const HOMING: &[Rule] = &[
    rule("homing_case_differs", Axis, "The axis searches home in another way.", |c| c.field.is_none() && c.is_part() && c.parent_stays),
    rule("homing_method_added", New, "There was no such method.", added),
    rule("homing_method_removed", Breaking, "Its constant is gone: code that names it does not compile, and the drive refuses it.", removed),
    rule("wording", Documentation, "Texts only.", |c| c.field_is(&["text", "note", "deviation"])),
    rule("homing_changed", Axis, "The axis searches home in another way.", |c| c.field_is(&["status", "same", "start", "approach", "reference", "side", "edge", "when", "moves", "abort", "mask"])),
];

#[rustfmt::skip]
pub(super) const MODES: &[Rule] = &[
    rule("mode_added", New, "There was no such mode.", added),
    rule("mode_removed", Axis, "The drive does not enter it any more.", removed),
    rule("wording", Documentation, "Texts, and the objects that the mode's section lists.", |c| c.field_is(&["name", "objects", "text"])),
];

#[rustfmt::skip]
pub(super) const STATES: &[Rule] = &[
    rule("state_machine_added", New, "There was no such state or command.", added),
    rule("state_machine_changed", Axis, "States are told, or commands given, by other bits.", |c| removed(c) || c.field_is(&["mask", "value", "edge", "transitions"])),
];

#[rustfmt::skip]
pub(super) const TERMINALS: &[Rule] = &[
    rule("terminal_added", New, "There was no such terminal.", added),
    rule("wiring_changed", Axis, "Signals are on other pins or bits.", |c| removed(c) || c.field_is(&["kind", "pin", "object", "bit", "parameter"])),
    rule("wording", Documentation, "Texts only.", |c| c.field_is(&["text", "note"])),
];

#[rustfmt::skip]
pub(super) const BUS: &[Rule] = &[
    rule("bus_told", New, "The profile did not say it before; the drive may be the same.", added),
    rule("wording", Documentation, "Texts only.", |c| c.field_is(&["text"])),
    rule("bus_changed", Breaking, "A master's configuration, or its reading of emergency messages, is of the former drive.", |_| true),
];

#[rustfmt::skip]
pub(super) const STARTUP: &[Rule] = &[
    rule("wording", Documentation, "Texts only.", |c| c.field_is(&["text"])),
    rule("startup_changed", Axis, "A master that starts from the ESI writes something else, or at another time.", |_| true),
];

#[rustfmt::skip]
pub(super) const RULES: &[Rule] = &[
    rule("wording", Documentation, "The rule in words; what is checked is the same.", |c| c.field_is(&["text"])),
    rule("demand_changed", Axis, "The drive refuses or takes what it did not.", |c| c.field.is_none() || c.field_is(&["require", "when", "on"])),
];

#[rustfmt::skip]
pub(super) const TEXTS: &[Rule] = &[
    rule("sources_and_reasons", Documentation, "Manuals, abort codes, examples and errata explain; values that they change are differences of their own.", |_| true),
];
