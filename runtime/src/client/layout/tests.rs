//! Layouts on a drive that is a map of entries.

use super::*;
use crate::client::object::Cause;
use crate::client::testing::{at, Dictionary, Nonsense};
use crate::pdo::{LayoutMismatch, MapEntry};
use crate::prelude::*;
use crate::rule::{Occasion, Op, RuleDesc, Term};
use crate::transport::Refusal;
use crate::AbortCode;
use std::string::ToString;
use std::vec::Vec;

const fn entry(index: u16, sub: u8, ty: DataType, mapping: Mapping) -> ObjectDesc<'static> {
    ObjectDesc::new(at(index, sub), ty, Access::Rw, mapping, "")
}

static OBJECTS: [ObjectDesc<'static>; 10] = [
    entry(0x1600, 0, DataType::UNSIGNED8, Mapping::Unmapped).range(0, 3),
    entry(0x1A00, 0, DataType::UNSIGNED8, Mapping::Unmapped).range(0, 3),
    entry(0x1A01, 0, DataType::UNSIGNED8, Mapping::Unmapped),
    entry(0x1C12, 0, DataType::UNSIGNED8, Mapping::Unmapped),
    entry(0x1C13, 0, DataType::UNSIGNED8, Mapping::Unmapped),
    entry(0x6040, 0, DataType::UNSIGNED16, Mapping::Rx),
    entry(0x6041, 0, DataType::UNSIGNED16, Mapping::Tx),
    entry(0x6061, 0, DataType::INTEGER8, Mapping::Tx),
    entry(0x6064, 0, DataType::INTEGER32, Mapping::Tx),
    entry(0x6077, 0, DataType::INTEGER16, Mapping::NotStated),
];

const STATUS: MapEntry = MapEntry::new(at(0x6041, 0), 16);
const POSITION: MapEntry = MapEntry::new(at(0x6064, 0), 32);
const MODE: MapEntry = MapEntry::new(at(0x6061, 0), 8);
static SHIPPED: [MapEntry; 2] = [STATUS, POSITION];
static PDOS: [PdoDesc<'static>; 2] = [
    PdoDesc::new(at(0x1A00, 0), Direction::Tx, &SHIPPED).with_remap(Remap::Free).with_max_bytes(8),
    PdoDesc::new(at(0x1A01, 0), Direction::Tx, &SHIPPED).with_remap(Remap::Fixed),
];
static ONE: [Term; 3] = [Term::Object(at(0x1C13, 0)), Term::Number(1), Term::Apply(Op::AtMost)];
static RULES: [RuleDesc<'static>; 1] =
    [RuleDesc::new("R07", "One TxPDO can be assigned").with_on(Occasion::Remap).with_require(&ONE)];
static MODEL: DriveModel<'static> = DriveModel::new(Identity::new("x3", "Acme", "X3"))
    .with_objects(&OBJECTS)
    .with_pdos(&PDOS)
    .with_rules(&RULES);

/// A drive that sends status, position and mode in 1A00h.
fn drive() -> Dictionary {
    Dictionary::default()
        .with(at(0x1C13, 0), &[1])
        .with(at(0x1C13, 1), &[0x00, 0x1A])
        .with(at(0x1A00, 0), &[3])
        .with(at(0x1A00, 1), &STATUS.word().to_le_bytes())
        .with(at(0x1A00, 2), &POSITION.word().to_le_bytes())
        .with(at(0x1A00, 3), &MODE.word().to_le_bytes())
}

fn read(drive: &mut Dictionary, entries: &[MapEntry]) -> Result<(), LayoutError> {
    drive.run(ReadBack::new(&MODEL, Plan::new(Direction::Tx, &[Mapped::new(0x1A00, entries)])))
}

#[test]
fn the_layout_of_the_drive_is_the_wanted_one() {
    assert_eq!(read(&mut drive(), &[STATUS, POSITION, MODE]), Ok(()));
}

#[test]
fn two_bytes_off_print_both_layouts() {
    let wrong = MapEntry::new(at(0x6064, 0), 16);
    let mut drive = drive().with(at(0x1A00, 2), &wrong.word().to_le_bytes());
    let mapped = [Mapped::new(0x1A00, &[STATUS, POSITION, MODE])];
    let mut read = ReadBack::new(&MODEL, Plan::new(Direction::Tx, &mapped));
    let error = crate::procedure::run(&mut read, &mut drive, crate::procedure::Policy::default()).unwrap();
    assert_eq!(read.explain(&error.unwrap_err()).to_string(), "\
error[LAYOUT]: TxPDO 1A00h is not the wanted layout: entry 2 of the drive's layout is 6064:00 16 bit long, not 32 bit
  wanted : 6041:00 16 bit | 6064:00 32 bit | 6061:00 8 bit  (7 bytes)
  device : 6041:00 16 bit | 6064:00 16 bit | 6061:00 8 bit  (5 bytes)
  effect : every value after 6064:00 would be 16 bits off
  do     : do not exchange process data; write the layout, then read it back again; 1A00:02 should be 60640020h");
}

#[test]
fn every_difference_is_seen() {
    let mismatch = |entries: &[MapEntry]| match read(&mut drive(), entries).unwrap_err().cause {
        LayoutCause::Mapping(mismatch) => mismatch,
        other => panic!("{other:?}"),
    };
    assert!(matches!(mismatch(&[STATUS, POSITION]), LayoutMismatch::Extra { position: 3, found: MODE }));
    assert!(matches!(mismatch(&[STATUS, POSITION, MODE, MODE]), LayoutMismatch::Missing { position: 4, .. }));
    assert!(matches!(mismatch(&[STATUS, MODE, POSITION]), LayoutMismatch::Object { position: 2, .. }));
}

#[test]
fn another_assignment_is_no_layout() {
    let cause = |drive: &mut Dictionary| read(drive, &[STATUS, POSITION, MODE]).unwrap_err().cause;
    let expect = |position, expected, found| LayoutCause::Assignment { position, expected, found };
    assert_eq!(cause(&mut drive().with(at(0x1C13, 0), &[0])), expect(1, Some(0x1A00), None));
    let other = &mut drive().with(at(0x1C13, 1), &[1, 0x1A]);
    assert_eq!(cause(other), expect(1, Some(0x1A00), Some(0x1A01)));
    let two = &mut drive().with(at(0x1C13, 0), &[2]).with(at(0x1C13, 2), &[1, 0x1A]);
    assert_eq!(cause(two), expect(2, None, Some(0x1A01)));
    let short = &mut drive().with(at(0x1C13, 0), &[]);
    assert!(matches!(cause(short), LayoutCause::Access(e) if matches!(e.cause, Cause::Wire(_))));
    let text = read(&mut drive().with(at(0x1C13, 0), &[0]), &[]).unwrap_err().to_string();
    assert!(text.starts_with("error[LAYOUT]: assignment 1C13:01 is not in use, not 1A00h\n"), "{text}");
}

#[test]
fn a_count_above_all_bounds_is_not_believed() {
    let mut drive = drive().with(at(0x1A00, 0), &[255]);
    for sub in 1..=255 {
        drive.entries.insert(at(0x1A00, sub), STATUS.word().to_le_bytes().into());
    }
    let entries = [STATUS; MAX_ENTRIES];
    let error = read(&mut drive, &entries).unwrap_err();
    assert!(matches!(error.cause, LayoutCause::Mapping(LayoutMismatch::Extra { position: 65, .. })));
}

#[test]
fn a_layout_is_written_in_the_order_of_the_standard() {
    let mapped = [Mapped::new(0x1A00, &[POSITION, STATUS])];
    let plan = Plan::new(Direction::Tx, &mapped);
    let mut drive = drive();
    assert_eq!(drive.run(Write::new(&MODEL, plan).unwrap()), Ok(7));
    // The steps of example X2 of the SDV3-E, 3.4 L224 to L229.
    let expected: [(Address, Vec<u8>); 7] = [
        (at(0x1C13, 0), [0].into()),
        (at(0x1A00, 0), [0].into()),
        (at(0x1A00, 1), [0x20, 0, 0x64, 0x60].into()),
        (at(0x1A00, 2), [0x10, 0, 0x41, 0x60].into()),
        (at(0x1A00, 0), [2].into()),
        (at(0x1C13, 1), [0x00, 0x1A].into()),
        (at(0x1C13, 0), [1].into()),
    ];
    assert_eq!(drive.written, expected);
    assert_eq!(drive.run(ReadBack::new(&MODEL, plan)), Ok(()));
}

#[test]
fn a_fixed_layout_is_only_assigned() {
    let mapped = [Mapped::shipped(&PDOS[1])];
    let write = Write::new(&MODEL, Plan::new(Direction::Tx, &mapped)).unwrap();
    let addresses: Vec<Address> = write.steps().map(|(address, ..)| address).collect();
    assert_eq!(addresses, [at(0x1C13, 0), at(0x1C13, 1), at(0x1C13, 0)]);
}

#[test]
fn a_plan_that_the_drive_cannot_take_is_not_sent() {
    let cause = |direction, pdos: &[Mapped<'_>]| Plan::new(direction, pdos).check(&MODEL).unwrap_err().cause;
    let tx = |entries: &[MapEntry]| cause(Direction::Tx, &[Mapped::new(0x1A00, entries)]);
    assert_eq!(tx(&[STATUS, MODE, MODE, MODE]), PlanCause::Entries { wanted: 4, most: 3 });
    assert_eq!(tx(&[POSITION, POSITION, MODE]), PlanCause::Bytes { wanted: 9, most: 8 });
    let command = MapEntry::new(at(0x6040, 0), 16);
    let torque = MapEntry::new(at(0x6077, 0), 16);
    let nowhere = MapEntry::new(at(0x6041, 1), 16);
    for entry in [command, torque, nowhere] {
        assert_eq!(tx(&[entry]), PlanCause::NotMappable(entry));
    }
    let b35 = MapEntry::new(at(0x6064, 0), 16);
    assert_eq!(tx(&[b35]), PlanCause::Bits { entry: b35, bits: 32 });
    assert_eq!(cause(Direction::Tx, &[Mapped::new(0x1A01, &[MODE])]), PlanCause::Fixed);
    assert_eq!(cause(Direction::Tx, &[Mapped::new(0x1A02, &[])]), PlanCause::NoSuchPdo);
    assert_eq!(cause(Direction::Rx, &[Mapped::new(0x1A00, &[])]), PlanCause::NoSuchPdo);
    let both = [Mapped::shipped(&PDOS[0]), Mapped::shipped(&PDOS[1])];
    assert!(matches!(cause(Direction::Tx, &both), PlanCause::Rule { id: "R07", .. }));
    let bare = DriveModel::new(Identity::new("x3", "Acme", "X3"));
    let error = Plan::new(Direction::Tx, &both).check(&bare).unwrap_err();
    assert_eq!(error.cause, PlanCause::NoAssignment);
    assert_eq!(
        error.to_string(),
        "\
error[LAYOUT]: the layout for 1A00h was not written: the profile has no object that assigns PDOs
  do     : this drive has its PDOs by another way than 1C12h and 1C13h"
    );
}

#[test]
fn b39_nothing_is_written_but_the_layout_and_an_abort_says_how_far_it_came() {
    let mut drive = drive();
    drive.writes.insert(at(0x1A00, 2), Refusal::Abort(AbortCode::NOT_MAPPABLE));
    let mapped = [Mapped::new(0x1A00, &[POSITION, STATUS])];
    let error = drive.run(Write::new(&MODEL, Plan::new(Direction::Tx, &mapped)).unwrap()).unwrap_err();
    assert_eq!((error.step, error.steps, drive.written.len()), (4, 7, 3));
    assert_eq!(
        error.to_string(),
        "\
error[SDO 0604 0041]: write of 1A00:02 = 1614872592 refused: object cannot be mapped into the PDO
  step   : 4 of 7 of the layout
  raw    : 60410010h
  effect : no PDO is assigned in this direction now
  do     : leave the entry out of this layout"
    );
    assert!(drive.written.iter().all(|(address, _)| matches!(address.index(), 0x1C13 | 0x1A00)));
}

#[test]
fn nonsense_never_passes_for_a_layout_of_many_entries() {
    let mapped = [Mapped::new(0x1A00, &[STATUS, POSITION, MODE])];
    let plan = Plan::new(Direction::Tx, &mapped);
    for seed in 0..2_000 {
        let mut drive = Nonsense::new(seed);
        let mut read = ReadBack::new(&MODEL, plan);
        let error = drive.run(&mut read).unwrap_err();
        assert!(!read.explain(&error).to_string().is_empty() && !error.to_string().is_empty());
        if let Err(error) = drive.run(&mut Write::new(&MODEL, plan).unwrap()) {
            assert!(error.step <= error.steps && !error.to_string().is_empty());
        }
    }
}
