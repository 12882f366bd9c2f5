//! Tables as text: columns are divided by `|`, a pattern is made of `0`, `1` and `x`.

use drivewright_runtime::cia402::State;

/// The rows of a table, each cut into its columns.
pub(crate) fn rows<const COLUMNS: usize>(text: &'static str) -> Vec<[&'static str; COLUMNS]> {
    let cut = |line: &'static str| {
        let columns: Vec<&str> = line.split('|').map(str::trim).collect();
        columns.try_into().unwrap_or_else(|c| panic!("{c:?} has not {COLUMNS} columns"))
    };
    text.lines().map(str::trim).filter(|line| !line.is_empty()).map(cut).collect()
}

/// Which bits count, and their value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Pattern {
    pub(crate) mask: u16,
    pub(crate) value: u16,
}

impl Pattern {
    /// Reads `x01x 0111`: the last place is the lowest of `bits`, which are those of the word, highest first.
    pub(crate) fn new(text: &str, bits: &[u32]) -> Self {
        let places: Vec<char> = text.chars().filter(|c| *c != ' ').collect();
        assert_eq!(places.len(), bits.len(), "{text}");
        let mut pattern = Self { mask: 0, value: 0 };
        for (place, bit) in places.iter().zip(bits) {
            match place {
                'x' => {}
                '0' => pattern.mask |= 1 << bit,
                '1' => {
                    pattern.mask |= 1 << bit;
                    pattern.value |= 1 << bit;
                }
                other => panic!("{other} in {text}"),
            }
        }
        pattern
    }

    pub(crate) fn holds(self, word: u16) -> bool {
        word & self.mask == self.value
    }
}

/// The state of a name as the manual prints it.
pub(crate) fn state(name: &str) -> State {
    match name {
        "Not ready to switch on" => State::NotReadyToSwitchOn,
        "Switch on disabled" => State::SwitchOnDisabled,
        "Ready to switch on" => State::ReadyToSwitchOn,
        "Switched on" => State::SwitchedOn,
        "Operation enabled" => State::OperationEnabled,
        "Quick stop active" => State::QuickStopActive,
        "Fault reaction active" => State::FaultReactionActive,
        "Fault" => State::Fault,
        other => panic!("{other} is no state"),
    }
}

#[test]
fn a_table_that_is_not_one_is_refused() {
    assert_eq!(Pattern::new("x1 0x", &[6, 5, 1, 0]), Pattern { mask: 0x22, value: 0x20 });
    assert!(Pattern::new("x1 0x", &[6, 5, 1, 0]).holds(0xFFFD) && !Pattern::new("x1", &[1, 0]).holds(2));
    let panics = |f: fn()| std::panic::catch_unwind(f).is_err();
    assert!(panics(|| _ = Pattern::new("x2", &[1, 0])) && panics(|| _ = Pattern::new("x", &[1, 0])));
    assert!(panics(|| _ = rows::<2>("a | b | c")) && panics(|| _ = state("Switched off")));
}
