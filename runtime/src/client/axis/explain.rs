//! How errors of an axis print: what was seen, what was sent, what to do.

use core::fmt;

use super::error::{AxisError, AxisErrorKind as Kind, Doing};
use crate::cia402::{Mode, State};
use crate::client::message::{displays, Explain, Lines, Severity};

impl AxisError {
    /// What kind of message it is, in a word.
    const fn word(&self) -> &'static str {
        match (self.kind, self.doing) {
            (Kind::SeedTooFar { .. } | Kind::NoActualPosition, _) => "SEED",
            (Kind::ModeNotTaken { .. } | Kind::ModeNotSupported { .. } | Kind::WrongMode { .. }, _) => "MODE",
            (Kind::TargetJumps { .. }, _) | (_, Doing::Settle | Doing::Target) => "TARGET",
            (Kind::NoStatusword | Kind::Stale { .. }, _) => "SILENCE",
            (_, Doing::Nothing) => "TRIP",
            (_, Doing::Walk) => "STATE",
            (_, Doing::Disable) => "DISABLE",
            (_, Doing::QuickStop) => "STOP",
            (_, Doing::Enable) => "ENABLE",
            (_, Doing::Resume) => "RESUME",
            (_, Doing::Reset) => "RESET",
            (_, Doing::SelectMode) => "MODE",
            (_, Doing::Move) => "MOVE",
            (_, Doing::Home) => "HOMING",
        }
    }

    fn state(&self) -> Option<State> {
        self.statusword?.state()
    }

    /// Whether the drive says that it does not obey the controlword.
    fn is_local(&self) -> bool {
        self.statusword.is_some_and(|word| !word.is_remote())
    }
}

impl Explain for AxisError {
    fn severity(&self) -> Severity {
        Severity::Error
    }

    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }

    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.doing, self.kind)
    }

    fn details(&self, lines: &mut Lines<'_, '_>) -> fmt::Result {
        match self.statusword {
            None => lines.line("state", "not known")?,
            Some(word) => {
                lines.line("state", format_args!("{word} for {} ms", self.in_state.as_millis()))?;
                let bit = |set| i32::from(set);
                let (remote, voltage) = (bit(word.is_remote()), bit(word.voltage_enabled()));
                let (warning, limit) = (bit(word.has_warning()), bit(word.internal_limit()));
                lines.line(
                    "bits",
                    format_args!("remote = {remote}, voltage = {voltage}, warning = {warning}, internal limit = {limit}"),
                )?;
            }
        }
        lines.line("tried", format_args!("{} for {} ms", self.controlword, self.waited.as_millis()))
    }

    fn why(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.kind {
            _ if self.is_local() => "remote is 0: the drive does not obey the controlword",
            Kind::ModeNotTaken { halted: true, .. } => "halt is set, and some drives take no mode then",
            Kind::ModeNotTaken { shown: Some(Mode::NONE), .. } => "no mode of operation is selected",
            Kind::StillFaulted { .. } => "the cause is still there, or the drive needs a power cycle",
            Kind::SeedTooFar { .. } => "the axis would jump to the target when it is enabled",
            Kind::TargetJumps { .. } => "the axis would jump",
            Kind::QuickStopDoesNotStay => "605Ah takes the power away at the end of a quick stop",
            Kind::AcknowledgeStays => {
                "bit 12 stays high: the drive is busy with a set-point, or has it high from the start"
            }
            Kind::HomingNotStarted(_) => "the status bits are those of before the start",
            _ => "",
        })
    }

    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.kind {
            _ if self.is_local() => "end the operation at the panel or with the maker's tool",
            Kind::NoStatusword | Kind::Stale { .. } => "check the bus and that process data are exchanged in every cycle",
            Kind::Faulted { .. } => "read the fault, remove its cause, reset it, then try again",
            Kind::LeftOperation => "look for what takes the power away: safe torque off, main supply, a limit switch; then enable again",
            Kind::NotAGoal => "ask for a state that a command leads to",
            Kind::ModeNotTaken { halted: true, .. } => "release halt",
            Kind::ModeNotTaken { .. } => "check 6060h and that the drive has the mode; try it in another state",
            Kind::ModeNotSupported { .. } => "use one of these modes",
            Kind::WrongMode { .. } => "select the mode first",
            Kind::NotEnabled => "enable the axis first",
            Kind::NoActualPosition => "map 6064h, or let the client read it by SDO",
            Kind::SeedTooFar { .. } => "enable without a target of your own, or with one where the axis is",
            Kind::TargetJumps { .. } => "plan from where the axis is, or raise the limit",
            Kind::NotQuickStopped => "enable the axis",
            Kind::QuickStopNotKnown => "read 605Ah, or state it in the policy",
            Kind::QuickStopDoesNotStay => "enable the axis again",
            Kind::StillFaulted { .. } => "remove the cause, or switch the control supply off and on; do not loop resets",
            Kind::NotAcknowledged => "check that 607Ah and 6081h hold what the drive accepts, and its speed limits",
            Kind::AcknowledgeStays => "wait for the end of the move, replace it at once, or allow it in the policy",
            Kind::HomingNotStarted(_) => "check method, speeds and mode; some drives keep bit 12: see the policy",
            Kind::HomingFailed(_) => "check switches, method and the time-out of the drive itself; read the fault",
            Kind::HomingInterrupted => "look for what stopped it, and home again",
            Kind::HomingTooLong(_) => "give it the time that the way needs at these speeds",
            Kind::TimedOut => self.time_out_remedy(),
        })
    }
}

impl AxisError {
    fn time_out_remedy(&self) -> &'static str {
        match (self.doing, self.state()) {
            (_, Some(State::NotReadyToSwitchOn)) => "wait until the drive has started",
            (Doing::Enable, Some(State::SwitchOnDisabled | State::ReadyToSwitchOn)) => {
                "check main supply and safe torque off"
            }
            (Doing::Enable, Some(State::SwitchedOn)) => "check safe torque off, enable inputs and the brake",
            (Doing::Move | Doing::Settle, _) => "give it the time that the way needs; check limits and halt",
            _ => "",
        }
    }
}

displays! {
    [] AxisError;
}
