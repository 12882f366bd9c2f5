//! From any state to any state, one command at a time.

use crate::cia402::{Command, State, StopOption};

/// The command that leads from `state` towards `goal`; `None` where the drive must come along by itself.
///
/// Transition 16 is not part of any walk: the way out of a quick stop is the way down. A quick stop that ends by itself is
/// not cut short, but by who asks for no voltage.
pub(super) fn toward(state: State, goal: State, quick_stop: Option<StopOption>) -> Option<Command> {
    use State::{OperationEnabled, QuickStopActive, ReadyToSwitchOn, SwitchOnDisabled, SwitchedOn};
    match (state, goal) {
        (State::NotReadyToSwitchOn | State::FaultReactionActive | State::Fault, _) => None,
        (_, SwitchOnDisabled) => Some(Command::DisableVoltage),
        (QuickStopActive, _) if quick_stop.is_some_and(|option| !option.stays) => None,
        (QuickStopActive, _) => Some(Command::DisableVoltage),
        (SwitchOnDisabled, _) | (_, ReadyToSwitchOn) => Some(Command::Shutdown),
        (ReadyToSwitchOn, _) | (_, SwitchedOn) => Some(Command::SwitchOn),
        (SwitchedOn | OperationEnabled, _) => Some(Command::EnableOperation),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cia402::{Cause, Options, Transition};

    const GOALS: [State; 4] =
        [State::SwitchOnDisabled, State::ReadyToSwitchOn, State::SwitchedOn, State::OperationEnabled];

    /// The numbers of the transitions of a walk.
    fn walk(mut state: State, goal: State, quick_stop: Option<StopOption>) -> std::vec::Vec<u8> {
        let options =
            Options { quick_stop_stays: quick_stop.is_some_and(|o| o.stays), fault_persists: false };
        let mut numbers = std::vec::Vec::new();
        while state != goal {
            let cause = toward(state, goal, quick_stop).map_or(Cause::Done, Cause::Command);
            let transition = Transition::of(state, cause, options).expect("a walk does not stand still");
            numbers.push(transition.number());
            state = transition.to();
            assert!(numbers.len() < 6, "{numbers:?}");
        }
        numbers
    }

    #[test]
    fn every_walk_is_the_shortest_that_the_standard_has() {
        use State as S;
        let ways = |state| GOALS.map(|goal| walk(state, goal, None));
        assert_eq!(ways(S::SwitchOnDisabled), [&[][..], &[2], &[2, 3], &[2, 3, 4]]);
        assert_eq!(ways(S::ReadyToSwitchOn), [&[7][..], &[], &[3], &[3, 4]]);
        assert_eq!(ways(S::SwitchedOn), [&[10][..], &[6], &[], &[4]]);
        assert_eq!(ways(S::OperationEnabled), [&[9][..], &[8], &[5], &[]]);
        assert_eq!(ways(S::QuickStopActive), [&[12][..], &[12, 2], &[12, 2, 3], &[12, 2, 3, 4]]);
    }

    #[test]
    fn a_held_command_keeps_the_state_that_was_reached() {
        for goal in GOALS {
            let command = toward(goal, goal, None).unwrap();
            assert_eq!(Transition::of(goal, Cause::Command(command), Options::default()), None, "{goal}");
        }
    }

    #[test]
    fn transition_16_is_on_no_walk() {
        for code in 0..=8 {
            let option = StopOption::quick_stop(code);
            let first = toward(State::QuickStopActive, State::OperationEnabled, option);
            assert_eq!(first, (code > 4).then_some(Command::DisableVoltage), "605Ah = {code}");
        }
    }
}
