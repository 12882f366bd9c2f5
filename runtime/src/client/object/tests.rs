//! Every way in which a read or a write ends, and how it prints.

use super::*;
use crate::client::message::Report;
use crate::client::testing::{at, Dictionary, Nonsense};
use crate::prelude::*;
use crate::procedure::{Answer, Ask, Procedure};
use crate::time::Instant;
use crate::transport::Refusal;
use crate::AbortCode;
use std::string::ToString;

const SPEED: Object<u32, Rw, RxTx, Velocity> = Object::new(0x6081, 0).range(0, 60_000).scale(1, 10);
const NAME: Object<VisibleString, Rw, Unmapped, Raw> = Object::new(0x1008, 0);
const OPTION: Object<i16, Rw, RxTx, Raw> = Object::new(0x605A, 0).allow(&[0, 1, 5]);

static UNITS: [UnitDesc<'static>; 2] = [
    UnitDesc::new("0.1 rpm", QuantityKind::Velocity, 1, 10),
    UnitDesc::new("user position", QuantityKind::UserPosition, 1, 1),
];
static MODES: [EnumValue<'static>; 1] = [EnumValue::new(3, "profile velocity")];
static ENUMS: [EnumDesc<'static>; 1] = [EnumDesc::new("mode of operation", &MODES)];
static STATUS: [BitDesc<'static>; 3] = [
    BitDesc::new(0, 1, "ready to switch on"),
    BitDesc::new(4, 2, "supply"),
    BitDesc::new(12, 1, "set-point acknowledge").in_mode(1),
];
static BITS: [BitFieldDesc<'static>; 1] = [BitFieldDesc::new("statusword", &STATUS)];
static OPTIONS: [i64; 3] = [0, 1, 5];
static ALLOWED: [Allowed<'static>; 1] = [Allowed::new(at(0x605A, 0), &OPTIONS)];
static ABORTS: [AbortDesc<'static>; 1] = [AbortDesc::new(AbortCode::DEVICE_STATE, "The servo is on")];
static OBJECTS: [ObjectDesc<'static>; 8] = [
    ObjectDesc::new(at(0x1008, 0), DataType::VISIBLE_STRING, Access::Rw, Mapping::Unmapped, "Device name"),
    ObjectDesc::new(at(0x2000, 0), DataType::REAL32, Access::Rw, Mapping::Unmapped, "Gain"),
    ObjectDesc::new(at(0x2001, 0), DataType::UNSIGNED8, Access::Wo, Mapping::Unmapped, "Key"),
    ObjectDesc::new(at(0x6041, 0), DataType::UNSIGNED16, Access::Ro, Mapping::Tx, "Statusword").bits(0),
    ObjectDesc::new(at(0x605A, 0), DataType::INTEGER16, Access::Rw, Mapping::RxTx, "Quick stop option code"),
    ObjectDesc::new(at(0x6060, 0), DataType::INTEGER8, Access::Rw, Mapping::RxTx, "Mode").values(0),
    ObjectDesc::new(at(0x607A, 0), DataType::INTEGER32, Access::Rw, Mapping::RxTx, "Target position").unit(1),
    ObjectDesc::new(at(0x6081, 0), DataType::UNSIGNED32, Access::Rw, Mapping::RxTx, "Profile velocity")
        .range(0, 60_000)
        .unit(0),
];
static MODEL: DriveModel<'static> = DriveModel::new(Identity::new("acme-x3", "Acme", "X3"))
    .with_objects(&OBJECTS)
    .with_units(&UNITS)
    .with_enums(&ENUMS)
    .with_bit_fields(&BITS)
    .with_allowed(&ALLOWED)
    .with_aborts(&ABORTS);

fn drive() -> Dictionary {
    Dictionary::default()
        .with(at(0x6081, 0), &30_000_u32.to_le_bytes())
        .with(at(0x1008, 0), b"X3\0\0")
        .with(at(0x6041, 0), &[0x31, 0x12])
        .with(at(0x2000, 0), &1.5_f32.to_le_bytes())
}

#[test]
fn what_is_written_is_read() {
    let mut drive = drive();
    assert_eq!(drive.run(Write::new(SPEED, 1_200).unwrap()), Ok(()));
    assert_eq!(drive.run(Read::new(SPEED)), Ok(1_200));
    assert_eq!(drive.run(WriteBytes::text(NAME, "axis")), Ok(()));
    let mut room = [0; 8];
    assert_eq!(drive.run(ReadBytes::new(NAME, &mut room)), Ok(4));
    assert_eq!(&room[..4], b"axis");
}

#[test]
fn what_the_drive_would_refuse_is_not_sent() {
    let cause = |index, content| WriteContent::new(&MODEL, at(index, 0), content).unwrap_err().cause;
    assert!(matches!(Write::new(SPEED, 60_001).unwrap_err().cause, Cause::Range(e) if e.max == 60_000));
    assert!(matches!(Write::new(OPTION, 2).unwrap_err().cause, Cause::Range(_)));
    assert!(matches!(cause(0x6081, Content::Int(60_001)), Cause::Range(e) if (e.min, e.max) == (0, 60_000)));
    assert!(matches!(cause(0x605A, Content::Int(40_000)), Cause::Range(e) if e.max == 32_767));
    assert_eq!(cause(0x605A, Content::Int(2)), Cause::NotListed);
    assert_eq!(cause(0x6041, Content::Int(2)), Cause::Access(Access::Ro));
    assert_eq!(
        cause(0x2000, Content::Int(2)),
        Cause::Wire(WireError::NotInteger { data_type: DataType::REAL32 })
    );
    assert_eq!(
        cause(0x2000, Content::Bytes(b"abc")),
        Cause::Wire(WireError::Length { expected: 4, found: 3 })
    );
    assert_eq!(
        cause(0x6081, Content::Bytes(b"abc")),
        Cause::Wire(WireError::Length { expected: 4, found: 3 })
    );
    assert!([Cause::NotListed, Cause::Access(Access::Ro)].into_iter().all(Cause::before_sending));
}

#[test]
fn b36_an_address_that_the_profile_lacks_is_refused_before_the_bus() {
    let error = WriteContent::new(&MODEL, at(0x60FE, 0), Content::Int(1)).unwrap_err();
    assert_eq!(error.cause, Cause::NotInProfile);
    assert_eq!(ReadContent::new(&MODEL, at(0x607A, 1), &mut []).unwrap_err().cause, Cause::NotInProfile);
    assert_eq!(
        ReadContent::new(&MODEL, at(0x2001, 0), &mut []).unwrap_err().cause,
        Cause::Access(Access::Wo)
    );
}

#[test]
fn b34_a_write_goes_to_the_sub_index_that_was_named() {
    const MIN: Object<i32, Rw, RxTx, UserPosition> = Object::new(0x607D, 1);
    const MAX: Object<i32, Rw, RxTx, UserPosition> = Object::new(0x607D, 2);
    let mut drive = drive().with(at(0x607D, 1), &[0; 4]).with(at(0x607D, 2), &[0; 4]);
    drive.run(Write::new(MAX, 5).unwrap()).unwrap();
    assert_eq!((drive.run(Read::new(MIN)), drive.run(Read::new(MAX))), (Ok(0), Ok(5)));
}

#[test]
fn b40_a_write_to_what_the_rx_pdo_carries_is_an_error() {
    let layout = [MapEntry::new(at(0x607A, 0), 32), MapEntry::new(at(0x607D, 1), 32)];
    let error = is_free(at(0x607A, 0), &layout).unwrap_err();
    assert_eq!(
        error.with(&MODEL).to_string(),
        "\
error[MAPPED]: write of 607A:00 \"Target position\" was not sent: the entry is in the RxPDO that is in use
  why    : process data would overwrite the value in the next cycle
  do     : set it in the process data, or map a layout without it"
    );
    assert_eq!(is_free(at(0x607D, 2), &layout), Ok(()), "the sub-index counts");
    let target = WriteContent::new(&MODEL, at(0x607A, 0), Content::Int(1)).unwrap();
    assert_eq!(target.beside(&layout).map(|_| ()), Err(error));
    assert!(Write::new(SPEED, 1).unwrap().beside(&layout).is_ok());
    let mapped = [MapEntry::new(at(0x6081, 0), 32)];
    assert!(Write::new(SPEED, 1).unwrap().beside(&mapped).is_err());
    assert!(WriteBytes::text(NAME, "x").beside(&mapped).is_ok());
}

#[test]
fn answers_of_another_length_are_no_values() {
    let mut drive = drive().with(at(0x6081, 0), &[1, 2]);
    let error = drive.run(Read::new(SPEED)).unwrap_err();
    assert_eq!(error.cause, Cause::Wire(WireError::Length { expected: 4, found: 2 }));
    assert_eq!(
        error.with(&MODEL).to_string(),
        "\
error[LENGTH]: read of 6081:00 \"Profile velocity\": 2 bytes where the type takes 4
  why    : the entry of this drive has another type than the profile says
  do     : compare profile and firmware: run the comparison of device and profile"
    );
    let mut room = [0; 3];
    assert_eq!(drive.run(ReadBytes::new(NAME, &mut room)).unwrap_err().cause, Cause::TooLong);
    let content = ReadContent::new(&MODEL, at(0x1008, 0), &mut room).unwrap();
    assert_eq!(drive.run(content).unwrap_err().cause, Cause::TooLong);
}

#[test]
fn refusals_print_what_they_mean_first() {
    let mut drive = drive();
    drive.writes.insert(at(0x6081, 0), Refusal::Abort(AbortCode::DEVICE_STATE));
    drive.reads.insert(at(0x6081, 0), Refusal::Abort(AbortCode(0x0800_1234)));
    let error =
        drive.run(WriteContent::new(&MODEL, at(0x6081, 0), Content::Int(30_000)).unwrap()).unwrap_err();
    let explained = error.with(&MODEL);
    assert_eq!(Report::new(&explained).from("manual 6.1").to_string(), "\
error[SDO 0800 0022]: write of 6081:00 \"Profile velocity\" = 3000 rpm [30000] refused: data cannot be transferred \
or stored in the present device state
  drive  : The servo is on
  do     : disable the drive, or bring the bus to the state in which this can be written
  source : manual 6.1");
    let error = drive.run(Read::new(SPEED)).unwrap_err();
    assert_eq!(
        error.to_string(),
        "error[SDO 0800 1234]: read of 6081:00 refused: a code that CiA 301 does not list"
    );
    drive.reads.insert(at(0x6081, 0), Refusal::NoAnswer);
    assert_eq!(drive.run(Read::new(SPEED)).unwrap_err().cause, Cause::NoAnswer);
    drive.reads.insert(at(0x6081, 0), Refusal::TooLong);
    assert_eq!(drive.run(Read::new(SPEED)).unwrap_err().cause, Cause::TooLong);
    let error = WriteContent::new(&MODEL, at(0x605A, 0), Content::Int(2)).unwrap_err();
    assert!(error.with(&MODEL).to_string().contains("this is none of them [0, 1, 5]\n"));
}

#[test]
fn values_show_decoded_with_the_raw_number_in_brackets() {
    let shown = |index, content| {
        let object = MODEL.object(at(index, 0)).unwrap();
        Shown::new(&MODEL, object, content).to_string()
    };
    assert_eq!(shown(0x6081, Content::Int(30_000)), "3000 rpm [30000]");
    assert_eq!(shown(0x607A, Content::Int(-7)), "-7 user units");
    assert_eq!(shown(0x6060, Content::Int(3)), "profile velocity [3]");
    assert_eq!(shown(0x6060, Content::Int(-3)), "-3, which has no name");
    assert_eq!(shown(0x6041, Content::Int(0x1231)), "ready to switch on, supply 3 [1231h]");
    assert_eq!(shown(0x6041, Content::Int(0)), "[0000h]");
    assert_eq!(shown(0x1008, Content::Bytes(b"X3\x1B\0")), r#""X3\x1b""#);
    assert_eq!(shown(0x2000, Content::Bytes(&[0, 0, 0xC0, 0x3F])), "1.500000");
    assert_eq!(shown(0x2000, Content::Bytes(&[0, 0, 0xC0, 0xFF])), "[FFF8000000000000h]", "no number");
    assert_eq!(shown(0x2000, Content::Bytes(&[0, 0, 0x80, 0xFF])), "[FFF0000000000000h]", "infinite");
    assert_eq!(shown(0x2000, Content::Bytes(&[1, 2])), "[01 02]");
    assert_eq!(Shown::default(&MODEL, &OBJECTS[0]).to_string(), "not stated");
}

#[test]
fn contents_are_read_as_the_model_says() {
    let mut drive = drive();
    let mut room = [0; 16];
    let status = ReadContent::new(&MODEL, at(0x6041, 0), &mut []).unwrap();
    assert_eq!(drive.run(status), Ok(Content::Int(0x1231)));
    let name = ReadContent::new(&MODEL, at(0x1008, 0), &mut room).unwrap();
    assert_eq!(drive.run(name), Ok(Content::Bytes(b"X3\0\0")));
}

#[test]
fn nonsense_ends_in_a_typed_error() {
    for seed in 0..2_000 {
        let mut drive = Nonsense::new(seed);
        let _ = drive.run(&mut Read::new(SPEED)).map_err(|e| e.with(&MODEL).to_string());
        let _ = drive.run(&mut Write::new(SPEED, 1).unwrap()).map_err(|e| e.to_string());
        let mut room = [0; 16];
        let _ = drive.run(&mut ReadBytes::new(NAME, &mut room)).map_err(|e| e.to_string());
        for object in OBJECTS.iter().filter(|o| o.access().reads()) {
            let mut read = ReadContent::new(&MODEL, object.address(), &mut room).unwrap();
            match drive.run(&mut read) {
                Ok(content) => assert!(!Shown::new(&MODEL, object, content).to_string().contains('\u{1B}')),
                Err(error) => assert!(!error.with(&MODEL).to_string().is_empty()),
            }
        }
    }
}

#[test]
fn answers_that_do_not_belong_are_none() {
    for answer in [Answer::Written, Answer::Waited, Answer::Inputs(&[1, 2, 3, 4]), Answer::NoAnswer] {
        let Ask::Done(Err(error)) = Read::new(SPEED).next(Instant::START, answer) else {
            panic!("{answer:?}")
        };
        assert_eq!(error.cause, Cause::NoAnswer);
    }
    let mut write = Write::new(SPEED, 1).unwrap();
    let written = write.next(Instant::START, Answer::Data(&[]));
    assert!(matches!(written, Ask::Done(Err(e)) if e.cause == Cause::NoAnswer));
}
