//! The cyclic machine of CiA 402, seen from the client: a sample in, outputs out, once a cycle.
//!
//! It is the only writer of the controlword. A program starts a goal, calls [`Axis::cycle`] every cycle, and asks
//! [`Axis::progress`] whether the goal is reached. It does no input or output and owns no clock.

mod enable;
mod error;
mod explain;
mod home;
mod io;
mod policy;
mod request;
mod reset;
mod set_point;
mod stop;
mod target;
mod walk;

use core::time::Duration;

use crate::cia402::{Command, Controlword, Mode, State, Statusword};
use crate::time::Instant;

pub use error::{AxisError, AxisErrorKind, Doing};
pub use io::{Feedback, Outputs, Sample};
pub use policy::{AxisPolicy, Modes, StepLimits};
pub use request::Request;
pub use set_point::SetPoint;

use home::HomePhase;
use io::View;
use reset::ResetPhase;
use set_point::MovePhase;
use target::Commanded;

/// How far a goal is.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[must_use]
pub enum Progress {
    /// Not there yet: call [`Axis::cycle`] again.
    Pending,
    /// Reached; or nothing was asked for.
    Done,
    /// It will not be reached.
    Failed(AxisError),
}

/// What is being pursued.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
enum Goal {
    Nothing,
    Reach(State),
    Disable,
    QuickStop,
    Enable(Mode),
    Resume,
    Reset(ResetPhase),
    SelectMode,
    Move(SetPoint, MovePhase),
    Settle,
    Home(HomePhase),
}

impl Goal {
    const fn doing(self) -> Doing {
        match self {
            Self::Nothing => Doing::Nothing,
            Self::Reach(_) => Doing::Walk,
            Self::Disable => Doing::Disable,
            Self::QuickStop => Doing::QuickStop,
            Self::Enable(_) => Doing::Enable,
            Self::Resume => Doing::Resume,
            Self::Reset(_) => Doing::Reset,
            Self::SelectMode => Doing::SelectMode,
            Self::Move(..) => Doing::Move,
            Self::Settle => Doing::Settle,
            Self::Home(_) => Doing::Home,
        }
    }
}

/// An axis as its client sees it.
///
/// ```
/// use core::time::Duration;
/// use drivewright_runtime::cia402::{Mode, Statusword};
/// use drivewright_runtime::client::axis::{Axis, AxisPolicy, Progress, Sample};
///
/// let mut axis = Axis::new(AxisPolicy::default());
/// axis.enable(Mode::PROFILE_VELOCITY);
/// let cycle = Duration::from_millis(1);
/// let mut sample = Sample { mode: Some(Mode::PROFILE_VELOCITY), ..Sample::default() };
/// // Switch on disabled, ready to switch on, switched on: the controlword leads on.
/// for (statusword, controlword) in [(0x0240, 0x06), (0x0221, 0x07), (0x0233, 0x0F)] {
///     sample.statusword = Statusword(statusword);
///     assert_eq!(axis.step(cycle, Some(sample)).controlword.0, controlword);
///     assert_eq!(axis.progress(), Progress::Pending);
/// }
/// sample.statusword = Statusword(0x0237);
/// axis.step(cycle, Some(sample));
/// assert_eq!(axis.progress(), Progress::Done);
/// ```
///
/// Two axes that compare equal behave alike from here on, for [`step`](Self::step) keeps no moments, only spans that come to
/// rest: a search over all that can happen ends.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
#[allow(clippy::struct_excessive_bools)] // Each is a fact of its own.
pub struct Axis {
    policy: AxisPolicy,
    /// The moment of the last [`cycle`](Self::cycle); `None` for who calls [`step`](Self::step).
    last: Option<Instant>,
    view: View,
    out: Outputs,
    /// What the last cycle gave: targets that come until the next one are measured from it.
    base: Outputs,
    /// The command that goes out.
    level: Command,
    /// Samples that came since `level` is what it is, as far as they matter.
    level_samples: u8,
    /// Bits 4 to 6, 8 and up of the controlword.
    bits: u16,
    mode: Option<Mode>,
    commanded: Commanded,
    /// A target position has been where the axis is.
    seeded: bool,
    /// Operation was reached and has not been left on purpose.
    enabled: bool,
    homed: bool,
    goal: Goal,
    progress: Progress,
    within: Duration,
    /// The goal has not seen a cycle yet: the time before it does not count.
    begins: bool,
    /// A sample has come since it began.
    informed: bool,
    waited: Duration,
    in_state: Duration,
    phase: Duration,
    phase_samples: u8,
    trip: Option<AxisError>,
}

impl Axis {
    /// An axis of which nothing is known. Until a goal says otherwise it puts out disable voltage and the mode that the
    /// drive shows.
    pub fn new(policy: AxisPolicy) -> Self {
        Self {
            policy,
            last: None,
            view: View::default(),
            out: Outputs::default(),
            base: Outputs::default(),
            level: Command::DisableVoltage,
            level_samples: u8::MAX,
            bits: 0,
            mode: None,
            commanded: Commanded::default(),
            seeded: false,
            enabled: false,
            homed: false,
            goal: Goal::Nothing,
            progress: Progress::Done,
            within: Duration::ZERO,
            begins: false,
            informed: false,
            waited: Duration::ZERO,
            in_state: Duration::ZERO,
            phase: Duration::ZERO,
            phase_samples: 0,
            trip: None,
        }
    }

    /// One cycle: takes what came in, if something did, and gives what goes out next. `now` is on any clock that runs.
    pub fn cycle(&mut self, now: Instant, sample: Option<Sample>) -> Outputs {
        let elapsed = self.last.map_or(Duration::ZERO, |last| now.since(last));
        self.last = Some(now);
        self.step(elapsed, sample)
    }

    /// One cycle, `elapsed` after the one before.
    pub fn step(&mut self, elapsed: Duration, sample: Option<Sample>) -> Outputs {
        self.observe(elapsed, sample);
        self.watch();
        self.pursue();
        self.compose();
        self.base = self.out;
        self.out
    }

    /// How far the last goal is.
    pub const fn progress(&self) -> Progress {
        self.progress
    }

    /// What is known of the state of the drive.
    pub fn feedback(&self) -> Feedback {
        self.view.feedback()
    }

    /// The last sample; `None` if none has come.
    pub const fn sample(&self) -> Option<Sample> {
        self.view.sample
    }

    /// What goes out, with what was set since the last cycle.
    pub const fn outputs(&self) -> Outputs {
        self.out
    }

    /// The times, quirks and limits in use.
    pub const fn policy(&self) -> &AxisPolicy {
        &self.policy
    }

    /// The same, to be changed: by what has been read from the drive.
    pub fn policy_mut(&mut self) -> &mut AxisPolicy {
        &mut self.policy
    }

    /// Whether operation was reached and has not been left.
    pub const fn is_enabled(&self) -> bool {
        self.enabled
    }

    /// Whether a homing of this client has found home. It does not know what the drive forgets when it is switched off.
    pub const fn is_homed(&self) -> bool {
        self.homed
    }

    /// Why the axis is not in operation any more, where nobody asked it to leave; until the next goal.
    pub const fn trip(&self) -> Option<AxisError> {
        self.trip
    }

    /// That the axis is in operation, brought there by this client.
    ///
    /// # Errors
    /// [`AxisErrorKind::NotEnabled`], [`AxisErrorKind::Faulted`].
    pub fn need_operation(&self) -> Result<(), AxisError> {
        self.in_operation().map_err(|kind| self.error(kind))
    }

    /// Whether a set-point has been given in profile position mode.
    pub const fn has_set_point(&self) -> bool {
        self.commanded.position.is_some()
    }

    /// Whether the drive decides where the axis is: everywhere but in operation in cyclic synchronous position mode. A
    /// master that plans positions must follow the actual one as long.
    pub fn position_is_owned_by_drive(&self) -> bool {
        !self.follows(Mode::CYCLIC_POSITION)
    }

    /// Sets or releases halt, bit 8 of the controlword. What it does is up to the mode and to 605Dh.
    pub fn halt(&mut self, on: bool) {
        self.set_bit(Controlword::HALT, on);
        self.compose();
    }

    /// Sets the bits of the controlword that are the maker's: 10 to 15. Others are ignored.
    pub fn set_maker_bits(&mut self, bits: u16) {
        self.bits = self.bits & !MAKER_BITS | bits & MAKER_BITS;
        self.compose();
    }
}

/// Bits of the controlword that belong to the maker, bit 10 included, which the standard reserves.
const MAKER_BITS: u16 = 0xFC00;
/// Bits of the controlword that mean something else in every mode.
const MODE_BITS: u16 = Controlword::MODE_4 | Controlword::MODE_5 | Controlword::MODE_6 | Controlword::MODE_9;

/// What a goal says of a cycle: whether it is reached.
type Verdict = Result<bool, AxisErrorKind>;

impl Axis {
    fn begin(&mut self, goal: Goal, within: Duration) {
        self.end_edges();
        if self.level == Command::EnableOperation && !self.enabled && !matches!(goal, Goal::Enable(_)) {
            // Who asks for something else has given up the way to operation.
            self.let_go();
        }
        self.enter(goal);
        self.within = within;
        (self.begins, self.informed) = (true, false);
        (self.waited, self.in_state) = (Duration::ZERO, Duration::ZERO);
        self.progress = Progress::Pending;
        self.trip = None;
        self.view.touch();
        self.compose();
    }

    /// The next phase of a goal.
    fn enter(&mut self, goal: Goal) {
        self.goal = goal;
        self.phase = Duration::ZERO;
        self.phase_samples = 0;
    }

    fn observe(&mut self, elapsed: Duration, sample: Option<Sample>) {
        let before = self.view.state();
        self.view.take(if self.begins { Duration::ZERO } else { elapsed }, sample, self.policy.stale_after);
        if self.progress == Progress::Pending {
            let elapsed = if self.begins { Duration::ZERO } else { elapsed };
            let same = self.view.state() == before;
            self.waited = self.waited.saturating_add(elapsed);
            self.in_state = if same { self.in_state.saturating_add(elapsed) } else { Duration::ZERO };
            self.phase = self.phase.saturating_add(elapsed);
        }
        self.begins = false;
        self.informed |= sample.is_some();
        if sample.is_some() {
            let most = self.policy.latency.saturating_add(1);
            self.level_samples = self.level_samples.saturating_add(1).min(most);
            self.phase_samples = self.phase_samples.saturating_add(1).min(most.max(2));
        }
    }

    /// That what was reached is still there.
    fn watch(&mut self) {
        if !self.enabled {
            return;
        }
        let why = match self.view.feedback() {
            Feedback::State(State::OperationEnabled) => return,
            Feedback::Stale(_) => AxisErrorKind::Stale { age: self.view.age() },
            _ => self.not_faulted().err().unwrap_or(AxisErrorKind::LeftOperation),
        };
        let error = self.error(why);
        self.let_go();
        self.trip = Some(error);
        // A fault is what a reset is for.
        if self.progress == Progress::Pending && !matches!(self.goal, Goal::Reset(_)) {
            self.progress = Progress::Failed(error);
        }
    }

    fn pursue(&mut self) {
        if self.progress != Progress::Pending {
            return;
        }
        let verdict = match (self.view.feedback(), self.view.word()) {
            (Feedback::Stale(_), _) => Err(AxisErrorKind::Stale { age: self.view.age() }),
            (_, Some(word)) if self.informed => self.advance(word),
            _ => Ok(false),
        };
        match verdict {
            Ok(true) => self.finish(Progress::Done),
            Ok(false) if self.waited < self.within => (),
            Ok(false) => self.fail(self.overdue()),
            Err(kind) => self.fail(kind),
        }
    }

    fn advance(&mut self, word: Statusword) -> Verdict {
        match self.goal {
            Goal::Nothing => Ok(true),
            Goal::Reach(goal) => self.advance_reach(goal),
            Goal::Disable => Ok(self.advance_disable()),
            Goal::QuickStop => Ok(self.quick_stop_is_done()),
            Goal::Enable(mode) => self.advance_enable(mode),
            Goal::Resume => self.advance_resume(),
            Goal::Reset(phase) => self.advance_reset(phase),
            Goal::SelectMode => Ok(self.mode_is_taken()),
            Goal::Move(set_point, phase) => self.advance_move(set_point, phase, word),
            Goal::Settle => Ok(self.is_fresh() && word.target_reached()),
            Goal::Home(phase) => self.advance_home(phase, word),
        }
    }

    /// Why a goal that does not fail by itself has not been reached.
    fn overdue(&self) -> AxisErrorKind {
        let Some(word) = self.view.word() else { return AxisErrorKind::NoStatusword };
        match self.goal {
            Goal::Enable(_) | Goal::SelectMode if self.mode.is_some() && self.view.mode() != self.mode => {
                self.mode_not_taken()
            }
            Goal::Reset(_) => AxisErrorKind::StillFaulted { code: self.error_code() },
            Goal::Move(_, phase) => phase.overdue(),
            Goal::Home(phase) => phase.overdue(word),
            _ => AxisErrorKind::TimedOut,
        }
    }

    fn fail(&mut self, kind: AxisErrorKind) {
        let error = self.error(kind);
        match self.goal {
            Goal::Enable(_) => self.let_go(),
            Goal::Resume if !self.enabled => self.let_go(),
            // A stop that does not end by itself, for example: the motor is to be without torque.
            Goal::Disable => self.set_level(Command::DisableVoltage),
            // A mode that was not taken now is not to be taken at any time later.
            Goal::SelectMode => self.mode = self.view.mode().or(self.mode),
            _ => (),
        }
        self.finish(Progress::Failed(error));
    }

    /// Fails before anything was changed.
    fn refuse(&mut self, kind: AxisErrorKind) {
        self.finish(Progress::Failed(self.error(kind)));
    }

    fn finish(&mut self, progress: Progress) {
        self.end_edges();
        self.progress = progress;
    }

    /// Bits that rise for a goal fall with it, however it ends.
    fn end_edges(&mut self) {
        if matches!(self.goal, Goal::Move(..) | Goal::Home(_)) {
            self.set_bit(Controlword::MODE_4, false);
        }
        if self.level == Command::FaultReset {
            self.set_level(Command::DisableVoltage);
        }
    }

    /// Ends operation on the side of the client. What takes power away already is kept.
    fn let_go(&mut self) {
        self.enabled = false;
        self.drop_commands();
        if !matches!(self.level, Command::DisableVoltage | Command::QuickStop) {
            self.set_level(self.policy.safe_command);
        }
    }

    /// Nothing moves any more by what was commanded.
    fn drop_commands(&mut self) {
        self.commanded = Commanded::default();
        self.bits &= !MODE_BITS;
    }

    fn compose(&mut self) {
        self.out.controlword = Controlword::new(self.level).with_mode_bits(self.bits);
        self.out.mode = self.mode.or(self.view.mode()).unwrap_or(self.out.mode);
        self.out.position = self.target_position_out();
        (self.out.velocity, self.out.torque) = self.speeds_out();
    }

    fn set_level(&mut self, command: Command) {
        if command != self.level {
            self.level = command;
            self.level_samples = 0;
        }
    }

    fn set_bit(&mut self, bit: u16, on: bool) {
        self.bits = if on { self.bits | bit } else { self.bits & !bit };
    }

    /// Whether samples show what the present phase has sent.
    fn is_fresh(&self) -> bool {
        self.phase_samples > self.policy.latency
    }

    /// Whether samples show what the present command does.
    fn level_has_arrived(&self) -> bool {
        self.level_samples > self.policy.latency
    }

    /// Whether the axis is in operation and in this mode, for all that is known.
    fn follows(&self, mode: Mode) -> bool {
        self.enabled
            && self.view.state() == Some(State::OperationEnabled)
            && self.view.mode() == Some(mode)
            && self.mode == Some(mode)
    }

    fn not_faulted(&self) -> Result<(), AxisErrorKind> {
        match self.view.state() {
            Some(state) if state.is_fault() => Err(AxisErrorKind::Faulted { code: self.error_code() }),
            _ => Ok(()),
        }
    }

    fn error_code(&self) -> Option<u16> {
        self.view.sample?.error_code
    }

    fn error(&self, kind: AxisErrorKind) -> AxisError {
        AxisError {
            doing: if self.progress == Progress::Pending { self.goal.doing() } else { Doing::Nothing },
            kind,
            statusword: self.view.word(),
            controlword: self.out.controlword,
            waited: self.waited,
            in_state: self.in_state,
        }
    }
}
