//! A drive of a few lines: it follows the seventeen transitions and does what a test tells it to do wrong.

use core::time::Duration;

use drivewright_runtime::cia402::{
    Cause, Command, Controlword, Mode, ModeBits, Options, State, Statusword, Transition,
};
use drivewright_runtime::client::axis::{Axis, Outputs, Progress, Sample};

/// The cycle of every test.
pub(crate) const CYCLE: Duration = Duration::from_millis(1);
/// More cycles than any goal of these tests may take.
pub(crate) const PATIENCE: usize = 20_000;

/// What does not work, or works otherwise.
#[derive(Clone, Copy, Default)]
#[allow(clippy::struct_excessive_bools)] // Each is a quirk of its own.
pub(crate) struct Quirks {
    /// The state does not change any more.
    pub(crate) stuck: bool,
    /// No mode is taken.
    pub(crate) refuses_modes: bool,
    /// A mode is taken in operation only.
    pub(crate) mode_in_operation_only: bool,
    /// No mode is taken while halt is set.
    pub(crate) halt_blocks_modes: bool,
    /// A set-point is never acknowledged.
    pub(crate) never_acknowledges: bool,
    /// Bit 12 is high in profile position mode until the first set-point.
    pub(crate) acknowledge_is_high: bool,
    /// Bit 12 never falls again.
    pub(crate) acknowledge_stays: bool,
    /// Nothing comes: process data is lost.
    pub(crate) silent: bool,
    /// A fault stays when it is reset.
    pub(crate) fault_persists: bool,
    /// The shortest level of bit 7 that counts, in cycles.
    pub(crate) reset_level: u32,
    /// Homing does not start.
    pub(crate) ignores_homing: bool,
    /// Homing leaves bit 12 as it is until it has found home.
    pub(crate) keeps_attained: bool,
    /// Homing fails, at standstill.
    pub(crate) homing_fails: bool,
    /// Homing never ends.
    pub(crate) homes_for_ever: bool,
    /// Homing takes this many cycles; 0: it is done at once.
    pub(crate) homing_cycles: u32,
}

/// The drive. Bits 10, 12 and 13 are kept apart and put into the statusword by mode.
pub(crate) struct Fake {
    pub(crate) quirks: Quirks,
    pub(crate) state: State,
    pub(crate) options: Options,
    pub(crate) mode: Mode,
    /// A quick stop is at its end in the cycle in which it begins.
    pub(crate) ends_quick_stop_at_once: bool,
    pub(crate) position: i32,
    pub(crate) error_code: u16,
    pub(crate) bits: u16,
    /// What it was told, every cycle.
    pub(crate) heard: Vec<Outputs>,
    /// Every transition, by number.
    pub(crate) transitions: Vec<u8>,
    previous: Controlword,
    level_cycles: u32,
    previous_level: u32,
    homing: Option<u32>,
}

impl Fake {
    pub(crate) fn new(state: State) -> Self {
        Self {
            quirks: Quirks { homing_cycles: 50, ..Quirks::default() },
            state,
            options: Options::default(),
            mode: Mode::NONE,
            ends_quick_stop_at_once: false,
            position: 0,
            error_code: 0,
            bits: 0,
            heard: Vec::new(),
            transitions: Vec::new(),
            previous: Controlword(0),
            level_cycles: 1_000,
            previous_level: 0,
            homing: None,
        }
    }

    pub(crate) fn with(mut self, change: impl FnOnce(&mut Quirks)) -> Self {
        change(&mut self.quirks);
        self
    }

    /// Goes into a fault, at once.
    pub(crate) fn fault(&mut self, code: u16) {
        (self.state, self.error_code) = (State::Fault, code);
    }

    pub(crate) fn statusword(&self) -> Statusword {
        Statusword(self.state.pattern().1 | Statusword::REMOTE | Statusword::VOLTAGE_ENABLED | self.bits)
    }

    pub(crate) fn sample(&self) -> Sample {
        Sample {
            mode: Some(self.mode),
            position: Some(self.position),
            error_code: Some(self.error_code),
            ..Sample::new(self.statusword())
        }
    }

    /// One cycle: what was put out, and what comes back.
    pub(crate) fn cycle(&mut self, outputs: Outputs) -> Option<Sample> {
        self.heard.push(outputs);
        let word = outputs.controlword;
        self.count_level(word);
        self.take_mode(outputs);
        if !self.quirks.stuck {
            self.obey(word);
        }
        if self.state == State::OperationEnabled {
            self.operate(outputs);
        }
        self.previous = word;
        (!self.quirks.silent).then(|| self.sample())
    }

    fn count_level(&mut self, word: Controlword) {
        if word.fault_reset() == self.previous.fault_reset() {
            self.level_cycles += 1;
        } else {
            (self.previous_level, self.level_cycles) = (self.level_cycles, 1);
        }
    }

    fn take_mode(&mut self, outputs: Outputs) {
        let blocked = self.quirks.halt_blocks_modes && outputs.controlword.halt();
        let early = self.quirks.mode_in_operation_only && self.state != State::OperationEnabled;
        if !self.quirks.refuses_modes && !blocked && !early && self.mode != outputs.mode {
            (self.mode, self.bits) = (outputs.mode, 0);
            if self.quirks.acknowledge_is_high && self.mode == Mode::PROFILE_POSITION {
                self.bits = ModeBits::SET_POINT_ACKNOWLEDGE;
            }
        }
    }

    fn obey(&mut self, word: Controlword) {
        let mut command = Transition::command(self.state, word, self.previous);
        if self.state == State::Fault && self.quirks.reset_level > 1 {
            // The edge counts when it has been held, and was low as long before.
            let held = word.fault_reset() && self.level_cycles == self.quirks.reset_level;
            command = (held && self.previous_level >= self.quirks.reset_level).then_some(Command::FaultReset);
        }
        if self.state == State::QuickStopActive && self.ends_quick_stop_at_once {
            self.state = State::SwitchOnDisabled;
        }
        let options = Options { fault_persists: self.quirks.fault_persists, ..self.options };
        if let Some(made) = command.and_then(|c| Transition::of(self.state, Cause::Command(c), options)) {
            (self.state, self.error_code) = (made.to(), 0);
            self.transitions.push(made.number());
        }
    }

    fn operate(&mut self, outputs: Outputs) {
        match self.mode {
            Mode::PROFILE_POSITION => self.profile_position(outputs),
            Mode::HOMING => self.home(outputs.controlword),
            Mode::CYCLIC_POSITION => self.position = outputs.position,
            Mode::PROFILE_VELOCITY => self.bits = Statusword::TARGET_REACHED,
            _ => (),
        }
    }

    fn profile_position(&mut self, outputs: Outputs) {
        let (word, rising) = (outputs.controlword, !self.previous.mode_4());
        if word.mode_4() && rising && !self.quirks.never_acknowledges {
            self.bits = ModeBits::SET_POINT_ACKNOWLEDGE;
            self.position = if word.mode_6() { self.position + outputs.position } else { outputs.position };
        } else if !word.mode_4() && self.previous.mode_4() && !self.quirks.acknowledge_stays {
            self.bits &= !ModeBits::SET_POINT_ACKNOWLEDGE;
        } else if !word.mode_4() {
            self.bits |= Statusword::TARGET_REACHED;
        }
    }

    fn home(&mut self, word: Controlword) {
        if word.mode_4() && !self.previous.mode_4() && !self.quirks.ignores_homing {
            self.homing = Some(self.quirks.homing_cycles);
            if !self.quirks.keeps_attained {
                self.bits = 0;
            }
        }
        match self.homing {
            Some(0) => {
                self.homing = None;
                let result =
                    if self.quirks.homing_fails { ModeBits::HOMING_ERROR } else { ModeBits::HOMING_ATTAINED };
                self.bits = result | Statusword::TARGET_REACHED;
            }
            Some(left) if !self.quirks.homes_for_ever => self.homing = Some(left - 1),
            _ => (),
        }
    }
}

/// Cycles until the goal is reached or has failed.
pub(crate) fn run(axis: &mut Axis, fake: &mut Fake) -> Progress {
    let mut sample = None;
    for _ in 0..PATIENCE {
        let outputs = axis.step(CYCLE, sample);
        if axis.progress() != Progress::Pending {
            return axis.progress();
        }
        sample = fake.cycle(outputs);
    }
    panic!("neither reached nor failed in {PATIENCE} cycles: {axis:?}");
}

/// Cycles without asking for the progress.
pub(crate) fn cycles(axis: &mut Axis, fake: &mut Fake, n: usize) {
    let mut sample = (!fake.quirks.silent && n > 0).then(|| fake.sample());
    for _ in 0..n {
        let outputs = axis.step(CYCLE, sample);
        sample = fake.cycle(outputs);
    }
}
