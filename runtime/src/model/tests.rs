//! Tests of the tables: lookups, silence, and that statics and run-time tables are of one type.

use std::string::String;
use std::vec::Vec;

use super::*;
use crate::homing::*;
use crate::prelude::*;
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
        .with_homing(&HOMING);

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
