//! Single bits of both words, and composing a controlword out of a command and the bits of a mode.

use drivewright_runtime::cia402::{Command, Controlword, ModeBits, Statusword};

use super::table::rows;

type Get<W> = (&'static str, fn(W) -> bool, u16);

const STATUS: [Get<Statusword>; 10] = [
    ("voltage enabled", Statusword::voltage_enabled, Statusword::VOLTAGE_ENABLED),
    ("warning", Statusword::has_warning, Statusword::WARNING),
    ("manufacturer 8", Statusword::manufacturer_8, Statusword::MANUFACTURER_8),
    ("remote", Statusword::is_remote, Statusword::REMOTE),
    ("target reached", Statusword::target_reached, Statusword::TARGET_REACHED),
    ("internal limit active", Statusword::internal_limit, Statusword::INTERNAL_LIMIT),
    ("mode specific 12", Statusword::mode_12, Statusword::MODE_12),
    ("mode specific 13", Statusword::mode_13, Statusword::MODE_13),
    ("manufacturer 14", Statusword::manufacturer_14, Statusword::MANUFACTURER_14),
    ("manufacturer 15", Statusword::manufacturer_15, Statusword::MANUFACTURER_15),
];

/// SDV3-E manual, 4.1.3, the first table; bits 0 to 3, 5 and 6 are the state.
const STATUS_BITS: &str = "
    4  | voltage enabled
    7  | warning
    8  | manufacturer 8
    9  | remote
    10 | target reached
    11 | internal limit active
    12 | mode specific 12
    13 | mode specific 13
    14 | manufacturer 14
    15 | manufacturer 15
";

const CONTROL: [Get<Controlword>; 10] = [
    ("switch on", Controlword::switch_on, Controlword::SWITCH_ON),
    ("enable voltage", Controlword::enable_voltage, Controlword::ENABLE_VOLTAGE),
    ("quick stop, 0 asks for it", Controlword::no_quick_stop, Controlword::QUICK_STOP),
    ("enable operation", Controlword::enable_operation, Controlword::ENABLE_OPERATION),
    ("mode specific 4", Controlword::mode_4, Controlword::MODE_4),
    ("mode specific 5", Controlword::mode_5, Controlword::MODE_5),
    ("mode specific 6", Controlword::mode_6, Controlword::MODE_6),
    ("fault reset", Controlword::fault_reset, Controlword::FAULT_RESET),
    ("halt", Controlword::halt, Controlword::HALT),
    ("mode specific 9", Controlword::mode_9, Controlword::MODE_9),
];

/// SDV3-E manual, 4.1.2, the first table; bit 9 is that of the standard.
const CONTROL_BITS: &str = "
    0 | switch on
    1 | enable voltage
    2 | quick stop, 0 asks for it
    3 | enable operation
    4 | mode specific 4
    5 | mode specific 5
    6 | mode specific 6
    7 | fault reset
    8 | halt
    9 | mode specific 9
";

fn compare<W: Copy>(text: &'static str, gets: &[Get<W>], word: fn(u16) -> W) {
    let table = rows::<2>(text);
    assert_eq!(table.len(), gets.len());
    for ([bit, name], (got, get, constant)) in table.into_iter().zip(gets) {
        let mask = 1 << bit.parse::<u32>().expect("a number");
        assert_eq!((name, mask), (*got, *constant));
        for raw in 0..=u16::MAX {
            assert_eq!(get(word(raw)), raw & mask != 0, "{name} of {raw:04X}h");
        }
    }
}

#[test]
fn every_bit_of_the_words_is_at_its_place() {
    compare(STATUS_BITS, &STATUS, Statusword);
    compare(CONTROL_BITS, &CONTROL, Controlword);
}

/// Mode, word, bit and meaning: the standard, and SDV3-E manual 4.2 to 4.8.
const MODE_BITS: &str = "
    profile position | control | 4  | new set-point
    profile position | control | 5  | change immediately
    profile position | control | 6  | relative
    profile position | control | 9  | change on set-point
    profile position | status  | 12 | set-point acknowledge
    profile position | status  | 13 | following error
    profile velocity | status  | 12 | speed is zero
    homing           | control | 4  | start
    homing           | status  | 12 | attained
    homing           | status  | 13 | error
    cyclic           | status  | 12 | follows the target
    cyclic           | status  | 13 | following error
";

fn mode_bit(mode: &str, meaning: &str) -> u16 {
    match (mode, meaning) {
        ("profile position", "new set-point") => ModeBits::NEW_SET_POINT,
        ("profile position", "change immediately") => ModeBits::CHANGE_IMMEDIATELY,
        ("profile position", "relative") => ModeBits::RELATIVE,
        ("profile position", "change on set-point") => ModeBits::CHANGE_ON_SET_POINT,
        ("profile position", "set-point acknowledge") => ModeBits::SET_POINT_ACKNOWLEDGE,
        ("profile position" | "cyclic", "following error") => ModeBits::FOLLOWING_ERROR,
        ("profile velocity", "speed is zero") => ModeBits::SPEED_IS_ZERO,
        ("homing", "start") => ModeBits::START_HOMING,
        ("homing", "attained") => ModeBits::HOMING_ATTAINED,
        ("homing", "error") => ModeBits::HOMING_ERROR,
        ("cyclic", "follows the target") => ModeBits::FOLLOWS_TARGET,
        other => panic!("{other:?} has no constant"),
    }
}

#[test]
fn every_bit_of_a_mode_is_at_its_place() {
    for [mode, word, bit, meaning] in rows::<4>(MODE_BITS) {
        let mask = 1 << bit.parse::<u32>().expect("a number");
        assert_eq!(mode_bit(mode, meaning), mask, "{mode}: {meaning}");
        // Bits of a mode never belong to a command, nor to the state.
        let others = if word == "control" { 0b1000_1111 } else { 0b0110_1111 };
        assert_eq!(mask & others, 0, "{mode}: {meaning}");
    }
}

/// Command, the value that is written for it: the standard's table and SDV3-E manual 4.1.2.
const WRITTEN: &str = "
    Shutdown         | 0000 0110
    Switch on        | 0000 0111
    Enable operation | 0000 1111
    Disable voltage  | 0000 0000
    Quick stop       | 0000 0010
    Fault reset      | 1000 0000
";

const COMMANDS: [Command; 6] = [
    Command::Shutdown,
    Command::SwitchOn,
    Command::EnableOperation,
    Command::DisableVoltage,
    Command::QuickStop,
    Command::FaultReset,
];

/// A controlword that is made of two keeps every bit that the other one owns (a constant over the bits of a mode stops
/// an axis, or starts a homing).
#[test]
fn composing_a_word_changes_no_bit_of_the_other_owner() {
    for ([name, value], command) in rows::<2>(WRITTEN).into_iter().zip(COMMANDS) {
        let value = u16::from_str_radix(&value.replace(' ', ""), 2).expect("a number");
        assert_eq!((command.word(), command.bits(), Controlword::new(command).0), (name, value, value));
        for word in 0..=u16::MAX {
            let made = Controlword(word).with_command(command).0;
            let again = Controlword(value).with_mode_bits(word).0;
            for bit in 0..16 {
                let owner = if matches!(bit, 0..=3 | 7) { value } else { word };
                assert_eq!((made >> bit & 1, again >> bit & 1), (owner >> bit & 1, owner >> bit & 1));
            }
        }
    }
}
