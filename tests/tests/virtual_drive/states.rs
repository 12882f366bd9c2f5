//! The state machine, sections 4.1.1 to 4.1.3: exact statuswords.

use std::collections::BTreeSet;

use drivewright_runtime::cia402::Transition;

use crate::Rig;

#[test]
fn the_usual_way_up_and_down() {
    let mut rig = Rig::new();
    assert_eq!(rig.status(), 0x0250, "switch on disabled, voltage, remote");
    rig.write(0x6060, 0, 1).unwrap();
    assert_eq!(rig.word(0x0006), 0x0231, "transition 2");
    assert_eq!(rig.word(0x0007), 0x0233, "transition 3");
    assert_eq!(rig.word(0x000F), 0x0637, "transition 4; it stands at its target");
    assert_eq!(rig.word(0x0007) & 0x6F, 0x27, "605Ch is not there: it brakes first");
    assert_eq!(rig.word(0x0007), 0x0233, "transition 5");
    assert_eq!(rig.word(0x0006), 0x0231, "transition 6");
    assert_eq!(rig.word(0x0000), 0x0250, "transition 7");
}

#[test]
fn every_command_from_operation_enabled() {
    for (word, status) in [(0x0006, 0x0231), (0x0000, 0x0250), (0x0002, 0x0217), (0x000F, 0x0637)] {
        assert_eq!(Rig::enabled(1).word(word), status, "{word:04X}");
    }
    let mut rig = Rig::enabled(1);
    rig.word(0x0006);
    assert_eq!(rig.word(0x000F), 0x0231, "enable operation is no command of ready to switch on");
    rig.word(0x0007);
    assert_eq!(rig.word(0x0002), 0x0250, "transition 10");
    rig.word(0x0006);
    assert_eq!(rig.word(0x0002), 0x0250, "transition 7");
}

#[test]
fn quick_stop_by_option_code() {
    let mut rig = Rig::enabled(1);
    assert_eq!((rig.word(0x0002), rig.word(0x0002)), (0x0217, 0x0250), "605Ah is 0: it coasts");

    let mut rig = Rig::enabled(3);
    rig.write(0x605A, 0, 1).unwrap();
    rig.write(0x60FF, 0, 10_000).unwrap();
    rig.run(10);
    rig.until(0x0400, 0x0400);
    assert_eq!(rig.word(0x0002) & 0x6F, 0x07);
    assert!(rig.until(0x6F, 0x40) > 20, "1,000 rpm at 2,000 rpm in 100 ms take 50 ms");
    assert_eq!(rig.word(0x000F), 0x0250, "the drive does not go back by itself");

    let mut rig = Rig::enabled(3);
    rig.write(0x605A, 0, 5).unwrap();
    rig.word(0x0002);
    rig.run(100);
    assert_eq!(rig.status() & 0x6F, 0x07, "it stays");
    assert_eq!(rig.word(0x000F) & 0x6F, 0x27, "transition 16");
    rig.word(0x0002);
    assert_eq!(rig.word(0x0000), 0x0250, "transition 12 by command");
}

#[test]
fn only_option_codes_of_the_table() {
    let mut rig = Rig::new();
    for code in [0, 1, 5] {
        assert_eq!(rig.write(0x605A, 0, code), Ok(()));
    }
    assert!(rig.write(0x605A, 0, 2).is_err());
}

#[test]
fn supplies() {
    let mut rig = Rig::new();
    rig.drive.set_mains(false);
    rig.run(1);
    assert_eq!(rig.status(), 0x0240);
    assert_eq!((rig.word(0x0006), rig.word(0x0007)), (0x0221, 0x0221), "it is not switched on");
    rig.drive.set_mains(true);
    assert_eq!(rig.word(0x0007), 0x0233);
    rig.drive.set_mains(false);
    rig.run(3);
    assert_eq!(rig.read(0x603F, 0), 0x3220, "LuP");
    assert_eq!(rig.status() & 0x4F, 0x08);
    rig.word(0);
    assert_eq!(rig.word(0x80) & 0x4F, 0x08, "the cause is there");
    rig.drive.set_mains(true);
    rig.word(0);
    assert_eq!(rig.word(0x80), 0x0250);
}

#[test]
fn a_drive_that_is_operated_locally_is_not_remote() {
    let mut rig = Rig::new();
    rig.drive.operate_locally(true);
    rig.run(1);
    assert_eq!(rig.status(), 0x0050);
    rig.drive.operate_locally(false);
    rig.drive.warn(true);
    rig.run(1);
    assert_eq!(rig.status(), 0x02D0);
}

#[test]
fn without_a_mode_enabling_is_an_alarm() {
    let mut rig = Rig::new();
    for word in [0x06, 0x07, 0x0F] {
        rig.word(word);
    }
    rig.run(3);
    assert_eq!((rig.read(0x603F, 0), rig.status() & 0x4F), (0x8800, 0x08), "oPE");
}

#[test]
fn a_drive_that_starts_up_does_not_answer() {
    let mut rig = Rig::new();
    rig.drive.power_cycle();
    assert_eq!(rig.status(), 0x0010, "not ready to switch on");
    let mut data = [0; 2];
    assert!(rig.drive.upload(crate::at(0x6041, 0), &mut data).is_err());
    rig.run(100);
    assert_eq!(rig.read(0x6041, 0), 0x0250);
}

/// Transition 0 is power-on itself.
#[test]
fn all_seventeen_transitions_are_made() {
    let mut rig = Rig::new();
    let mut seen = BTreeSet::from([0]);
    rig.drive.power_cycle();
    let note = |rig: &Rig, seen: &mut BTreeSet<u8>| {
        seen.extend(rig.drive.transition().map(Transition::number));
    };
    for _ in 0..100 {
        rig.run(1);
        note(&rig, &mut seen);
    }
    rig.write(0x6060, 0, 1).unwrap();
    rig.write(0x605A, 0, 5).unwrap();
    let up = [0x06, 0x07, 0x0F];
    let walks: [&[i64]; 9] = [
        &[0x07, 0x07, 0x06, 0x00],
        &[0x06, 0x02],
        &[0x00],
        &[0x02, 0x0F, 0x00],
        &[0x02, 0x00],
        &[0x07, 0x07, 0x00],
        &[-1, 0x0F, 0x00, 0x80, 0x00],
        &[0x07, 0x07, 0x02],
        &[0x00],
    ];
    for walk in walks {
        for word in up.iter().chain(walk) {
            if *word < 0 {
                rig.drive.raise("OF", 0x25).unwrap();
                rig.run(1);
            } else {
                rig.word(*word);
            }
            note(&rig, &mut seen);
        }
        assert_eq!(rig.status() & 0x6F, 0x40, "back: {walk:?}");
    }
    assert_eq!(seen, (0..=16).collect());
}
