//! What a homing run tells: what to do, and why it cannot go on.

use crate::homing::{HomingStatus, Pace, Side};

/// What the axis has to do.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Command {
    /// Move until an [event](super::Run::event) changes the command; an axis that moves the other way turns.
    Move {
        /// Where to.
        direction: Side,
        /// How fast.
        pace: Pace,
    },
    /// Brake, then report the [standstill](super::Run::standstill).
    Brake,
    /// Go back to this place, then report the [standstill](super::Run::standstill).
    Return {
        /// What was latched.
        to: i64,
    },
    /// The program is through and the axis stands.
    Finished {
        /// Where home is; `None` where the axis was at home already.
        home: Option<i64>,
    },
    /// The program cannot go on; the axis may still move.
    Failed(Failure),
}

/// Why a program cannot go on. Cases are counted from 1, in the order of the table; so are steps.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Failure {
    /// The manual does not say what follows.
    NotStated {
        /// The case.
        case: u8,
        /// The step that is not stated.
        step: u16,
    },
    /// What ends the case with an error was seen.
    Aborted {
        /// The case.
        case: u8,
    },
    /// Two cases that no event has told apart go on in different ways.
    Parted {
        /// One case.
        case: u8,
        /// The other.
        other: u8,
        /// The step in which they differ.
        step: u16,
    },
}

impl core::fmt::Display for Failure {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::NotStated { case, step } => {
                write!(f, "the manual does not say what follows: case {case}, step {step}")
            }
            Self::Aborted { case } => write!(f, "case {case} has met what ends it with an error"),
            Self::Parted { case, other, step } => {
                write!(f, "nothing tells cases {case} and {other} apart at step {step}")
            }
        }
    }
}

impl core::error::Error for Failure {}

/// Why a method cannot start.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum StartError {
    /// The drive does not have the method.
    NotThere(HomingStatus),
    /// It is the same as another one: start that, as [`DriveModel::homing`](crate::DriveModel::homing) gives it.
    SameAs(i8),
    /// No case holds for what is seen; a method without cases has none.
    NoCase,
    /// The method has more cases than the 32 that can be followed.
    TooManyCases,
}

impl core::fmt::Display for StartError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::NotThere(status) => write!(f, "the drive does not have this homing method: {status}"),
            Self::SameAs(number) => write!(f, "this homing method is the same as method {number}"),
            Self::NoCase => f.write_str("no case of the homing method holds for what the switches say"),
            Self::TooManyCases => f.write_str("the homing method has more than 32 cases"),
        }
    }
}

impl core::error::Error for StartError {}
