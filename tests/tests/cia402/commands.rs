//! Every state × every controlword × the word before it × what decides besides: which transition, and where to.

use std::collections::BTreeSet;

use drivewright_runtime::cia402::{Cause, Command, Controlword, Options, State, StopOption, Transition};

use super::table::{Pattern, rows, state};

/// Bits of the controlword in the order of the manual's columns: fault reset, enable operation, quick stop, enable
/// voltage, switch on.
const COLUMNS: [u32; 5] = [7, 3, 2, 1, 0];

/// State, bits, 605Ah (`any`, or 5 to 8), state after it, transition. SDV3-E manual 4.1.2, its table of commands, row by
/// row, with the states that the standard gives its transitions. A state without a row keeps still.
///
/// `0 1111` in the state ready to switch on is no row: the manual lists enable operation for transitions 4 and 16 alone
/// (some drives of other makers do 3 and 4 in one).
const LEVELS: &str = "
    Switch on disabled | 0 x110 | any    | Ready to switch on | 2
    Ready to switch on | 0 0111 | any    | Switched on        | 3
    Ready to switch on | 0 xx0x | any    | Switch on disabled | 7
    Ready to switch on | 0 x01x | any    | Switch on disabled | 7
    Switched on        | 0 1111 | any    | Operation enabled  | 4
    Switched on        | 0 x110 | any    | Ready to switch on | 6
    Switched on        | 0 xx0x | any    | Switch on disabled | 10
    Switched on        | 0 x01x | any    | Switch on disabled | 10
    Operation enabled  | 0 0111 | any    | Switched on        | 5
    Operation enabled  | 0 x110 | any    | Ready to switch on | 8
    Operation enabled  | 0 xx0x | any    | Switch on disabled | 9
    Operation enabled  | 0 x01x | any    | Quick stop active  | 11
    Quick stop active  | 0 xx0x | any    | Switch on disabled | 12
    Quick stop active  | 0 1111 | 5 to 8 | Operation enabled  | 16
";

/// The only row that counts by an edge: bit 7 of the word before, bit 7 now, cause of the fault, state, transition.
const EDGES: &str = "
    Fault | 0 | 1 | gone    | Switch on disabled | 15
";

struct Level {
    pattern: Pattern,
    stays_only: bool,
    made: (State, u8),
}

/// Rows of a state.
fn levels(of: State) -> Vec<Level> {
    let rows = rows::<5>(LEVELS).into_iter().filter(|row| state(row[0]) == of);
    rows.map(|[_, bits, code, to, number]| Level {
        pattern: Pattern::new(bits, &COLUMNS),
        stays_only: code == "5 to 8",
        made: (state(to), number.parse().expect("a number")),
    })
    .collect()
}

struct Edge {
    bits: [bool; 2],
    persists: bool,
    made: (State, u8),
}

fn edges(of: State) -> Vec<Edge> {
    let rows = rows::<6>(EDGES).into_iter().filter(|row| state(row[0]) == of);
    rows.map(|[_, was, is, cause, to, number]| Edge {
        bits: [was == "1", is == "1"],
        persists: cause != "gone",
        made: (state(to), number.parse().expect("a number")),
    })
    .collect()
}

/// What the tables say of one word.
fn expected(
    tables: &(Vec<Level>, Vec<Edge>),
    word: u16,
    before: u16,
    options: Options,
) -> Option<(State, u8)> {
    let bits = [before & 0x80 != 0, word & 0x80 != 0];
    let edge = tables.1.iter().find(|e| e.bits == bits && e.persists == options.fault_persists);
    if let Some(edge) = edge {
        return Some(edge.made);
    }
    let mut found = tables.0.iter().filter(|l| l.pattern.holds(word));
    let row = found.next().filter(|l| options.quick_stop_stays || !l.stays_only);
    assert!(found.next().is_none(), "{word:04X}h has two rows");
    row.map(|l| l.made)
}

fn actual(of: State, word: u16, before: u16, options: Options) -> Option<(State, u8)> {
    let command = Transition::command(of, Controlword(word), Controlword(before))?;
    let made = Transition::of(of, Cause::Command(command), options)?;
    Some((made.to(), made.number()))
}

/// Bits 4 and 7 of the word before; the others are the mirror of the word, so that they would show.
fn before(word: u16) -> [u16; 4] {
    [0x00, 0x10, 0x80, 0x90].map(|bits| !word & !0x90 | bits)
}

/// Every state × every word × bits 4 and 7 of the word before × 605Ah keeping the state or not × fault there or gone.
#[test]
fn every_word_makes_the_transition_of_its_row() {
    let (mut tried, mut made) = (0_u32, BTreeSet::new());
    for of in State::ALL.iter().copied() {
        let tables = (levels(of), edges(of));
        for word in 0..=u16::MAX {
            for (before, both) in before(word).into_iter().flat_map(|b| OPTIONS.map(|o| (b, o))) {
                let is = actual(of, word, before, both);
                assert_eq!(
                    is,
                    expected(&tables, word, before, both),
                    "{of}, {word:04X}h after {before:04X}h, {both:?}"
                );
                made.extend(is.map(|(_, number)| number));
                tried += 1;
            }
        }
    }
    assert_eq!(tried, 8 * 65_536 * 4 * 4);
    assert_eq!(
        made,
        BTreeSet::from([2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 15, 16]),
        "1, 13 and 14 need no word"
    );
}

const OPTIONS: [Options; 4] = [
    Options { quick_stop_stays: false, fault_persists: false },
    Options { quick_stop_stays: true, fault_persists: false },
    Options { quick_stop_stays: false, fault_persists: true },
    Options { quick_stop_stays: true, fault_persists: true },
];

/// 605Ah as numbers: whether enable operation resumes, and whether the stop ends by itself.
const QUICK_STOP: &str = "
    0 | no  | Switch on disabled
    1 | no  | Switch on disabled
    2 | no  | Switch on disabled
    3 | no  | Switch on disabled
    4 | no  | Switch on disabled
    5 | yes | stays
    6 | yes | stays
    7 | yes | stays
    8 | yes | stays
";

/// Transition 16 only with 5 to 8, transition 12 by itself only with 0 to 4 (B1, B4).
#[test]
fn b04_a_quick_stop_ends_as_its_option_code_says() {
    for [code, resumes, end] in rows::<3>(QUICK_STOP) {
        let option = StopOption::quick_stop(code.parse().expect("a number")).expect("a code of the standard");
        let options = Options { quick_stop_stays: option.stays, ..Options::default() };
        for word in (0..=u16::MAX).filter(|w| w & 0x8F == 0x0F) {
            let is = actual(State::QuickStopActive, word, 0, options);
            assert_eq!(is, (resumes == "yes").then_some((State::OperationEnabled, 16)), "605Ah = {code}");
        }
        let done = Transition::of(State::QuickStopActive, Cause::Done, options).map(Transition::to);
        assert_eq!(done, (end != "stays").then(|| state(end)), "605Ah = {code}");
    }
}

/// Quick stop is a command in three states, and what it leads to differs.
#[test]
fn b03_quick_stop_is_known_in_every_state_that_has_power() {
    let to = |of| actual(of, 0x02, 0, Options::default());
    assert_eq!(to(State::ReadyToSwitchOn), Some((State::SwitchOnDisabled, 7)));
    assert_eq!(to(State::SwitchedOn), Some((State::SwitchOnDisabled, 10)));
    assert_eq!(to(State::OperationEnabled), Some((State::QuickStopActive, 11)));
    assert_eq!((to(State::SwitchOnDisabled), to(State::Fault)), (None, None), "there is nothing to stop");
}

/// A bit 7 that stays set resets one fault, not the next.
#[test]
fn b05_a_fault_is_reset_by_an_edge() {
    let reset = |before, word| actual(State::Fault, word, before, Options::default());
    assert_eq!(reset(0x00, 0x80), Some((State::SwitchOnDisabled, 15)));
    assert_eq!([reset(0x80, 0x80), reset(0x80, 0x00), reset(0x00, 0x00)], [None; 3]);
}

/// The seventeen of the standard: number, from, to, and what makes it.
const SEVENTEEN: &str = "
    0  | any                    | Not ready to switch on | power-on
    1  | Not ready to switch on | Switch on disabled     | itself
    2  | Switch on disabled     | Ready to switch on     | Shutdown
    3  | Ready to switch on     | Switched on            | Switch on
    4  | Switched on            | Operation enabled      | Enable operation
    5  | Operation enabled      | Switched on            | Switch on
    6  | Switched on            | Ready to switch on     | Shutdown
    7  | Ready to switch on     | Switch on disabled     | Quick stop, Disable voltage
    8  | Operation enabled      | Ready to switch on     | Shutdown
    9  | Operation enabled      | Switch on disabled     | Disable voltage
    10 | Switched on            | Switch on disabled     | Quick stop, Disable voltage
    11 | Operation enabled      | Quick stop active      | Quick stop
    12 | Quick stop active      | Switch on disabled     | Disable voltage, itself
    13 | any without fault      | Fault reaction active  | fault
    14 | Fault reaction active  | Fault                  | itself
    15 | Fault                  | Switch on disabled     | Fault reset
    16 | Quick stop active      | Operation enabled      | Enable operation
";

const CAUSES: [(&str, Cause); 9] = [
    ("power-on", Cause::PowerOn),
    ("itself", Cause::Done),
    ("fault", Cause::Fault),
    ("Shutdown", Cause::Command(Command::Shutdown)),
    ("Switch on", Cause::Command(Command::SwitchOn)),
    ("Enable operation", Cause::Command(Command::EnableOperation)),
    ("Disable voltage", Cause::Command(Command::DisableVoltage)),
    ("Quick stop", Cause::Command(Command::QuickStop)),
    ("Fault reset", Cause::Command(Command::FaultReset)),
];

/// Number, from, to, cause.
type Step = (u8, State, State, &'static str);

fn seventeen() -> BTreeSet<Step> {
    let mut steps = BTreeSet::new();
    for [number, from, to, causes] in rows::<4>(SEVENTEEN) {
        let number = number.parse().expect("a number");
        let from: Vec<State> = match from {
            "any" => State::ALL.to_vec(),
            "any without fault" => State::ALL[..6].to_vec(),
            name => vec![state(name)],
        };
        for cause in causes.split(", ") {
            steps.extend(from.iter().map(|from| (number, *from, state(to), cause)));
        }
    }
    steps
}

/// No transition is missing and none is invented, whatever the options are.
#[test]
fn b13_there_are_seventeen_transitions_and_no_others() {
    let mut found = BTreeSet::new();
    for (from, (word, cause), options) in State::ALL
        .iter()
        .copied()
        .flat_map(|s| CAUSES.into_iter().flat_map(move |c| OPTIONS.map(|o| (s, c, o))))
    {
        let made = Transition::of(from, cause, options);
        found.extend(made.map(|t| (t.number(), from, t.to(), word)));
    }
    assert_eq!(found, seventeen());
    assert_eq!(found.iter().map(|e| e.0).collect::<BTreeSet<u8>>(), (0..=16).collect());
}

/// Bits 0 to 3 as a level, and bit 7: the command of every word outside the state fault.
const COMMANDS: &str = "
    0 x110 | Shutdown
    0 0111 | Switch on
    0 1111 | Enable operation
    0 xx0x | Disable voltage
    0 x01x | Quick stop
";

#[test]
fn every_word_is_the_command_of_its_row() {
    let table: Vec<(Pattern, &str)> =
        rows::<2>(COMMANDS).into_iter().map(|[p, c]| (Pattern::new(p, &COLUMNS), c)).collect();
    for word in 0..=u16::MAX {
        let found: Vec<&str> = table.iter().filter(|(p, _)| p.holds(word)).map(|(_, c)| *c).collect();
        assert!(found.len() <= 1 && found.is_empty() == (word & 0x80 != 0), "{word:04X}h: {found:?}");
        let command = Controlword(word).level();
        assert_eq!(command.map(Command::word), found.first().copied(), "{word:04X}h");
        let shown = format!("{} ({word:04X}h)", found.first().unwrap_or(&"Fault reset"));
        assert_eq!(Controlword(word).to_string(), shown);
    }
}
