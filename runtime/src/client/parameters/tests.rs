//! Sets on a drive that is a map of entries.

use super::*;
use crate::cia402::Statusword;
use crate::client::object::Cause;
use crate::client::testing::{at, Dictionary, Nonsense};
use crate::prelude::*;
use crate::procedure::{run, Policy};
use crate::rule::{Occasion, Op, RuleDesc, Term};
use crate::transport::Refusal;
use crate::AbortCode;
use core::time::Duration;
use std::string::{String, ToString};
use std::vec::Vec;

const fn entry(index: u16, sub: u8, ty: DataType) -> ObjectDesc<'static> {
    ObjectDesc::new(at(index, sub), ty, Access::Rw, Mapping::RxTx, "X")
}

static UNITS: [UnitDesc<'static>; 1] = [UnitDesc::new("0.1 rpm", QuantityKind::Velocity, 1, 10)];
static OBJECTS: [ObjectDesc<'static>; 17] = [
    entry(0x1010, 1, DataType::UNSIGNED32),
    entry(0x2000, 1, DataType::INTEGER16),
    entry(0x2000, 2, DataType::INTEGER16),
    entry(0x2000, 3, DataType::INTEGER16),
    entry(0x2001, 0, DataType::VISIBLE_STRING),
    ObjectDesc::new(at(0x2002, 0), DataType::UNSIGNED8, Access::Wo, Mapping::Unmapped, "Key"),
    ObjectDesc::new(at(0x6041, 0), DataType::UNSIGNED16, Access::Ro, Mapping::Tx, "Statusword"),
    ObjectDesc::new(at(0x6064, 0), DataType::INTEGER32, Access::Ro, Mapping::Tx, "Actual position"),
    entry(0x6071, 0, DataType::INTEGER16),
    entry(0x607A, 0, DataType::INTEGER32),
    entry(0x607D, 1, DataType::INTEGER32),
    entry(0x607D, 2, DataType::INTEGER32),
    entry(0x607F, 0, DataType::UNSIGNED32).range(0, 60_000).unit(0),
    entry(0x6081, 0, DataType::UNSIGNED32).range(0, 60_000).unit(0).default_int(1_000),
    entry(0x6083, 0, DataType::UNSIGNED32),
    entry(0x6091, 1, DataType::UNSIGNED32),
    entry(0x60FF, 0, DataType::INTEGER32),
];
const fn object(sub: u8) -> Term {
    Term::Object(at(0x2000, sub))
}
static LESS: [Term; 3] = [object(1), object(2), Term::Apply(Op::Less)];
static EQUAL: [Term; 3] = [object(2), object(3), Term::Apply(Op::Equal)];
static FAST: [Term; 3] = [Term::Object(at(0x6081, 0)), Term::Object(at(0x607F, 0)), Term::Apply(Op::AtMost)];
static RULES: [RuleDesc<'static>; 3] = [
    RuleDesc::new("R1", "1 is below 2").with_require(&LESS),
    RuleDesc::new("R2", "2 is 3").with_require(&EQUAL).with_on(Occasion::Dc),
    RuleDesc::new("R3", "the speed is within its limit").with_require(&FAST),
];
static EFFECTS: [EffectDesc; 3] = [
    EffectDesc::new(at(0x2000, 1), Effect::AtStop),
    EffectDesc::new(at(0x2000, 2), Effect::PowerCycle),
    EffectDesc::new(at(0x6083, 0), Effect::AtOnce),
];
static MODEL: DriveModel<'static> = DriveModel::new(Identity::new("x3", "Acme", "X3"))
    .with_objects(&OBJECTS)
    .with_units(&UNITS)
    .with_rules(&RULES)
    .with_effects(&EFFECTS);

fn drive() -> Dictionary {
    let mut drive = Dictionary::default();
    for object in &OBJECTS {
        drive.entries.insert(object.address(), std::vec![0; object.data_type().bytes()]);
    }
    drive
        .with(at(0x2000, 2), &[10, 0])
        .with(at(0x2001, 0), b"old\0")
        .with(at(0x6041, 0), &[0x40, 0])
        .with(at(0x607F, 0), &1_000_u32.to_le_bytes())
        .with(at(0x6081, 0), &1_000_u32.to_le_bytes())
        .with(at(0x1010, 1), &[1, 0, 0, 0])
}

fn number(index: u16, sub: u8, value: i128) -> Setting<'static> {
    Setting::number(at(index, sub), value)
}

/// Runs a set; gives the result, the report of an error, and the addresses that were written.
fn apply(drive: &mut Dictionary, wanted: &[Setting<'_>]) -> (Result<Applied, String>, Vec<Address>) {
    let mut slots = [Slot::EMPTY; 24];
    let mut apply = Apply::new(&MODEL, wanted, &[], &mut slots).unwrap();
    let result = run(&mut apply, drive, Policy::default()).unwrap();
    let written: Vec<Address> = drive.written.iter().map(|(address, _)| *address).collect();
    assert_eq!(apply.written().collect::<Vec<_>>(), written);
    (result.map_err(|error| apply.explain(&error).to_string()), written)
}

fn refused(wanted: &[Setting<'_>]) -> SetCause<'static> {
    Apply::new(&MODEL, wanted, &[], &mut [Slot::EMPTY; 8]).unwrap_err().cause
}

#[test]
fn only_what_differs_is_written_and_read_back() {
    let wanted = [
        number(0x6083, 0, 7),
        number(0x6081, 0, 1_000),
        Setting::text(at(0x2001, 0), "old"),
        number(0x2002, 0, 1),
    ];
    let (result, written) = apply(&mut drive(), &wanted);
    assert_eq!(result, Ok(Applied { written: 2, unchanged: 2, at_stop: 0, power_cycle: 0 }));
    assert_eq!(written, [at(0x6083, 0), at(0x2002, 0)], "write-only is written every time");
    let mut drive = drive();
    assert_eq!(apply(&mut drive, &[Setting::text(at(0x2001, 0), "new")]).0.map(|a| a.written), Ok(1));
    assert_eq!(drive.entries[&at(0x2001, 0)], b"new");
}

#[test]
fn no_rule_is_broken_on_the_way() {
    // 2000:01 < 2000:02, from (0, 10): upwards the upper one goes first, downwards the lower one.
    let up = [number(0x2000, 1, 20), number(0x2000, 2, 30)];
    assert_eq!(apply(&mut drive(), &up).1, [at(0x2000, 2), at(0x2000, 1)]);
    let down = [number(0x2000, 2, -10), number(0x2000, 1, -20)];
    assert_eq!(apply(&mut drive(), &down).1, [at(0x2000, 1), at(0x2000, 2)]);
}

#[test]
fn every_small_move_of_a_pair_has_an_order_that_keeps_the_rule() {
    for (a, b, x, y) in (0..256_i16).map(|n| (n & 3, n >> 2 & 3, n >> 4 & 3, n >> 6)).filter(|n| n.2 < n.3) {
        let mut drive = drive().with(at(0x2000, 1), &a.to_le_bytes()).with(at(0x2000, 2), &b.to_le_bytes());
        let (result, written) =
            apply(&mut drive, &[number(0x2000, 1, x.into()), number(0x2000, 2, y.into())]);
        assert!(result.is_ok(), "{a} {b} to {x} {y}: {result:?}");
        if a < b && written.len() == 2 {
            let between = if written[0] == at(0x2000, 1) { (x, b) } else { (a, y) };
            assert!(between.0 < between.1, "{a} {b} to {x} {y} over {between:?}");
        }
    }
}

#[test]
fn gear_then_limits_then_values() {
    let wanted =
        [number(0x6081, 0, 900), number(0x607F, 0, 2_000), number(0x6083, 0, 1), number(0x6091, 1, 4)];
    let expected = [at(0x6091, 1), at(0x607F, 0), at(0x6081, 0), at(0x6083, 0)];
    assert_eq!(apply(&mut drive(), &wanted).1, expected);
    // A lower limit than the speed that is set: rule R3 has the speed go first.
    let wanted = [number(0x607F, 0, 500), number(0x6081, 0, 400)];
    assert_eq!(apply(&mut drive(), &wanted).1, [at(0x6081, 0), at(0x607F, 0)]);
    // No rule of the drive says it, every drive checks it: the upper limit goes first.
    let wanted = [number(0x607D, 1, 10), number(0x607D, 2, 20)];
    assert_eq!(apply(&mut drive(), &wanted).1, [at(0x607D, 2), at(0x607D, 1)]);
}

#[test]
fn a_set_that_breaks_a_rule_is_not_written_at_all() {
    let (result, written) = apply(&mut drive(), &[number(0x6083, 0, 5), number(0x2000, 1, 10)]);
    assert_eq!(
        result.unwrap_err(),
        "\
error[SET]: 2000:01 \"X\" breaks rule R1: 1 is below 2
  effect : nothing was written
  do     : change the set so that the rule holds"
    );
    assert_eq!(written, []);
}

#[test]
fn a_set_without_an_order_is_not_written_at_all() {
    let wanted = [number(0x2000, 2, 20), number(0x2000, 3, 20)];
    let mut slots = [Slot::EMPTY; 8];
    let mut apply = Apply::new(&MODEL, &wanted, &[Occasion::Dc], &mut slots).unwrap();
    let mut drive = drive().with(at(0x2000, 3), &[10, 0]);
    let error = run(&mut apply, &mut drive, Policy::default()).unwrap().unwrap_err();
    assert_eq!((error.cause, error.written), (SetCause::Order { id: "R2" }, 0));
    assert_eq!(drive.written, []);
    assert!(self::apply(&mut drive, &wanted).0.is_ok(), "without distributed clocks the rule does not count");
}

#[test]
fn what_can_be_told_without_the_drive_is_told_before() {
    let access = |wanted: &[Setting<'_>]| match refused(wanted) {
        SetCause::Access(error) => error.cause,
        other => panic!("{other:?}"),
    };
    assert!(matches!(access(&[number(0x6081, 0, 60_001)]), Cause::Range(_)));
    assert_eq!(access(&[number(0x6041, 0, 0)]), Cause::Access(Access::Ro));
    assert_eq!(access(&[number(0x6085, 0, 0)]), Cause::NotInProfile);
    assert_eq!(refused(&[number(0x6083, 0, 0), number(0x6083, 0, 1)]), SetCause::Twice);
    assert_eq!(refused(&[number(0x1600, 0, 0)]), SetCause::Mapping);
    let none = Apply::new(&MODEL, &[number(0x2000, 1, 0)], &[], &mut [Slot::EMPTY; 1]).unwrap_err();
    assert_eq!(none.cause, SetCause::Room { needed: 2 }, "rule R1 needs 2000:02 as well");
    assert!(none
        .with(&MODEL)
        .to_string()
        .starts_with("error[SET]: 2000:02 \"X\" needs slot 2, and there are fewer\n"));
}

#[test]
fn b33_no_command_is_part_of_a_set() {
    for index in [0x607A, 0x60FF, 0x6071, 0x6040, 0x6060, 0x687A, 0x1010] {
        assert_eq!(refused(&[number(index, 0, 0)]), SetCause::Command, "{index:X}");
    }
    assert!(is_command(at(0x60FE, 1)) && !is_command(at(0x60FE, 2)));
    let error = Apply::new(&MODEL, &[number(0x607A, 0, 0)], &[], &mut []).unwrap_err();
    assert_eq!(
        error.to_string(),
        "\
error[STORE]: 607A:00 is a command and has no place in a parameter set
  effect : nothing was written
  why    : a drive that keeps it would move at its next enable
  do     : leave it out; the client sends it when it is meant"
    );
}

#[test]
fn b40_an_entry_of_the_rx_pdo_is_not_written_by_sdo() {
    let wanted = [number(0x6083, 0, 5), number(0x6081, 0, 1)];
    let mut slots = [Slot::EMPTY; 8];
    let apply = Apply::new(&MODEL, &wanted, &[], &mut slots).unwrap();
    let error = apply.beside(&[MapEntry::new(at(0x6081, 0), 32)]).unwrap_err();
    assert!(matches!(error.cause, SetCause::Access(e) if e.cause == Cause::MappedInRxPdo));
}

#[test]
fn a_refusal_says_what_was_written() {
    let mut drive = drive();
    drive.writes.insert(at(0x6083, 0), Refusal::Abort(AbortCode::DEVICE_STATE));
    let wanted = [number(0x6081, 0, 900), number(0x6083, 0, 5), number(0x2000, 1, 3)];
    let (result, written) = apply(&mut drive, &wanted);
    assert_eq!(written, [at(0x6081, 0)]);
    assert_eq!(result.unwrap_err(), "\
error[SDO 0800 0022]: write of 6083:00 \"X\" = 5 refused: data cannot be transferred or stored in the present device state
  written: 6081:00
  not    : 6083:00, 2000:01
  do     : disable the drive, or bring the bus to the state in which this can be written");
}

#[test]
fn a_value_that_is_not_kept_is_an_error() {
    let mut drive = drive();
    drive.deaf.insert(at(0x6083, 0));
    let (result, written) = apply(&mut drive, &[number(0x6083, 0, 5)]);
    assert_eq!(written, [at(0x6083, 0)]);
    assert!(result
        .unwrap_err()
        .starts_with("error[SET]: 6083:00 \"X\" was written, and the drive holds another value\n"));
}

#[test]
fn an_entry_that_cannot_be_read_ends_it_before_the_first_write() {
    let mut drive = drive();
    drive.entries.remove(&at(0x6083, 0));
    let (result, written) = apply(&mut drive, &[number(0x6081, 0, 900), number(0x6083, 0, 5)]);
    assert!(result
        .unwrap_err()
        .starts_with("error[SDO 0602 0000]: read of 6083:00 \"X\" refused: object does not exist\n"));
    assert_eq!(written, []);
}

#[test]
fn power_cycle_parameters_are_named() {
    let wanted = [number(0x2000, 1, 3), number(0x2000, 2, 30), number(0x6083, 0, 1)];
    let mut slots = [Slot::EMPTY; 8];
    let mut apply = Apply::new(&MODEL, &wanted, &[], &mut slots).unwrap();
    let applied = run(&mut apply, &mut drive(), Policy::default()).unwrap().unwrap();
    assert_eq!((applied.written, applied.at_stop, applied.power_cycle), (3, 1, 1));
    let effects: Vec<_> = apply.effects().collect();
    assert_eq!(effects, [(at(0x2000, 1), Effect::AtStop), (at(0x2000, 2), Effect::PowerCycle)]);
}

#[test]
fn three_columns() {
    let mut rows = Vec::new();
    let wanted =
        [number(0x6081, 0, 900), number(0x607F, 0, 1_000), number(0x2002, 0, 1), number(0x6000, 0, 1)];
    let mut drive = drive();
    let summary = drive.run(Columns::new(&MODEL, &wanted, |row| rows.push(row.with(&MODEL).to_string())));
    assert_eq!((summary.agree, summary.differ, summary.unknown), (1, 1, 2));
    assert_eq!(
        rows,
        [
            "* 6081:00 X: device 100 rpm [1000] | default 100 rpm [1000] | wanted 90 rpm [900]",
            "  607F:00 X: device 100 rpm [1000] | default not stated | wanted 100 rpm [1000]",
            "* 2002:00 Key: device is wo | default not stated | wanted 1",
            "* 6000:00 is not in the profile",
        ]
    );
    assert_eq!(drive.written, []);
}

fn store(drive: &mut Dictionary, neutralize: bool) -> Result<Stored, StoreError> {
    let store = Store::new(&MODEL, 1).unwrap();
    drive.run(if neutralize { store.neutralize() } else { store })
}

#[test]
fn parameters_are_stored_by_their_signature() {
    // 1010h takes the command and then reads as before.
    let mut drive = drive();
    drive.deaf.insert(at(0x1010, 1));
    assert_eq!(store(&mut drive, false), Ok(Stored { confirmed: true }));
    assert_eq!(drive.written, [(at(0x1010, 1), 0x6576_6173_u32.to_le_bytes().into())]);
}

#[test]
fn b33_no_target_is_stored_that_would_move_the_axis() {
    let target = || drive().with(at(0x607A, 0), &[5, 0, 0, 0]).with(at(0x60FF, 0), &[1, 0, 0, 0]);
    let mut drive = target();
    let error = store(&mut drive, false).unwrap_err();
    assert_eq!(
        error.to_string(),
        "\
error[STORE]: refusing 1010h: target 607A:00 is 5, not 0
  why    : if the drive keeps it, the first enable after power-up would move
  do     : store with `neutralize`, which makes the targets harmless first"
    );
    assert_eq!(drive.written, []);
    let mut drive = target().with(at(0x6064, 0), &[9, 0, 0, 0]);
    drive.deaf.insert(at(0x1010, 1));
    assert!(store(&mut drive, true).is_ok());
    let written: Vec<Address> = drive.written.iter().map(|(address, _)| *address).collect();
    assert_eq!(written, [at(0x607A, 0), at(0x60FF, 0), at(0x1010, 1)]);
    assert_eq!(
        (&drive.entries[&at(0x607A, 0)][..], &drive.entries[&at(0x60FF, 0)][..]),
        (&[9, 0, 0, 0][..], &[0; 4][..])
    );
    let mut drive = target();
    drive.deaf.insert(at(0x607A, 0));
    assert!(matches!(
        store(&mut drive, true).unwrap_err().cause,
        StoreCause::Target { value: 5, harmless: 0 }
    ));
}

#[test]
fn an_enabled_drive_does_not_store() {
    let mut drive = drive().with(at(0x6041, 0), &[0x37, 0x02]);
    let error = store(&mut drive, true).unwrap_err();
    assert_eq!(error.cause, StoreCause::Enabled { statusword: Statusword(0x0237) });
    assert!(error.to_string().contains("[6041h 0237h]"), "{error}");
    assert_eq!(drive.written, []);
}

#[test]
fn storing_ends_in_an_error_where_it_cannot_be_done() {
    assert_eq!(Store::new(&MODEL, 2).unwrap_err().cause, StoreCause::NoStore);
    let mut drive = drive().with(at(0x1010, 1), &[2, 0, 0, 0]);
    assert_eq!(store(&mut drive, false).unwrap_err().cause, StoreCause::NotOnCommand { ability: 2 });
    let mut drive = self::drive();
    drive.writes.insert(at(0x1010, 1), Refusal::Abort(AbortCode::HARDWARE));
    assert!(matches!(store(&mut drive, false).unwrap_err().cause, StoreCause::Access(_)));
    let mut drive = self::drive();
    drive.writes.insert(at(0x1010, 1), Refusal::NoAnswer);
    assert_eq!(store(&mut drive, false), Ok(Stored { confirmed: false }));
    assert_eq!(drive.now, 100_000, "asked again after a tenth of a second");
}

/// A drive that is gone once it was told to store.
struct Gone(Dictionary);

impl crate::transport::Transport for Gone {
    type Error = &'static str;

    fn upload(
        &mut self,
        at: Address,
        into: &mut [u8],
        within: Duration,
    ) -> Result<usize, Refusal<&'static str>> {
        if self.0.written.is_empty() {
            self.0.upload(at, into, within)
        } else {
            Err(Refusal::NoAnswer)
        }
    }

    fn download(&mut self, at: Address, data: &[u8], within: Duration) -> Result<(), Refusal<&'static str>> {
        self.0.download(at, data, within)
    }

    fn exchange(&mut self, _: &[u8], _: &mut [u8]) -> Result<usize, Refusal<&'static str>> {
        Err(Refusal::NoAnswer)
    }

    fn now(&mut self) -> crate::time::Instant {
        self.0.now()
    }

    fn wait(&mut self, until: crate::time::Instant) {
        self.0.wait(until);
    }
}

#[test]
fn a_drive_that_is_gone_while_it_stores_is_not_waited_for_without_end() {
    let mut store = Store::new(&MODEL, 1).unwrap().within(Duration::from_secs(1));
    let mut drive = Gone(drive());
    let error = run(&mut store, &mut drive, Policy::default()).unwrap().unwrap_err();
    assert_eq!(error.cause, StoreCause::TimedOut);
    assert_eq!(drive.0.now, 1_000_000);
}

#[test]
fn nonsense_ends_and_is_never_half_written_in_silence() {
    let wanted = [
        number(0x2000, 1, 20),
        number(0x2000, 2, 30),
        number(0x6081, 0, 1),
        Setting::text(at(0x2001, 0), "x"),
    ];
    for seed in 0..2_000 {
        let mut drive = Nonsense::new(seed);
        let mut slots = [Slot::EMPTY; 8];
        let mut apply = Apply::new(&MODEL, &wanted, &[], &mut slots).unwrap();
        match drive.run(&mut apply) {
            Ok(applied) => assert_eq!(applied.written, apply.written().count()),
            Err(error) => {
                assert_eq!(error.written, apply.written().count());
                assert!(!apply.explain(&error).to_string().is_empty() && !error.to_string().is_empty());
            }
        }
        let mut store = Store::new(&MODEL, 1).unwrap().neutralize();
        let _ = drive.run(&mut store).map_err(|error| error.to_string());
        let summary = drive.run(&mut Columns::new(&MODEL, &wanted, |row| {
            assert!(!row.with(&MODEL).to_string().contains('\u{1B}'));
        }));
        assert_eq!(summary.agree + summary.differ + summary.unknown, 4);
    }
}
