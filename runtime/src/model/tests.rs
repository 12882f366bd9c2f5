//! Tests of the tables: lookups, silence, and that statics and run-time tables are of one type.

use std::string::String;
use std::vec::Vec;

use super::*;
use crate::homing::*;
use crate::prelude::*;
use crate::rule::{Occasion, Op, RuleDesc, Term};
use crate::wire_enum::EnumValue;

const fn at(index: u16, sub: u8) -> Address {
    Address::new(index, sub)
}

static ENTRIES: [MapEntry; 2] = [MapEntry::new(at(0x6040, 0), 16), MapEntry::new(at(0x607A, 0), 32)];
static PDOS: [PdoDesc<'static>; 1] = [PdoDesc::new(at(0x1600, 0), Direction::Rx, &ENTRIES)
    .with_max_entries(8)
    .with_max_bytes(32)
    .with_remap(Remap::Free)];
static UNITS: [UnitDesc<'static>; 1] = [UnitDesc::new("0.1 rpm", QuantityKind::Velocity, 1, 10)];
static MODES: [EnumValue<'static>; 1] = [EnumValue::new(1, "profile position")];
static ENUMS: [EnumDesc<'static>; 1] = [EnumDesc::new("mode of operation", &MODES)];
static CONTROL: [BitDesc<'static>; 1] = [BitDesc::new(0, 1, "switch on")];
static BITS: [BitFieldDesc<'static>; 1] = [BitFieldDesc::new("controlword", &CONTROL)];
static ALLOWED: [Allowed<'static>; 1] = [Allowed::new(at(0x6060, 0), &[1, 3, 6])];
static TEXTS: [TextDefault<'static>; 1] = [TextDefault::new(at(0x1008, 0), "ELD2")];
static OBJECTS: [ObjectDesc<'static>; 6] = [
    ObjectDesc::new(at(0x1008, 0), DataType::VISIBLE_STRING, Access::Const, Mapping::Unmapped, "Device name"),
    ObjectDesc::new(at(0x6040, 0), DataType::UNSIGNED16, Access::Rw, Mapping::Rx, "Controlword").bits(0),
    ObjectDesc::new(at(0x6060, 0), DataType::INTEGER8, Access::Rw, Mapping::Rx, "Modes of operation")
        .default_int(-1)
        .values(0),
    ObjectDesc::new(at(0x607D, 1), DataType::INTEGER32, Access::Rw, Mapping::RxTx, "Min position limit")
        .range(-2_000_000_000, 2_000_000_000),
    ObjectDesc::new(at(0x607D, 2), DataType::INTEGER32, Access::Rw, Mapping::NotStated, "Max position limit"),
    ObjectDesc::new(at(0x6081, 0), DataType::UNSIGNED64, Access::Wo, Mapping::Tx, "Profile velocity")
        .range(0, -1)
        .default_int(i64::MIN)
        .unit(0),
];
static ALARMS: [AlarmDesc<'static>; 3] = [
    AlarmDesc::new("OF", 0x25, 0x8611, "following error exceeded")
        .with_aux(0x8005)
        .with_reset(Reset::Resettable),
    AlarmDesc::new("OF", 0x26, 0x8611, "hybrid error exceeded"),
    AlarmDesc::new("OC", 0x04, 0x2310, "overcurrent").with_reset(Reset::NotResettable),
];
static TEXT: [AlarmText<'static>; 1] = [AlarmText::new("OF", 0x26, &["slipping coupling"], &["tighten it"])
    .with_esm(&[EsmState::SafeOp, EsmState::Op])
    .with_esm_after(EsmAfter::Kept)
    .with_sync(SyncMode::Dc)
    .with_al_status(0x002C)
    .with_led(Led::SingleFlash)];
static CASES: [HomingCase<'static>; 1] =
    [HomingCase::new(&[], &[Step::fast(Side::Negative, Event::Stall), Step::Latch])
        .with_abort(&[Level::on(Signal::Home)])
        .with_mask(&[Signal::NegativeLimit])];
static HOMING: [HomingDesc<'static>; 4] = [
    HomingDesc::new(-2).with_cases(&CASES).with_start(HomingStart::Negative).with_edge(Edge::Rising),
    HomingDesc::new(15).with_status(HomingStatus::Reserved),
    HomingDesc::new(35).with_same(37),
    HomingDesc::new(37).with_cases(&CASES),
];
static EFFECTS: [EffectDesc; 2] =
    [EffectDesc::new(at(0x6060, 0), Effect::AtStop), EffectDesc::new(at(0x607D, 2), Effect::PowerCycle)];
static MODE_TABLE: [ModeDesc<'static>; 1] = [ModeDesc::new(6, "Homing mode").with_objects(&[at(0x6098, 0)])];
static STATES: [StateDesc<'static>; 2] =
    [StateDesc::new("Switched on", 0x6F, 0x23), StateDesc::new("Fault", 0x4F, 0x08)];
static COMMANDS: [CommandDesc<'static>; 2] = [
    CommandDesc::new("Shutdown", 0x87, 0x06).with_transitions(&[2, 6, 8]),
    CommandDesc::new("Fault reset", 0x80, 0x80).on_edge(),
];
static ABORTS: [AbortDesc<'static>; 1] =
    [AbortDesc::new(AbortCode::READ_ONLY, "Write to a read-only object")];
static EMCY: [EmcyDesc; 1] = [EmcyDesc::new(4, 2, EmcyContent::AuxiliaryCode)];
static TERMINALS: [TerminalDesc<'static>; 1] = [TerminalDesc::new("EI1", TerminalKind::Input)
    .with_object(at(0x60FD, 0))
    .with_bit(2)
    .with_function(at(0x3002, 1))];
static RULES: [RuleDesc<'static>; 3] = [
    RuleDesc::new("R1", "always").with_require(&[
        Term::Object(at(0x6060, 0)),
        Term::Number(0),
        Term::Apply(Op::More),
    ]),
    RuleDesc::new("R2", "a mode is set").with_on(Occasion::Enable),
    RuleDesc::new("R3", "in words only"),
];
static MODEL: DriveModel<'static> =
    DriveModel::new(Identity::new("acme-x3", "Acme", "X3").with_vendor_id(0x4321))
        .with_objects(&OBJECTS)
        .with_units(&UNITS)
        .with_enums(&ENUMS)
        .with_bit_fields(&BITS)
        .with_allowed(&ALLOWED)
        .with_texts(&TEXTS)
        .with_pdos(&PDOS)
        .with_alarms(&ALARMS)
        .with_homing(&HOMING)
        .with_effects(&EFFECTS)
        .with_modes(&MODE_TABLE)
        .with_states(&STATES)
        .with_commands(&COMMANDS)
        .with_aborts(&ABORTS)
        .with_emcy(&EMCY)
        .with_terminals(&TERMINALS)
        .with_rules(&RULES);

fn object(index: u16, sub: u8) -> &'static ObjectDesc<'static> {
    MODEL.object(at(index, sub)).unwrap()
}

#[test]
fn entries_are_found_by_address() {
    for row in MODEL.objects() {
        assert_eq!(MODEL.object(row.address()), Some(row));
    }
    for absent in [at(0, 0), at(0x1008, 1), at(0x607D, 0), at(0x607D, 3), at(0xFFFF, 0xFF)] {
        assert_eq!(MODEL.object(absent), None);
    }
    assert_eq!(MODEL.entries_of(at(0x607D, 0)).len(), 2);
    assert_eq!(MODEL.entries_of(at(0x607E, 0)), []);
}

#[test]
fn the_tables_fit_together() {
    let without_pdos = MODEL.with_pdos(&[]);
    assert_eq!(without_pdos.check(), Ok(()));
    let (pdo, entry) = (at(0x1600, 0), at(0x607A, 0));
    assert_eq!(MODEL.check(), Err(ModelError::NotInDictionary { pdo, entry }));
}

#[test]
fn rows_keep_what_they_were_given() {
    let limit = object(0x607D, 1);
    assert_eq!((limit.min(), limit.max()), (Some(-2_000_000_000), Some(2_000_000_000)));
    assert_eq!((limit.access(), limit.mapping()), (Access::Rw, Mapping::RxTx));
    assert_eq!((object(0x607D, 2).min(), object(0x607D, 2).max()), (None, None));
    let everything = [Access::Ro, Access::Rw, Access::Wo, Access::Const].into_iter().flat_map(|a| {
        [Mapping::NotStated, Mapping::Unmapped, Mapping::Rx, Mapping::Tx, Mapping::RxTx].map(|m| (a, m))
    });
    for (access, mapping) in everything {
        let row =
            ObjectDesc::new(at(1, 2), DataType::INTEGER8, access, mapping, "x").values(7).default_int(3);
        assert_eq!((row.access(), row.mapping(), row.meaning()), (access, mapping, Meaning::Enum(7)));
        assert_eq!(row.bits(8).meaning(), Meaning::Bits(8));
        assert_eq!(row.values(9).bits(1).values(2).meaning(), Meaning::Enum(2));
    }
}

#[test]
fn limits_include_the_type() {
    let mode = object(0x6060, 0);
    assert!(mode.accepts(-128) && mode.accepts(127));
    assert!(!mode.accepts(-129) && !mode.accepts(128));
    assert!(!object(0x607D, 1).accepts(2_000_000_001));
    assert!(object(0x1008, 0).accepts(i128::MAX), "a text has no range");
}

#[test]
fn unsigned_64_keeps_its_upper_half() {
    let wide = object(0x6081, 0);
    assert_eq!((wide.min(), wide.max()), (Some(0), Some(u64::MAX.into())));
    assert_eq!(wide.default_value(), Some(1 << 63));
    assert!(wide.accepts(u64::MAX.into()));
}

#[test]
fn meanings_lead_to_their_tables() {
    assert_eq!(MODEL.enum_of(object(0x6060, 0)).unwrap().name_of(1), Some("profile position"));
    assert_eq!(MODEL.bits_of(object(0x6040, 0)).unwrap().name(), "controlword");
    assert_eq!((MODEL.enum_of(object(0x6040, 0)), MODEL.bits_of(object(0x6060, 0))), (None, None));
    assert_eq!(MODEL.unit_of(object(0x6081, 0)).unwrap().factor(), (1, 10));
    assert_eq!(MODEL.unit_of(object(0x6040, 0)), None);
    assert_eq!(MODEL.allowed_of(object(0x6060, 0)), Some(&[1, 3, 6][..]));
    assert_eq!(MODEL.allowed_of(object(0x6040, 0)), None);
}

#[test]
fn a_number_beyond_the_tables_is_no_panic() {
    let lost =
        ObjectDesc::new(at(1, 0), DataType::INTEGER8, Access::Ro, Mapping::Tx, "x").values(99).unit(200);
    assert_eq!((MODEL.enum_of(&lost), MODEL.unit_of(&lost)), (None, None));
}

#[test]
fn defaults_are_numbers_texts_or_silence() {
    assert_eq!(MODEL.default_of(object(0x6060, 0)), DefaultValue::Int(-1));
    assert_eq!(MODEL.default_of(object(0x1008, 0)), DefaultValue::Text("ELD2"));
    assert_eq!(MODEL.default_of(object(0x6040, 0)), DefaultValue::NotStated);
}

#[test]
fn alarms_share_codes() {
    assert_eq!(MODEL.alarms_by_code(0x8611).map(AlarmDesc::number).collect::<Vec<_>>(), [0x25, 0x26]);
    assert_eq!(MODEL.alarms_by_code(0).count(), 0);
    let alarm = MODEL.alarm("OF", 0x26).unwrap();
    assert_eq!((alarm.aux(), alarm.reset()), (None, Reset::NotStated));
    assert_eq!(MODEL.alarm("OF", 0x25).unwrap().aux(), Some(0x8005));
    assert_eq!(MODEL.alarm("OC", 0x25), None);
    assert_eq!(AlarmText::find(&TEXT, alarm).unwrap().remedies(), ["tighten it"]);
    assert_eq!(AlarmText::find(&TEXT, MODEL.alarm("OC", 4).unwrap()), None);
}

#[test]
fn what_ethercat_shows_stands_beside_the_text() {
    let text = TEXT[0];
    assert_eq!(text.esm().iter().map(|s| s.word()).collect::<Vec<_>>(), ["SafeOP", "OP"]);
    assert_eq!((text.esm_after(), text.sync()), (Some(EsmAfter::Kept), Some(SyncMode::Dc)));
    assert_eq!((text.al_status(), text.led()), (Some(0x2C), Some(Led::SingleFlash)));
    let silent = AlarmText::new("OF", 0x26, &[], &[]);
    assert_eq!((silent.esm(), silent.esm_after(), silent.al_status()), (&[][..], None, None));
    assert_eq!((silent.sync(), silent.led()), (None, None));
}

#[test]
fn homing_methods_are_found_by_number_and_followed() {
    assert_eq!(MODEL.homing(-2).map(HomingDesc::number), Some(-2));
    assert_eq!(MODEL.homing(35).map(HomingDesc::number), Some(37), "the same as that one");
    assert_eq!(MODEL.homing(15).map(|m| (m.status(), m.cases().len())), Some((HomingStatus::Reserved, 0)));
    assert_eq!(MODEL.homing(1), None);
    let method = MODEL.homing_methods()[0];
    assert_eq!((method.start(), method.edge()), (Some(HomingStart::Negative), Some(Edge::Rising)));
    assert_eq!((method.side(), method.reference(), method.approach()), (None, None, None));
    let case = method.cases()[0];
    assert_eq!(
        (case.abort().map(|a| a.0), case.mask()),
        (Some(&[Level::on(Signal::Home)][..]), &[Signal::NegativeLimit][..])
    );
}

#[test]
fn effects_are_stated_or_not() {
    assert_eq!(MODEL.effect_of(at(0x607D, 2)), Some(Effect::PowerCycle));
    assert_eq!(MODEL.effect_of(at(0x607D, 1)), None);
}

#[test]
fn behaviour_is_found_by_its_key() {
    let mode = MODEL.mode(6).unwrap();
    assert_eq!((mode.name(), mode.objects(), MODEL.mode(1)), ("Homing mode", &[at(0x6098, 0)][..], None));
    let named = MODEL.abort(AbortCode(0x0601_0002)).map(AbortDesc::name);
    assert_eq!((named, MODEL.abort(AbortCode::GENERAL)), (Some("Write to a read-only object"), None));
    let ids = |on| MODEL.rules_on(on).map(RuleDesc::id).collect::<Vec<_>>();
    assert_eq!((ids(None), ids(Some(Occasion::Enable))), (Vec::from(["R1", "R3"]), Vec::from(["R2"])));
    assert_eq!(ids(Some(Occasion::Remap)), [""; 0]);
}

#[test]
fn words_show_states_and_give_commands() {
    let [on, fault] = STATES;
    assert!(on.matches(0x0633) && !on.matches(0x0637) && fault.matches(0x0218));
    assert_eq!((on.name(), on.mask(), on.value()), ("Switched on", 0x6F, 0x23));
    let [shutdown, reset] = COMMANDS;
    assert!(shutdown.matches(0x0116) && !shutdown.matches(0x0007) && reset.matches(0x0080));
    assert_eq!((shutdown.edge(), shutdown.transitions()), (false, &[2, 6, 8][..]));
    assert_eq!((reset.name(), reset.mask(), reset.value(), reset.edge()), ("Fault reset", 0x80, 0x80, true));
}

#[test]
fn the_emergency_message_and_terminals_are_rows() {
    let part = MODEL.emcy()[0];
    assert_eq!((part.byte(), part.bytes(), part.holds().word()), (4, 2, "auxiliary code"));
    let input = MODEL.terminals()[0];
    assert_eq!((input.name(), input.kind(), input.bit()), ("EI1", TerminalKind::Input, Some(2)));
    assert_eq!((input.object(), input.function()), (Some(at(0x60FD, 0)), Some(at(0x3002, 1))));
    let supply = TerminalDesc::new("GND", TerminalKind::Supply);
    assert_eq!((supply.object(), supply.bit(), supply.function()), (None, None, None));
}

#[test]
fn process_data_is_found_by_its_mapping_object() {
    let pdo = MODEL.pdo(at(0x1600, 0)).unwrap();
    assert_eq!(
        (pdo.bits(), pdo.max_entries(), pdo.max_bytes(), pdo.remap()),
        (48, Some(8), Some(32), Remap::Free)
    );
    assert_eq!(crate::pdo::compare(pdo.entries(), [0x6040_0010, 0x607A_0020]), Ok(()));
    assert_eq!(MODEL.pdo(at(0x1601, 0)), None);
}

#[test]
fn tables_built_at_run_time_are_the_same_type() {
    let name = String::from("Statusword");
    let rows: Vec<ObjectDesc<'_>> =
        Vec::from([ObjectDesc::new(at(0x6041, 0), DataType::UNSIGNED16, Access::Ro, Mapping::Tx, &name)]);
    let built = DriveModel::new(Identity::new("x", "y", "z")).with_objects(&rows);
    let names =
        |model: &DriveModel<'_>| model.objects().iter().map(|o| String::from(o.name())).collect::<Vec<_>>();
    assert_eq!(names(&built), ["Statusword"]);
    assert_eq!(names(&MODEL).len(), 6);
    assert_eq!((built.identity().id(), MODEL.identity().vendor_id()), ("x", Some(0x4321)));
}
