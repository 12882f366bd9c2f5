//! SDO: every abort of table 5-2, and what is kept.

use std::time::Duration;

use drivewright_runtime::AbortCode;
use drivewright_runtime::model::{AbortDesc, EsmState};
use drivewright_runtime::sim::NoAnswer;
use savch_sdv3_e::MODEL;

use crate::{Rig, at};

/// Provokes each code of the table but the one for reading what can only be written: the drive has no such object.
#[test]
fn every_abort_of_the_table() {
    let mut seen = Vec::new();
    let mut expect = |result: Result<(), AbortCode>, code: u32| {
        assert_eq!(result, Err(AbortCode(code)), "{code:08X}");
        seen.push(AbortCode(code));
    };
    let mut rig = Rig::new();
    expect(rig.write(0x1A00, 1, 0x6041_0010), 0x0601_0000);
    expect(rig.write_bytes(0x6041, 0, &[0, 0]), 0x0601_0002);
    expect(rig.write_bytes(0x5000, 0, &[0]), 0x0602_0000);
    expect(rig.write_bytes(0x6040, 0, &[]), 0x0607_0010);
    expect(rig.write_bytes(0x6040, 0, &[0; 4]), 0x0607_0012);
    expect(rig.write_bytes(0x607A, 0, &[0; 2]), 0x0607_0013);
    expect(rig.write_bytes(0x6040, 1, &[0]), 0x0609_0011);
    expect(rig.write(0x6060, 0, 7), 0x0609_0030);
    expect(rig.write(0x6071, 0, 3_001), 0x0609_0031);
    expect(rig.write(0x6071, 0, -3_001), 0x0609_0032);
    rig.write(0x1C13, 0, 0).unwrap();
    rig.write(0x1A00, 0, 0).unwrap();
    expect(rig.write(0x1A00, 1, 0x605A_0010), 0x0604_0041);
    expect(rig.write(0x1A00, 0, 11), 0x0604_0042);
    rig.drive.request(EsmState::SafeOp).unwrap();
    expect(rig.write(0x1A00, 0, 0), 0x0800_0000);
    rig.drive.operate_locally(true);
    expect(rig.write(0x6083, 0, 200), 0x0800_0021);
    let write_only = MODEL.objects().iter().any(|object| !object.access().reads());
    let expected = MODEL.aborts().iter().map(AbortDesc::code);
    let missing: Vec<_> = expected.filter(|code| !seen.contains(code)).collect();
    assert!(!write_only);
    assert_eq!(missing, [AbortCode::WRITE_ONLY]);
}

#[test]
fn ranges_and_lists_are_those_of_the_model() {
    let mut rig = Rig::new();
    for object in MODEL.objects().iter().filter(|o| o.access().writes() && o.address().index() >= 0x2000) {
        let (index, sub) = (object.address().index(), object.address().sub());
        let fits =
            |value: &i128| object.data_type().range().is_some_and(|(min, max)| (min..=max).contains(value));
        if let Some(above) = object.max().map(|max| max + 1).filter(fits) {
            let result = rig.write(index, sub, i64::try_from(above).unwrap());
            assert_eq!(result, Err(AbortCode::VALUE_TOO_HIGH), "{}", object.address());
        }
        if let Some(below) = object.min().map(|min| min - 1).filter(fits) {
            let result = rig.write(index, sub, i64::try_from(below).unwrap());
            assert_eq!(result, Err(AbortCode::VALUE_TOO_LOW), "{}", object.address());
        }
        for value in MODEL.allowed_of(object).unwrap_or(&[]) {
            assert_eq!(rig.write(index, sub, *value), Ok(()), "{}", object.address());
        }
    }
}

#[test]
fn defaults_are_read_as_printed() {
    let mut rig = Rig::new();
    for (index, sub, value) in [
        (0x1018, 1, 0x7E6),
        (0x1018, 2, 0x5344_5633),
        (0x1600, 1, 0x6040_0010),
        (0x1602, 0, 2),
        (0x6065, 0, 1_966_080),
        (0x6083, 0, 100),
        (0x6093, 1, 16),
        (0x6502, 0, 0x6D),
        (0x6099, 1, 1),
    ] {
        assert_eq!(rig.read(index, sub), value, "{index:04X}:{sub:02X}");
    }
}

#[test]
fn a_rule_that_says_refused_refuses() {
    let mut rig = Rig::new();
    assert_eq!(rig.write(0x1C33, 3, 125_000), Ok(()));
    assert_eq!(rig.write(0x1C33, 3, 125_001), Err(AbortCode::VALUE), "R01");
}

#[test]
fn a_write_that_a_rule_calls_an_alarm_raises_it() {
    let mut rig = Rig::new();
    rig.write(0x60B8, 0, 0x11).unwrap();
    rig.run(2);
    assert_eq!(rig.read(0x603F, 0), 0x8802, "R23: no input is EXT1");
    let mut rig = Rig::new();
    rig.write(0x3002, 3, 40).unwrap();
    rig.write(0x60B8, 0, 0x11).unwrap();
    rig.run(2);
    assert_eq!(rig.read(0x603F, 0), 0);
}

#[test]
fn what_survives_a_power_cycle() {
    let mut rig = Rig::new();
    rig.write(0x3000, 2, 77).unwrap();
    rig.write(0x6083, 0, 500).unwrap();
    rig.write(0x3003, 3, 5).unwrap();
    assert_eq!(rig.drive.value(at(0x3003, 3)), Some(0), "P4.03 counts after a power cycle");
    assert_eq!(rig.read(0x3003, 3), 5);
    rig.drive.power_cycle();
    rig.drive.advance(Duration::from_millis(100));
    assert_eq!(
        (rig.read(0x3000, 2), rig.read(0x6083, 0), rig.drive.value(at(0x3003, 3))),
        (77, 100, Some(5))
    );
}

#[test]
fn in_init_there_is_no_mailbox() {
    let mut rig = Rig::new();
    rig.drive.request(EsmState::Init).unwrap();
    assert_eq!(rig.drive.download(at(0x6040, 0), &[0, 0]), Err(NoAnswer::Silent));
}
