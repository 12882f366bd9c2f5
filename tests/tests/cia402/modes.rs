//! Modes of operation, supported drive modes, and the status of homing.

use drivewright_runtime::cia402::{HomingState, Mode, Statusword};

use super::table::rows;

/// 6060h, name, bit of 6502h, whether a target comes every cycle. Standard, and SDV3-E manual 4.1.4.
const MODES: &str = "
    0  | no mode                                         | -  | no
    1  | profile position                                | 0  | no
    2  | velocity                                        | 1  | no
    3  | profile velocity                                | 2  | no
    4  | profile torque                                  | 3  | no
    5  | -                                               | 4  | no
    6  | homing                                          | 5  | no
    7  | interpolated position                           | 6  | no
    8  | cyclic synchronous position                     | 7  | yes
    9  | cyclic synchronous velocity                     | 8  | yes
    10 | cyclic synchronous torque                       | 9  | yes
    11 | cyclic synchronous torque with commutation angle | 10 | yes
";

/// What is not stated.
fn stated(text: &str) -> Option<&str> {
    (text != "-").then_some(text)
}

#[test]
fn b10_every_number_is_a_mode_and_none_panics() {
    let table = rows::<4>(MODES);
    for number in i8::MIN..=i8::MAX {
        let mode = Mode(number);
        let row = table.iter().find(|row| row[0].parse() == Ok(number));
        assert_eq!(mode.name(), row.and_then(|row| stated(row[1])), "{number}");
        let bit = row.and_then(|row| stated(row[2])).map(|bit| 1 << bit.parse::<u32>().expect("a number"));
        assert_eq!(mode.supported_bit(), bit, "{number}");
        assert_eq!(mode.is_cyclic(), row.is_some_and(|row| row[3] == "yes"), "{number}");
        assert!(format!("{mode:?}").contains(&number.to_string()));
    }
}

/// 6502h to modes and back, for every set of modes: no mode is missing, no two share a bit.
#[test]
fn b12_supported_modes_come_back_from_their_bits() {
    for bits in 0..1_u32 << 11 {
        let has = |mode: &Mode| mode.supported_bit().is_some_and(|bit| bits & bit != 0);
        let modes: Vec<Mode> = (i8::MIN..=i8::MAX).map(Mode).filter(has).collect();
        assert_eq!(modes.len(), bits.count_ones() as usize);
        let again = modes.iter().filter_map(|mode| mode.supported_bit()).fold(0, |all, bit| all | bit);
        assert_eq!(again, bits);
    }
}

/// The bytes `25 02 00 00` on the wire are 225h: profile position, profile velocity, homing, cyclic torque (B26).
#[test]
fn b26_supported_modes_are_read_lowest_byte_first() {
    let bits = u32::from_le_bytes([0x25, 0x02, 0, 0]);
    let has = |mode: &Mode| mode.supported_bit().is_some_and(|bit| bits & bit != 0);
    let modes: Vec<i8> = (i8::MIN..=i8::MAX).filter(|n| has(&Mode(*n))).collect();
    assert_eq!((bits, modes), (0x225, vec![1, 3, 6, 10]));
}

/// Bits 13, 12 and 10, and what they say. Standard, and SDV3-E manual 4.4.
const HOMING: &str = "
    000 | InProgress   | in progress
    001 | NotStarted   | not started or interrupted
    010 | Attained     | attained, target not reached
    011 | Completed    | completed
    100 | ErrorMoving  | error, still moving
    101 | ErrorStopped | error, at standstill
    110 | Reserved     | reserved pattern
    111 | Reserved     | reserved pattern
";

#[test]
fn every_word_is_the_homing_status_of_its_row() {
    let table = rows::<3>(HOMING);
    for word in 0..=u16::MAX {
        let bits: String =
            [13, 12, 10].map(|bit| if word >> bit & 1 == 1 { '1' } else { '0' }).iter().collect();
        let [_, name, shown] = table.iter().find(|row| row[0] == bits).expect("there are eight rows");
        let status = HomingState::of(Statusword(word));
        assert_eq!((format!("{status:?}").as_str(), status.word()), (*name, *shown), "{word:04X}h");
    }
}
