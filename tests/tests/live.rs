//! A profile that is loaded at run time gives the tables that its generated crate has as statics: the SDV3-E here, and the
//! golden cases in `golden_compiles`.

#![allow(clippy::expect_used, reason = "a test fails by panicking")]

use std::path::Path;

use drivewright_codegen::model::{Effect, Model};
use drivewright_codegen::{compile_folder, live};
use drivewright_runtime::model::{AbortDesc, ModeDesc, StateDesc};
use drivewright_runtime::rule::{Occasion, RuleDesc};
use drivewright_runtime::{AbortCode, Address, DriveModel};
use drivewright_tests::drives;
use savch_sdv3_e as generated;

fn sdv3_e() -> Model {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../profiles/savch/sdv3-e");
    compile_folder(&folder).0.sound().cloned().expect("it is sound")
}

/// Whether the tables of a profile are those of the generated crate.
fn is_generated(profile: &Model) -> bool {
    let arena = live::Arena::default();
    let live = live::tables(profile, &arena);
    // The static has a longer life; this makes the two one type.
    let generated: &DriveModel<'_> = &generated::MODEL;
    live.model() == generated && live.alarm_texts() == generated::alarms::ALARM_TEXTS
}

/// A table and a change of it.
type Change = (&'static str, fn(&mut Model));

/// One change for each table.
const CHANGES: &[Change] = &[
    ("identity", |m| m.drive.name.push('!')),
    ("objects", |m| m.entries.as_mut_slice()[0].name.value.push('!')),
    ("units", |m| {
        m.entries.as_mut_slice().iter_mut().find_map(|e| e.unit.as_mut()).expect("a unit").value.den += 1;
    }),
    ("allowed", |m| {
        m.entries.as_mut_slice().iter_mut().find_map(|e| e.allow.as_mut()).expect("a list").value[0] -= 1;
    }),
    ("enums", |m| m.enums.as_mut_slice()[0].values[0].printed.push('!')),
    ("bit_fields", |m| m.bits.as_mut_slice()[0].fields[0].printed.push('!')),
    ("pdos", |m| m.pdos.iter_mut().find_map(|p| p.entries.first_mut()).expect("an entry").bits.value += 1),
    ("alarms", |m| m.alarms[0].number.value += 1),
    ("alarm_texts", |m| {
        m.alarms.iter_mut().find_map(|a| a.causes.first_mut()).expect("a cause").value.push('!');
    }),
    ("homing", |m| {
        m.homing.iter_mut().find_map(|h| h.cases.first_mut()).expect("a case").moves.value.0.clear();
    }),
    ("effects", |m| {
        m.entries.as_mut_slice().iter_mut().find_map(|e| e.effect.as_mut()).expect("one").value =
            Effect::AtStop;
    }),
    ("modes", |m| m.modes[0].number = 0),
    ("states", |m| m.states[0].mask.value ^= 1),
    ("commands", |m| m.commands[0].transitions.as_mut().expect("some").value.clear()),
    ("aborts", |m| m.aborts[0].code.value ^= 1),
    ("emcy", |m| m.emcy[0].byte += 1),
    ("terminals", |m| m.terminals[0].name.push('!')),
    ("rules", |m| m.rules[0].require = None),
];

#[test]
fn a_folder_gives_the_tables_of_its_crate() {
    let profile = sdv3_e();
    assert!(is_generated(&profile));
    for (table, change) in CHANGES {
        let mut changed = profile.clone();
        change(&mut changed);
        assert!(!is_generated(&changed), "{table}: a change goes unnoticed");
    }
}

#[test]
fn the_tables_of_every_drive_fit_together() {
    for folder in drives::all() {
        let (compiled, _) = compile_folder(&folder);
        let arena = live::Arena::default();
        let live = live::tables(compiled.sound().expect("it is sound"), &arena);
        assert_eq!(live.model().check(), Ok(()), "{}", folder.display());
    }
}

#[test]
fn what_the_manual_says_is_in_the_model() {
    let model = &generated::MODEL;
    assert_eq!(model.effect_of(Address::new(0x3000, 1)), Some(Effect::PowerCycle));
    assert_eq!(model.effect_of(Address::new(0x6081, 0)), None);
    assert_eq!(model.mode(8).map(ModeDesc::name), Some("Cycle synchronized position mode"));
    assert_eq!(model.abort(AbortCode(0x0609_0011)).map(AbortDesc::name), Some("No such sub-index"));
    let shown: Vec<&str> = model.states().iter().filter(|s| s.matches(0x0637)).map(StateDesc::name).collect();
    assert_eq!(shown, ["Operation enabled"]);
    let input = model.terminals().iter().find(|t| t.name() == "EI3").expect("EI3");
    assert_eq!(input.function(), Some(Address::new(0x3002, 3)), "P3.03");
}

#[test]
fn rules_are_evaluated_as_the_manual_has_them() {
    let broken = |on, values: &[(u16, u8, i128)]| -> Vec<&str> {
        let value = |at: Address| {
            values.iter().find(|(index, sub, _)| at == Address::new(*index, *sub)).map(|(.., value)| *value)
        };
        generated::MODEL.rules_on(on).filter(|rule| rule.broken(value)).map(RuleDesc::id).collect()
    };
    // 4.4 L552: a method is set and the drive is enabled before homing starts.
    assert_eq!(broken(Some(Occasion::StartHoming), &[(0x6098, 0, 0), (0x6041, 0, 0x0650)]), ["R17", "R19"]);
    assert_eq!(broken(Some(Occasion::StartHoming), &[(0x6098, 0, 1), (0x6041, 0, 0x0637)]), [""; 0]);
    // 4.4 L575: method 15 is reserved.
    assert_eq!(broken(None, &[(0x6098, 0, 15)]), ["R18"]);
    // 3.5.1 L253: steps of 62500 ns.
    assert_eq!(broken(None, &[(0x1C33, 3, 125_000)]), [""; 0]);
    assert_eq!(broken(None, &[(0x1C33, 3, 125_001)]), ["R01"]);
}

#[test]
fn messages_say_where_a_fact_comes_from() {
    let profile = sdv3_e();
    let arena = live::Arena::default();
    let live = live::tables(&profile, &arena);
    let model = live.model();
    let [first, ..] = model.rules() else { return assert!(!model.rules().is_empty()) };
    assert_eq!(live.rule_source(first).as_deref(), Some("3.5.1 L253, 6.1 T6-1 L1191"));
    let source = live.object_source(Address::new(0x6081, 0)).expect("a source");
    assert!(source.contains("T6-2"), "{source}");
    assert_eq!(live.object_source(Address::new(0x5FFF, 0)), None);
    for alarm in model.alarms() {
        assert!(live.alarm_source(alarm).is_some(), "{}", alarm.display());
    }
}
