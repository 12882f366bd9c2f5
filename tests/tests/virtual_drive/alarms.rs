//! Alarms, table 5-1: each is raised, seen and reset as its column says.

use drivewright_runtime::model::{EsmState, Reset};
use savch_sdv3_e::MODEL;

use crate::Rig;

#[test]
fn each_alarm_as_its_column_says() {
    assert_eq!(MODEL.alarms().len(), 37);
    for alarm in MODEL.alarms() {
        let mut rig = Rig::enabled(1);
        let what = alarm.display();
        rig.drive.raise(alarm.display(), alarm.number()).unwrap();
        rig.run(1);
        assert_eq!(rig.status() & 0x4F, 0x0F, "{what}: fault reaction active");
        rig.run(2);
        assert_eq!(rig.status() & 0x4F, 0x08, "{what}: fault");
        assert_eq!(rig.read(0x603F, 0), i64::from(alarm.code()), "{what}");
        assert_eq!(rig.read(0x1001, 0) & 1, 1, "{what}");
        assert_eq!(rig.word(0x0F) & 0x4F, 0x08, "{what}: a level is no edge");
        assert_eq!(rig.word(0x00) & 0x4F, 0x08);
        let after = rig.word(0x80) & 0x4F;
        // The highest bit of the auxiliary code says whether it can be reset: below table 5-1.
        let resettable = alarm.aux().unwrap() & 0x8000 != 0;
        assert_eq!(resettable, alarm.reset() == Reset::Resettable, "{what}");
        assert_eq!(after, if resettable { 0x40 } else { 0x08 }, "{what}");
        rig.drive.power_cycle();
        rig.run(100);
        assert_eq!((rig.status(), rig.read(0x603F, 0)), (0x0250, 0), "{what}");
    }
}

#[test]
fn the_emergency_message_is_laid_out_as_table_3_15() {
    let mut rig = Rig::new();
    rig.drive.raise("OF", 0x25).unwrap();
    assert_eq!(rig.drive.emergency(), Some([0x11, 0x86, 0x21, 0x25, 0x05, 0x80, 0, 0]));
    rig.run(2);
    rig.word(0x80);
    assert_eq!(rig.drive.emergency(), Some([0; 8]));
    assert_eq!(rig.drive.emergency(), None);
    rig.drive.request(EsmState::Init).unwrap();
    rig.drive.raise("OF", 0x25).unwrap();
    assert_eq!(rig.drive.emergency(), None, "3.6: none in Init");
    assert!(rig.drive.raise("OF", 0x26).is_err());
}

#[test]
fn two_alarms_are_reset_one_by_one() {
    let mut rig = Rig::new();
    rig.drive.raise_for_good("OS", 3).unwrap();
    rig.drive.raise("HV", 5).unwrap();
    rig.run(2);
    assert_eq!((rig.read(0x603F, 0), rig.drive.alarms().count()), (0x3210, 2));
    rig.word(0);
    assert_eq!(rig.word(0x80) & 0x4F, 0x08);
    assert_eq!((rig.read(0x603F, 0), rig.drive.alarms().count()), (0x8400, 1));
    rig.drive.end_cause("OS", 3).unwrap();
    rig.word(0);
    assert_eq!(rig.word(0x80), 0x0250);
}

#[test]
fn a_load_that_pulls_the_axis_away_is_a_following_error() {
    let mut rig = Rig::enabled(1);
    rig.write(0x6065, 0, 100).unwrap();
    rig.write(0x60E0, 0, 100).unwrap();
    rig.write(0x60E1, 0, 100).unwrap();
    rig.drive.axis_mut().set_load(500);
    rig.until(0x4F, 0x0F);
    assert_eq!(rig.read(0x603F, 0), 0x8611, "OF");
    let time = rig.until(0x4F, 0x08);
    assert!(time <= 5_001, "it cannot stop, and gives up: {time} ms");
}

#[test]
fn torque_above_rated_is_an_overload_after_some_time() {
    let mut rig = Rig::enabled(1);
    rig.drive.axis_mut().set_load(2_000);
    let time = rig.until(0x4F, 0x0F);
    assert_eq!(rig.read(0x603F, 0), 0x3230, "OL1");
    assert!((8_000..12_000).contains(&time), "ten seconds at twice the rated torque: {time} ms");
}

#[test]
fn a_jump_of_the_cyclic_target_is_an_action_error() {
    let mut rig = Rig::enabled(8);
    rig.write(0x607A, 0, 100_000_000).unwrap();
    rig.run(2);
    assert_eq!(rig.read(0x603F, 0), 0x8802, "Act");
}
