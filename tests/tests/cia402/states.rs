//! Every statusword shows one state, or none.

use drivewright_runtime::cia402::{State, Statusword};

use super::table::{Pattern, rows, state};

/// SDV3-E manual, 4.1.3, the table of values; those of the standard are the same.
const STATES: &str = "
    xxxx xxxx x0xx 0000 | Not ready to switch on
    xxxx xxxx x1xx 0000 | Switch on disabled
    xxxx xxxx x01x 0001 | Ready to switch on
    xxxx xxxx x01x 0011 | Switched on
    xxxx xxxx x01x 0111 | Operation enabled
    xxxx xxxx x00x 0111 | Quick stop active
    xxxx xxxx x0xx 1111 | Fault reaction active
    xxxx xxxx x0xx 1000 | Fault
";

/// Torque may be on the motor; a fault is handled or waits.
const POWER: &str = "
    Not ready to switch on | no  | no
    Switch on disabled     | no  | no
    Ready to switch on     | no  | no
    Switched on            | no  | no
    Operation enabled      | yes | no
    Quick stop active      | yes | no
    Fault reaction active  | yes | yes
    Fault                  | no  | yes
";

fn table() -> Vec<(Pattern, State)> {
    let bits: Vec<u32> = (0..16).rev().collect();
    rows::<2>(STATES).into_iter().map(|[p, name]| (Pattern::new(p, &bits), state(name))).collect()
}

/// How many words have no row: in four rows five bits count, so that each has 2^11 words; in four rows six bits do.
const NO_STATE: usize = 65_536 - 4 * 2_048 - 4 * 1_024;

#[test]
fn every_word_shows_the_state_of_its_row() {
    let (table, mut none) = (table(), 0);
    assert_eq!(table.len(), State::ALL.len());
    for word in 0..=u16::MAX {
        let found: Vec<State> = table.iter().filter(|(p, _)| p.holds(word)).map(|(_, s)| *s).collect();
        assert!(found.len() <= 1, "{word:04X}h has {found:?}");
        assert_eq!(Statusword(word).state(), found.first().copied(), "{word:04X}h");
        none += usize::from(found.is_empty());
    }
    assert_eq!(none, NO_STATE);
}

/// What a virtual drive sends is the value under the mask: both must be those of the table.
#[test]
fn every_state_is_sent_as_its_row() {
    for (pattern, state) in table() {
        assert_eq!(state.pattern(), (pattern.mask, pattern.value), "{state}");
        assert_eq!(Statusword(state.pattern().1).state(), Some(state));
    }
}

#[test]
fn every_state_has_its_name_and_its_power() {
    for ([name, power, fault], listed) in rows::<3>(POWER).into_iter().zip(State::ALL.iter().copied()) {
        let state = state(name);
        assert_eq!((state, state.word()), (listed, name));
        assert_eq!((state.is_powered(), state.is_fault()), (power == "yes", fault == "yes"), "{name}");
    }
}

#[test]
fn every_word_is_shown_with_its_number() {
    for word in 0..=u16::MAX {
        let shown = Statusword(word).to_string();
        assert!(shown.ends_with(&format!(" ({word:04X}h)")), "{shown}");
        let name = shown.split(" (").next().expect("it has a name");
        assert_eq!(name == "no state of CiA 402", Statusword(word).state().is_none(), "{shown}");
    }
}
