//! Why a goal was not reached, with what was seen and sent.

use core::fmt;
use core::time::Duration;

use super::policy::Modes;
use crate::cia402::{Controlword, HomingState, Mode, Statusword};

crate::word::words! {
    /// What an axis is after.
    Doing {
        /// Nothing: what was reached is held.
        Nothing = "holding",
        /// Another state.
        Walk = "changing the state",
        /// A motor without torque.
        Disable = "disabling",
        /// A quick stop.
        QuickStop = "quick stop",
        /// Operation.
        Enable = "enabling",
        /// Operation again, after a quick stop.
        Resume = "resuming",
        /// No fault any more.
        Reset = "fault reset",
        /// Another mode of operation.
        SelectMode = "selecting a mode",
        /// A position.
        Move = "moving",
        /// A velocity or a torque.
        Settle = "reaching the target",
        /// Home.
        Home = "homing",
        /// Another target.
        Target = "setting a target",
    }
}

/// A goal that was not reached.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct AxisError {
    /// What was tried.
    pub doing: Doing,
    /// Why it failed.
    pub kind: AxisErrorKind,
    /// The last statusword; `None` if none has come.
    pub statusword: Option<Statusword>,
    /// The last controlword.
    pub controlword: Controlword,
    /// How long it was tried.
    pub waited: Duration,
    /// For how much of that the state has not changed.
    pub in_state: Duration,
}

/// Why a goal was not reached.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum AxisErrorKind {
    /// No statusword has come at all.
    NoStatusword,
    /// The last statusword is this old.
    Stale {
        /// Its age.
        age: Duration,
    },
    /// It took too long.
    TimedOut,
    /// The drive reports a fault.
    Faulted {
        /// 603Fh, where it is known.
        code: Option<u16>,
    },
    /// The drive left operation without having been told to.
    LeftOperation,
    /// Not a state that a client can ask for.
    NotAGoal,
    /// 6061h does not show the mode that was asked for.
    ModeNotTaken {
        /// What was asked for.
        asked: Mode,
        /// What is shown, where it is known.
        shown: Option<Mode>,
        /// Whether halt was set: some drives take no mode then.
        halted: bool,
    },
    /// The drive does not have the mode.
    ModeNotSupported {
        /// What was asked for.
        asked: Mode,
        /// What there is.
        supported: Modes,
    },
    /// It needs another mode than the one that is shown.
    WrongMode {
        /// What is shown, where it is known.
        shown: Option<Mode>,
    },
    /// The axis is not in operation, or was not enabled by this client.
    NotEnabled,
    /// The actual position, 6064h, is not known: a target cannot be seeded.
    NoActualPosition,
    /// The target is too far from the actual position to enable.
    SeedTooFar {
        /// The target, user units.
        target: i32,
        /// The actual position, user units.
        actual: i32,
        /// The limit, user units.
        limit: u32,
    },
    /// A target of a cyclic mode is too far from the one before.
    TargetJumps {
        /// The one before, raw.
        from: i32,
        /// The one that was refused, raw.
        to: i32,
        /// The limit, raw.
        limit: u32,
    },
    /// There is no quick stop to come back from.
    NotQuickStopped,
    /// What 605Ah says is not known, so that a way back is not either.
    QuickStopNotKnown,
    /// 605Ah ends a quick stop without power: there is no way back but to enable.
    QuickStopDoesNotStay,
    /// The fault is still there after the reset.
    StillFaulted {
        /// 603Fh, where it is known.
        code: Option<u16>,
    },
    /// Bit 12 does not rise: the set-point was not taken.
    NotAcknowledged,
    /// Bit 12 does not fall: the drive takes no set-point now.
    AcknowledgeStays,
    /// Homing was not seen to start.
    HomingNotStarted(HomingState),
    /// The drive reports that homing failed, or reports nonsense.
    HomingFailed(HomingState),
    /// Homing ended before home was found.
    HomingInterrupted,
    /// Homing took too long; it looked like this.
    HomingTooLong(HomingState),
}

impl fmt::Display for AxisErrorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NoStatusword => f.write_str("no statusword came"),
            Self::Stale { age } => write!(f, "no statusword for {} ms", age.as_millis()),
            Self::TimedOut => f.write_str("it took too long"),
            Self::Faulted { code } => with_code(f, "the drive reports a fault", code),
            Self::LeftOperation => f.write_str("the drive left operation by itself"),
            Self::NotAGoal => f.write_str("no command leads to this state"),
            Self::ModeNotTaken { asked, shown, .. } => mode_not_taken(f, asked, shown),
            Self::ModeNotSupported { asked, supported } => {
                write!(
                    f,
                    "the drive does not have the mode {asked}; it has {supported} ({:08X}h)",
                    supported.0
                )
            }
            Self::WrongMode { shown: Some(shown) } => write!(f, "the drive is in the mode {shown}"),
            Self::WrongMode { shown: None } => f.write_str("the mode of the drive is not known"),
            Self::NotEnabled => f.write_str("the axis is not enabled"),
            Self::NoActualPosition => {
                f.write_str("the actual position, 6064h, is not known, so no target can be seeded")
            }
            Self::SeedTooFar { target, actual, limit } => {
                write!(
                    f,
                    "target {target} is too far from the actual position {actual}: the limit is {limit}"
                )
            }
            Self::TargetJumps { from, to, limit } => {
                write!(f, "the target jumps from {from} to {to}: the limit a cycle is {limit}")
            }
            Self::NotQuickStopped => f.write_str("there is no quick stop to resume from"),
            Self::QuickStopNotKnown => f.write_str("it is not known what 605Ah says"),
            Self::QuickStopDoesNotStay => {
                f.write_str("605Ah ends a quick stop without power: enable instead")
            }
            Self::StillFaulted { code } => with_code(f, "the fault is still there", code),
            Self::NotAcknowledged => f.write_str("the set-point was not acknowledged, bit 12 did not rise"),
            Self::AcknowledgeStays => f.write_str("the drive takes no set-point, bit 12 did not fall"),
            Self::HomingNotStarted(state) => write!(f, "homing did not start: {state}"),
            Self::HomingFailed(state) => write!(f, "homing failed: {state}"),
            Self::HomingInterrupted => f.write_str("homing ended before home was found"),
            Self::HomingTooLong(state) => write!(f, "homing took too long: {state}"),
        }
    }
}

fn with_code(f: &mut fmt::Formatter<'_>, what: &str, code: Option<u16>) -> fmt::Result {
    match code {
        Some(code) => write!(f, "{what}, error code {code:04X}h"),
        None => f.write_str(what),
    }
}

fn mode_not_taken(f: &mut fmt::Formatter<'_>, asked: Mode, shown: Option<Mode>) -> fmt::Result {
    match shown {
        Some(shown) => write!(f, "6061h shows {shown}, asked for {asked}"),
        None => write!(f, "6061h was not read, asked for {asked}"),
    }
}
