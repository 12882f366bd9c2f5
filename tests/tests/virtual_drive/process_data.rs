//! Process data: the example of section 3.4 step by step, each wrong order refused, and the exchange.

use drivewright_runtime::AbortCode;
use drivewright_runtime::model::EsmState;
use drivewright_runtime::sim::BusRefusal;

use crate::Rig;

/// The steps of section 3.4 for `TxPDO1` with two entries: index, sub-index, value.
const STEPS: [(u16, u8, i64); 7] = [
    (0x1C13, 0, 0),
    (0x1A00, 0, 0),
    (0x1A00, 1, 0x6041_0010),
    (0x1A00, 2, 0x60FC_0020),
    (0x1A00, 0, 2),
    (0x1C13, 1, 0x1A00),
    (0x1C13, 0, 1),
];

fn op(rig: &mut Rig) {
    for state in [EsmState::SafeOp, EsmState::Op] {
        rig.drive.request(state).unwrap();
    }
}

#[test]
fn the_example_remaps() {
    let mut rig = Rig::new();
    for (index, sub, value) in STEPS {
        assert_eq!(rig.write(index, sub, value), Ok(()), "{index:04X}:{sub:02X}");
    }
    op(&mut rig);
    assert_eq!(rig.drive.process_data_bytes(), (13, 6));
    let mut inputs = [0; 6];
    assert_eq!(rig.drive.send(&mut inputs), Some(6));
    assert_eq!(inputs, [0x50, 0x02, 0, 0, 0, 0]);
}

/// A step that is left out makes a later one fail; without the last two nothing is exchanged.
#[test]
fn no_step_can_be_left_out() {
    for (left_out, refused) in [(0, Some(1)), (1, Some(2)), (4, None), (5, None), (6, None)] {
        let mut rig = Rig::new();
        let results: Vec<_> = (0..STEPS.len())
            .filter(|step| *step != left_out)
            .map(|step| (step, rig.write(STEPS[step].0, STEPS[step].1, STEPS[step].2)))
            .collect();
        let first = results.iter().find(|(_, result)| result.is_err());
        assert_eq!(first.map(|(step, _)| *step), refused, "without step {left_out}");
        if let Some((_, result)) = first {
            assert_eq!(*result, Err(AbortCode::UNSUPPORTED_ACCESS));
        }
        op(&mut rig);
        let bytes = match left_out {
            4 | 6 => 0,
            // The first two of the old entries, or all of the new ones: 1C13:01 was 1A00h before.
            1 | 5 => 6,
            _ => 13,
        };
        assert_eq!(rig.drive.process_data_bytes().1, bytes, "without step {left_out}");
    }
}

#[test]
fn what_cannot_be_exchanged_is_not_safe_op() {
    let mut rig = Rig::new();
    for (index, sub, value) in [(0x1C12, 0, 0), (0x1603, 0, 0)] {
        rig.write(index, sub, value).unwrap();
    }
    for sub in 1..=9 {
        rig.write(0x1603, sub, 0x607A_0020).unwrap();
    }
    for (index, sub, value) in [(0x1603, 0, 9), (0x1C12, 1, 0x1603), (0x1C12, 0, 1)] {
        rig.write(index, sub, value).unwrap();
    }
    assert_eq!(rig.drive.request(EsmState::SafeOp), Err(BusRefusal::OutputMapping), "36 bytes, R05");
    assert_eq!(rig.drive.bus_state(), EsmState::PreOp);
    assert_eq!(rig.drive.request(EsmState::Op), Err(BusRefusal::InvalidChange), "R14");
    assert_eq!(rig.write(0x1C12, 0, 2), Err(AbortCode::VALUE), "R06");
}

#[test]
fn a_cycle_below_a_millisecond_is_refused_in_free_run() {
    let mut rig = Rig::new();
    rig.write(0x1C32, 2, 250_000).unwrap();
    assert_eq!(rig.drive.request(EsmState::SafeOp), Err(BusRefusal::CycleTime), "R03");
}

/// 6040h, 607Ah, 60FFh, 6071h, 6060h.
fn outputs(word: u16, mode: u8) -> [u8; 13] {
    let mut data = [0; 13];
    data[..2].copy_from_slice(&word.to_le_bytes());
    data[12] = mode;
    data
}

#[test]
fn process_data_count_in_op_only_and_overwrite() {
    let mut rig = Rig::new();
    rig.drive.request(EsmState::SafeOp).unwrap();
    assert!(!rig.drive.receive(&outputs(6, 1)), "SafeOP");
    rig.drive.request(EsmState::Op).unwrap();
    assert!(!rig.drive.receive(&outputs(6, 1)[..12]), "a byte is missing");
    assert!(rig.drive.receive(&outputs(6, 1)));
    rig.run(1);
    assert_eq!((rig.read(0x6040, 0), rig.read(0x6061, 0), rig.status()), (6, 1, 0x0231));
    rig.write(0x6060, 0, 3).unwrap();
    rig.drive.receive(&outputs(6, 1));
    rig.run(1);
    assert_eq!(rig.read(0x6061, 0), 1, "R12: the PDO overwrites what SDO has written");
    let mut inputs = [0; 13];
    assert_eq!(rig.drive.send(&mut inputs), Some(13));
    assert_eq!((inputs[0], inputs[1], inputs[12]), (0x31, 0x02, 1));
    assert_eq!(rig.drive.send(&mut inputs[..12]), None);
}

#[test]
fn process_data_that_stop_are_an_alarm() {
    let mut rig = Rig::new();
    op(&mut rig);
    for word in [6, 7, 15] {
        rig.drive.receive(&outputs(word, 3));
        rig.run(1);
    }
    assert_eq!(rig.status() & 0x6F, 0x27);
    rig.run(110);
    assert_eq!((rig.read(0x603F, 0), rig.drive.bus_state()), (0x8100, EsmState::SafeOp), "Pto");
    assert_eq!(rig.status() & 0x4F, 0x08);
}

#[test]
fn the_bus_state_is_not_changed_while_enabled() {
    let mut rig = Rig::new();
    op(&mut rig);
    for word in [6, 7, 15] {
        rig.drive.receive(&outputs(word, 3));
        rig.run(1);
    }
    rig.drive.request(EsmState::PreOp).unwrap();
    rig.run(3);
    assert_eq!((rig.read(0x603F, 0), rig.drive.bus_state()), (0x8801, EsmState::PreOp), "ESr, R15");
}

#[test]
fn a_rule_holds_for_process_data_too() {
    let mut rig = Rig::new();
    for (index, sub, value) in [
        (0x1C12, 0, 0),
        (0x1600, 0, 0),
        (0x1600, 1, 0x6040_0010),
        (0x1600, 2, 0x60B8_0010),
        (0x1600, 0, 2),
        (0x1C12, 0, 1),
    ] {
        rig.write(index, sub, value).unwrap();
    }
    op(&mut rig);
    assert!(rig.drive.receive(&[0, 0, 0x11, 0]));
    rig.run(2);
    assert_eq!(rig.read(0x603F, 0), 0x8802, "R23: no input is EXT1");
}
