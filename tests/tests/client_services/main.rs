//! The services of the client on the virtual SDV3-E: what a program does with a drive over SDO before it moves.

#![allow(clippy::expect_used, clippy::unwrap_used, reason = "a test fails by panicking")]

mod noise;

use std::pin::pin;
use std::task::{Context, Poll, Waker};
use std::time::Duration;

use drivewright_runtime::client::compare::{Compare, Kind};
use drivewright_runtime::client::decode::SupportedModes;
use drivewright_runtime::client::fault::{Emergency, Fault, ReadFault};
use drivewright_runtime::client::identify::{Identify, ProfileMatch};
use drivewright_runtime::client::layout::{Mapped, Plan, ReadBack, Write as WriteLayout};
use drivewright_runtime::client::object::{Cause, Content, Read, ReadContent, Shown, Write, WriteContent};
use drivewright_runtime::client::parameters::{Apply, Columns, SetCause, Setting, Slot, Store, StoreCause};
use drivewright_runtime::model::{DriveModel, Effect, EsmState, Identity};
use drivewright_runtime::pdo::MapEntry;
use drivewright_runtime::prelude::*;
use drivewright_runtime::procedure::{Policy, Procedure, run, run_async};
use drivewright_runtime::sim::{Config, Link, VirtualDrive, cells};
use drivewright_runtime::{AbortCode, Address};
use savch_sdv3_e::alarms::ALARM_TEXTS;
use savch_sdv3_e::{MODEL, od};

const fn at(index: u16, sub: u8) -> Address {
    Address::new(index, sub)
}

/// Does something with a drive that is in OP. No process data are exchanged here, so nobody watches for them.
fn with_drive<T>(work: impl FnOnce(&mut Link<'_, '_, '_>) -> T) -> T {
    let mut memory = vec![0; cells(&MODEL)];
    let mut config = Config::default();
    config.watchdog = Duration::ZERO;
    let mut drive = VirtualDrive::new(&MODEL, &mut memory, config).unwrap();
    let mut link = Link::new(&mut drive, Duration::from_millis(1));
    link.start().unwrap();
    work(&mut link)
}

fn go<P: Procedure>(link: &mut Link<'_, '_, '_>, mut procedure: P) -> P::Output {
    run(&mut procedure, link, Policy::default()).unwrap()
}

#[test]
fn the_drive_is_the_one_of_its_profile_and_of_no_other() {
    with_drive(|link| {
        let found = go(link, Identify::new(&MODEL));
        assert_eq!(found.against(&MODEL), ProfileMatch::Exact);
        assert_eq!((found.vendor_id, found.name.to_string()), (Some(Ok(0x7E6)), "2S0.75E".to_owned()));
        let other =
            DriveModel::new(Identity::new("x", "Savch", "SDV3-E").with_vendor_id(0x7E6).with_product_code(1));
        assert!(matches!(found.against(&other), ProfileMatch::Mismatch(_)));
    });
}

#[test]
fn a_new_drive_has_no_contradiction_and_a_changed_setting_is_found() {
    with_drive(|link| {
        let mut contradictions = Vec::new();
        let summary = go(
            link,
            Compare::new(&MODEL, |finding| {
                if !matches!(finding.kind, Kind::Setting(_) | Kind::Reported(_) | Kind::Skipped) {
                    contradictions.push(finding.with(&MODEL).to_string());
                }
            }),
        )
        .unwrap();
        assert_eq!(contradictions, [""; 0]);
        let all = summary.as_stated + summary.changed + summary.skipped;
        assert_eq!(usize::try_from(all), Ok(MODEL.objects().len()));

        go(link, Write::new(od::PROFILE_VELOCITY, 30_000).unwrap()).unwrap();
        let mut settings = Vec::new();
        go(
            link,
            Compare::new(&MODEL, |finding| {
                if matches!(finding.kind, Kind::Setting(_)) {
                    settings.push(finding.with(&MODEL).to_string());
                }
            }),
        )
        .unwrap();
        assert_eq!(
            settings,
            ["note[DIFF]: 6081:00 \"Profile Velocity\" device 3000 rpm [30000], default 0 rpm [0]"]
        );
    });
}

// Handles unlike those of the profile: the drive itself has to refuse them.
const FREE: Object<u32, Rw, RxTx, Raw> = Object::new(0x6081, 0);
const LONG: Object<u64, Rw, RxTx, Raw> = Object::new(0x6081, 0);
const LOCKED: Object<u16, Rw, RxTx, Raw> = Object::new(0x6041, 0);
const NOWHERE: Object<u16, Rw, RxTx, Raw> = Object::new(0x6FFF, 0);

#[test]
fn reads_and_writes_end_as_the_manual_says() {
    with_drive(|link| {
        let modes = go(link, Read::new(od::SUPPORTED_DRIVE_MODES)).unwrap();
        let modes = SupportedModes(modes.0);
        assert_eq!(
            modes.to_string(),
            "profile position, profile velocity, profile torque, homing, interpolated position [0000006Dh]"
        );
        let cause =
            |result: Result<(), drivewright_runtime::client::object::AccessError>| result.unwrap_err().cause;
        let high = cause(go(link, Write::new(FREE, 60_001).unwrap()));
        assert!(matches!(high, Cause::Abort(AbortCode::VALUE | AbortCode::VALUE_TOO_HIGH)), "{high:?}");
        let long = cause(go(link, Write::new(LONG, 1).unwrap()));
        assert!(matches!(long, Cause::Abort(AbortCode::LENGTH | AbortCode::LENGTH_TOO_HIGH)), "{long:?}");
        assert_eq!(cause(go(link, Write::new(LOCKED, 1).unwrap())), Cause::Abort(AbortCode::READ_ONLY));
        assert_eq!(cause(go(link, Write::new(NOWHERE, 1).unwrap())), Cause::Abort(AbortCode::NO_OBJECT));
        assert!(matches!(go(link, Read::new(LONG)).unwrap_err().cause, Cause::Wire(_)));
        let name = at(0x1008, 0);
        let mut room = [0; 32];
        let content = go(link, ReadContent::new(&MODEL, name, &mut room).unwrap()).unwrap();
        assert_eq!(Shown::new(&MODEL, MODEL.object(name).unwrap(), content).to_string(), "\"2S0.75E\"");
    });
}

fn plan<'p>(direction: Direction, mapped: &'p [Mapped<'p>]) -> Plan<'p> {
    Plan::new(direction, mapped)
}

#[test]
fn the_shipped_layout_is_read_back_and_another_is_written() {
    with_drive(|link| {
        for (direction, index) in [(Direction::Rx, 0x1600), (Direction::Tx, 0x1A00)] {
            let shipped = [Mapped::shipped(MODEL.pdo(at(index, 0)).unwrap())];
            assert_eq!(go(link, ReadBack::new(&MODEL, plan(direction, &shipped))), Ok(()));
        }
        let entries = [0x6041_0010, 0x6077_0010, 0x6064_0020].map(MapEntry::from_word);
        let mapped = [Mapped::new(0x1A01, &entries)];
        let wanted = plan(Direction::Tx, &mapped);
        let mut read = ReadBack::new(&MODEL, wanted);
        let error = run(&mut read, link, Policy::default()).unwrap().unwrap_err();
        assert!(
            read.explain(&error)
                .to_string()
                .starts_with("error[LAYOUT]: assignment 1C13:01 is 1A00h, not 1A01h\n")
        );

        let refused = go(link, WriteLayout::new(&MODEL, wanted).unwrap()).unwrap_err();
        assert_eq!((refused.step, refused.error.address), (1, at(0x1C13, 0)), "not in OP: {refused}");

        link.drive().request(EsmState::PreOp).unwrap();
        assert_eq!(go(link, WriteLayout::new(&MODEL, wanted).unwrap()), Ok(8));
        assert_eq!(go(link, ReadBack::new(&MODEL, wanted)), Ok(()));
        link.drive().request(EsmState::SafeOp).unwrap();
        assert_eq!(link.drive().process_data_bytes().1, 8);
    });
}

#[test]
fn a_set_is_compared_written_and_names_what_needs_a_power_cycle() {
    with_drive(|link| {
        let power_cycle =
            MODEL.effects().iter().find(|row| row.effect() == Effect::PowerCycle).unwrap().address();
        let object = MODEL.object(power_cycle).unwrap();
        let now = go(link, ReadContent::new(&MODEL, power_cycle, &mut []).unwrap()).unwrap();
        let other =
            (0..100).map(Content::Int).find(|c| *c != now && c.check(&MODEL, object).is_ok()).unwrap();
        let wanted = [
            Setting::number(at(0x6081, 0), 20_000),
            Setting { address: power_cycle, value: other },
            Setting::number(at(0x607F, 0), 25_000),
        ];
        let mut rows = Vec::new();
        let before = go(link, Columns::new(&MODEL, &wanted, |row| rows.push(row.with(&MODEL).to_string())));
        assert_eq!((before.agree, before.differ), (0, 3), "{rows:#?}");

        let mut slots = [Slot::EMPTY; 16];
        let mut apply = Apply::new(&MODEL, &wanted, &[], &mut slots).unwrap();
        let applied =
            run(&mut apply, link, Policy::default()).unwrap().map_err(|e| apply.explain(&e).to_string());
        let applied = applied.unwrap();
        assert_eq!((applied.written, applied.unchanged, applied.power_cycle), (3, 0, 1));
        assert_eq!(apply.written().next(), Some(at(0x607F, 0)), "the limit goes first");
        assert_eq!(apply.effects().collect::<Vec<_>>(), [(power_cycle, Effect::PowerCycle)]);
        assert_eq!(go(link, Columns::new(&MODEL, &wanted, |_| {})).agree, 3);
    });
}

#[test]
fn a_set_that_breaks_a_rule_of_the_manual_is_not_written() {
    with_drive(|link| {
        // R18: homing methods 15, 16 and 31 to 34 are reserved.
        let wanted = [Setting::number(at(0x6081, 0), 20_000), Setting::number(at(0x6098, 0), 33)];
        let mut slots = [Slot::EMPTY; 16];
        let mut apply = Apply::new(&MODEL, &wanted, &[], &mut slots).unwrap();
        let error = run(&mut apply, link, Policy::default()).unwrap().unwrap_err();
        assert!(matches!(error.cause, SetCause::Rule { id: "R18", .. }), "{error}");
        assert_eq!(go(link, Read::new(od::PROFILE_VELOCITY)), Ok(0));
    });
}

#[test]
fn what_process_data_carry_is_not_written_by_sdo() {
    let receive = MODEL.pdo(at(0x1600, 0)).unwrap().entries();
    let write = WriteContent::new(&MODEL, at(0x607A, 0), Content::Int(5)).unwrap();
    let error = write.beside(receive).unwrap_err();
    assert_eq!(error.cause, Cause::MappedInRxPdo);
}

#[test]
fn a_drive_without_1010h_says_so() {
    assert_eq!(Store::new(&MODEL, 1).unwrap_err().cause, StoreCause::NoStore);
}

/// On an SDV3-E that had 1010h.
#[test]
fn what_is_stored_is_there_after_a_power_cycle_and_targets_are_harmless() {
    let mut objects = MODEL.objects().to_vec();
    let save = ObjectDesc::new(at(0x1010, 1), DataType::UNSIGNED32, Access::Rw, Mapping::Unmapped, "Save");
    objects.insert(objects.partition_point(|object| object.address() < save.address()), save.default_int(1));
    let model = MODEL.with_objects(&objects);
    let mut memory = vec![0; cells(&model)];
    let mut drive = VirtualDrive::new(&model, &mut memory, Config::default()).unwrap();
    let mut link = Link::new(&mut drive, Duration::from_millis(1));
    link.drive().advance(Duration::from_millis(200));
    link.drive().request(EsmState::PreOp).unwrap();
    go(&mut link, Write::new(od::PROFILE_VELOCITY, 7_000).unwrap()).unwrap();
    go(&mut link, Write::new(od::TARGET_VELOCITY, 5).unwrap()).unwrap();

    let refused = go(&mut link, Store::new(&model, 1).unwrap()).unwrap_err();
    assert_eq!(
        (refused.address, refused.cause),
        (at(0x60FF, 0), StoreCause::Target { value: 5, harmless: 0 })
    );
    assert!(go(&mut link, Store::new(&model, 1).unwrap().neutralize()).unwrap().confirmed);
    link.drive().power_cycle();
    link.drive().advance(Duration::from_millis(200));
    link.drive().request(EsmState::PreOp).unwrap();
    assert_eq!(go(&mut link, Read::new(od::PROFILE_VELOCITY)), Ok(7_000));
    assert_eq!(go(&mut link, Read::new(od::TARGET_VELOCITY)), Ok(0));
}

/// An executor of one task: the virtual bus never waits.
fn block_on<T>(future: impl Future<Output = T>) -> T {
    let mut future = pin!(future);
    loop {
        if let Poll::Ready(output) = future.as_mut().poll(&mut Context::from_waker(Waker::noop())) {
            return output;
        }
    }
}

#[test]
fn a_task_gets_what_a_thread_gets() {
    let blocking = with_drive(|link| go(link, Identify::new(&MODEL)));
    let task =
        with_drive(|link| block_on(run_async(&mut Identify::new(&MODEL), link, Policy::default())).unwrap());
    assert_eq!(blocking, task);
    let count = |link: &mut Link<'_, '_, '_>| {
        block_on(run_async(&mut Compare::new(&MODEL, |_| {}), link, Policy::default())).unwrap()
    };
    assert_eq!(with_drive(count), with_drive(|link| go(link, Compare::new(&MODEL, |_| {}))));
}

#[test]
fn every_alarm_prints_with_its_causes_and_remedies() {
    for alarm in MODEL.alarms() {
        with_drive(|link| {
            link.drive().raise(alarm.display(), alarm.number()).unwrap();
            link.drive().advance(Duration::from_millis(100));
            let message = std::iter::from_fn(|| link.drive().emergency()).last();
            let read = ReadFault::new(&MODEL);
            let read = message.map_or(read, |message| read.with_emergency(Emergency(message)));
            let evidence = go(link, read).unwrap();
            let fault = Fault::new(&MODEL, &ALARM_TEXTS, evidence);
            let text = fault.to_string();
            assert!(
                fault.alarms().any(|found| found == alarm),
                "{} {:X}h: {text}",
                alarm.display(),
                alarm.number()
            );
            if let Some(found) = fault.alarm() {
                assert!(text.contains(found.name()), "{text}");
                let causes = AlarmText::find(&ALARM_TEXTS, found).map_or(0, |t| t.causes().len());
                assert_eq!(text.contains("causes :"), causes > 0, "{text}");
            }
        });
    }
}
