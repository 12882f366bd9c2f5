//! The state machine of CiA 402, as a drive runs it: at most one transition a cycle, of one sample of the controlword.

use core::time::Duration;

use crate::cia402::{Cause, Command, Controlword, Options, Reaction, State, StopOption, Transition};

/// What the power stage does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Order {
    /// It is off.
    Off,
    /// It follows the mode of operation.
    Follow,
    /// It brakes, and holds the axis at standstill.
    Stop(Reaction),
}

/// What the state machine looks at in a cycle.
#[derive(Clone, Copy, Debug)]
#[allow(clippy::struct_excessive_bools)] // Each is a line of its own at the drive.
pub(crate) struct Inputs {
    pub(crate) word: Controlword,
    pub(crate) options: StopOptions,
    /// The axis stands.
    pub(crate) standstill: bool,
    /// The main supply is on and, where the drive has such an input, torque is allowed.
    pub(crate) power: bool,
    /// An alarm was raised since the last cycle, or one is active.
    pub(crate) fault: bool,
    /// An alarm would come back at once, or no reset clears it.
    pub(crate) persists: bool,
    /// The drive does not obey the controlword.
    pub(crate) local: bool,
}

/// What the option codes say at this moment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StopOptions {
    pub(crate) quick_stop: StopOption,
    pub(crate) shutdown: StopOption,
    pub(crate) disable: StopOption,
    pub(crate) fault: StopOption,
}

/// How long things take.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Times {
    pub(crate) cycle: Duration,
    /// From power-on to switch on disabled.
    pub(crate) start_up: Duration,
    /// The longest that a quick stop or a fault reaction waits for standstill.
    pub(crate) stop: Duration,
}

/// The state machine.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Device {
    state: State,
    previous: Controlword,
    /// Time in this state.
    time: Duration,
    /// A transition that waits until the axis stands.
    leaving: Option<(Transition, Reaction)>,
}

impl Device {
    /// Control supply on: transition 0.
    pub(crate) const fn new() -> Self {
        let state = State::NotReadyToSwitchOn;
        Self { state, previous: Controlword(0), time: Duration::ZERO, leaving: None }
    }

    pub(crate) const fn state(&self) -> State {
        self.state
    }

    /// The controlword of the last cycle.
    pub(crate) const fn previous(&self) -> Controlword {
        self.previous
    }

    /// One cycle. Gives the transition that was made.
    pub(crate) fn step(&mut self, inputs: &Inputs, times: &Times) -> Option<Transition> {
        self.time = self.time.saturating_add(times.cycle);
        let previous = core::mem::replace(&mut self.previous, inputs.word);
        let transition = self.transition(inputs, previous, times);
        if let Some(transition) = transition {
            self.leaving = None;
            self.state = transition.to();
            self.time = Duration::ZERO;
        }
        transition
    }

    /// What the power stage does in the present state.
    pub(crate) fn order(&self, options: StopOptions) -> Order {
        match (self.state, self.leaving) {
            (State::OperationEnabled, Some((_, reaction))) => stop(reaction),
            (State::OperationEnabled, None) => Order::Follow,
            (State::QuickStopActive, _) => stop(options.quick_stop.reaction),
            (State::FaultReactionActive, _) => stop(options.fault.reaction),
            _ => Order::Off,
        }
    }

    fn transition(&mut self, inputs: &Inputs, previous: Controlword, times: &Times) -> Option<Transition> {
        let options =
            Options { quick_stop_stays: inputs.options.quick_stop.stays, fault_persists: inputs.persists };
        let of = |state, cause| Transition::of(state, cause, options);
        let fault = inputs.fault && self.state != State::NotReadyToSwitchOn;
        let failed = fault.then(|| of(self.state, Cause::Fault)).flatten();
        failed.or_else(|| self.done(inputs, times).then(|| of(self.state, Cause::Done)).flatten()).or_else(
            || {
                let command = self.command(inputs, previous);
                let transition = command.and_then(|command| of(self.state, Cause::Command(command)));
                self.wait(transition, inputs)
            },
        )
    }

    /// Whether the drive leaves its state by itself.
    fn done(&self, inputs: &Inputs, times: &Times) -> bool {
        let given_up = self.time >= times.stop || !inputs.power;
        let stopped =
            |option: StopOption| option.reaction == Reaction::Coast || inputs.standstill || given_up;
        match self.state {
            State::NotReadyToSwitchOn => self.time >= times.start_up,
            State::QuickStopActive => stopped(inputs.options.quick_stop),
            State::FaultReactionActive => stopped(inputs.options.fault),
            _ => false,
        }
    }

    /// The command of this sample. Without power it is to disable the voltage, in the states that need it; the drive
    /// does not obey the controlword while it is operated locally.
    fn command(&self, inputs: &Inputs, previous: Controlword) -> Option<Command> {
        let needs =
            matches!(self.state, State::SwitchedOn | State::OperationEnabled | State::QuickStopActive);
        if needs && !inputs.power {
            return Some(Command::DisableVoltage);
        }
        let command = Transition::command(self.state, inputs.word, previous).filter(|_| !inputs.local)?;
        let refused = self.state == State::ReadyToSwitchOn && command == Command::SwitchOn && !inputs.power;
        (!refused).then_some(command)
    }

    /// A transition out of operation enabled waits for standstill where its option code asks for a ramp.
    fn wait(&mut self, transition: Option<Transition>, inputs: &Inputs) -> Option<Transition> {
        let option = match transition.map(Transition::number) {
            Some(5) => inputs.options.disable,
            Some(8) => inputs.options.shutdown,
            _ => {
                self.leaving = None;
                return transition;
            }
        };
        if option.reaction == Reaction::Coast || (inputs.standstill && self.leaving.is_some()) {
            return transition;
        }
        self.leaving = transition.map(|transition| (transition, option.reaction));
        None
    }
}

const fn stop(reaction: Reaction) -> Order {
    match reaction {
        Reaction::Coast => Order::Off,
        _ => Order::Stop(reaction),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use State::*;

    const MS: Duration = Duration::from_millis(1);
    const TIMES: Times = Times { cycle: MS, start_up: MS, stop: Duration::from_millis(50) };

    fn inputs(word: u16) -> Inputs {
        let options = StopOptions {
            quick_stop: StopOption::quick_stop(2).unwrap(),
            shutdown: StopOption::disable(0).unwrap(),
            disable: StopOption::disable(1).unwrap(),
            fault: StopOption::fault(2).unwrap(),
        };
        let word = Controlword(word);
        Inputs { word, options, standstill: true, power: true, fault: false, persists: false, local: false }
    }

    /// The numbers of the transitions that these words make, one word a cycle.
    fn walk(device: &mut Device, words: &[u16]) -> std::vec::Vec<Option<u8>> {
        let step = |word| device.step(&inputs(word), &TIMES).map(Transition::number);
        words.iter().copied().map(step).collect()
    }

    fn enabled() -> Device {
        let mut device = Device::new();
        assert_eq!(walk(&mut device, &[0, 6, 7, 15]), [Some(1), Some(2), Some(3), Some(4)]);
        device
    }

    #[test]
    fn one_word_makes_one_transition() {
        let mut device = Device::new();
        assert_eq!(walk(&mut device, &[15, 15, 15]), [Some(1), None, None], "no state is skipped");
        let mut device = enabled();
        assert_eq!(walk(&mut device, &[6, 0, 0]), [Some(8), Some(7), None]);
        assert_eq!(walk(&mut enabled(), &[0, 6]), [Some(9), Some(2)]);
        assert_eq!(walk(&mut enabled(), &[2, 2, 2]), [Some(11), Some(12), None]);
        let mut device = enabled();
        assert_eq!(walk(&mut device, &[7, 7, 6, 7, 2]), [None, Some(5), Some(6), Some(3), Some(10)]);
    }

    #[test]
    fn a_ramp_is_waited_for_and_can_be_called_off() {
        let mut device = enabled();
        let moving = |word| Inputs { standstill: false, ..inputs(word) };
        assert_eq!(device.step(&moving(7), &TIMES), None);
        assert_eq!(device.order(moving(7).options), Order::Stop(Reaction::SlowDownRamp));
        assert_eq!(device.step(&moving(7), &TIMES), None);
        assert_eq!(device.step(&moving(15), &TIMES), None);
        assert_eq!(device.order(moving(15).options), Order::Follow);
        assert_eq!(device.state(), OperationEnabled);
    }

    #[test]
    fn quick_stop_stays_where_its_option_says() {
        let with = |word, code, standstill| {
            let mut inputs = inputs(word);
            inputs.options.quick_stop = StopOption::quick_stop(code).unwrap();
            Inputs { standstill, ..inputs }
        };
        let numbers = |code, words: &[(u16, bool)]| -> std::vec::Vec<Option<u8>> {
            let mut device = enabled();
            let step = |(word, still)| device.step(&with(word, code, still), &TIMES).map(Transition::number);
            words.iter().copied().map(step).collect()
        };
        assert_eq!(numbers(0, &[(2, false), (2, false)]), [Some(11), Some(12)], "it coasts");
        assert_eq!(numbers(2, &[(2, false), (2, false), (15, true)]), [Some(11), None, Some(12)]);
        assert_eq!(numbers(6, &[(2, false), (2, true), (15, true)]), [Some(11), None, Some(16)]);
        assert_eq!(numbers(6, &[(2, false), (2, true), (0, true)]), [Some(11), None, Some(12)]);
    }

    #[test]
    fn a_fault_is_reset_by_an_edge_in_fault_once_its_cause_is_gone() {
        let mut device = enabled();
        let fault = |word, standstill, persists| Inputs { fault: true, standstill, persists, ..inputs(word) };
        let mut step = |inputs: Inputs| device.step(&inputs, &TIMES).map(Transition::number);
        assert_eq!(step(fault(15, false, true)), Some(13));
        assert_eq!(step(fault(15, false, true)), None, "it brakes");
        assert_eq!(step(fault(0x80, true, true)), Some(14));
        assert_eq!(step(fault(0x80, true, false)), None, "bit 7 was set already");
        assert_eq!(step(fault(0, true, false)), None);
        assert_eq!(step(fault(0x80, true, true)), None, "the cause is there");
        assert_eq!(step(fault(0, true, false)), None);
        assert_eq!(step(fault(0x80, true, false)), Some(15));
    }

    #[test]
    fn a_stop_that_does_not_end_is_given_up() {
        let mut device = enabled();
        let moving = |word| Inputs { standstill: false, ..inputs(word) };
        assert_eq!(device.step(&moving(2), &TIMES).map(Transition::number), Some(11));
        for _ in 0..49 {
            assert_eq!(device.step(&moving(2), &TIMES), None);
        }
        assert_eq!(device.step(&moving(2), &TIMES).map(Transition::number), Some(12));
    }

    #[test]
    fn without_power_nothing_is_switched_on() {
        let mut device = Device::new();
        let off = |word| Inputs { power: false, ..inputs(word) };
        let mut step = |inputs: Inputs| device.step(&inputs, &TIMES).map(Transition::number);
        assert_eq!((step(off(0)), step(off(6)), step(off(7))), (Some(1), Some(2), None));
        assert_eq!((step(inputs(7)), step(inputs(15)), step(off(15))), (Some(3), Some(4), Some(9)));
        assert_eq!(device.state(), SwitchOnDisabled);
    }
}
