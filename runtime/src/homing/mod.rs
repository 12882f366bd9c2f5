//! Homing methods as programs: what an axis does until it has found home, as constants that a program can read, show,
//! simulate or compare with what it sees.
//!
//! A method has cases, told apart by the switches at the start, and where these agree by which event comes first. A case
//! is a list of steps. The rules of the language:
//!
//! - An event is a change in time: a fast move until the home switch is off, from a place where it is off, runs over the
//!   switch.
//! - A move that turns around counts events from when it moves in its own direction; one that goes on in the same
//!   direction at another speed counts them at once.
//! - [`Step::Latch`] takes the place of the last event, or after [`Step::Stop`] the place of rest. Home is what was
//!   latched; where the axis comes to rest is another matter, unless the program says [`Step::Return`].
//!
//! ```
//! use drivewright_runtime::homing::*;
//!
//! const METHOD_1: HomingDesc<'static> = HomingDesc::new(1).with_cases(&[HomingCase::new(
//!     &[Level::off(Signal::NegativeLimit)],
//!     &[
//!         Step::fast(Side::Negative, Event::on(Signal::NegativeLimit)),
//!         Step::slow(Side::Positive, Event::off(Signal::NegativeLimit)),
//!         Step::Latch,
//!     ],
//! )]);
//!
//! let case = METHOD_1.cases()[0];
//! assert_eq!(case.when().to_string(), "negative_limit off");
//! assert_eq!(
//!     case.moves().to_string(),
//!     "- fast until negative_limit on; + slow until negative_limit off; latch"
//! );
//! ```

pub mod interpreter;

mod desc;
mod text;

pub use desc::{HomingCase, HomingDesc};
pub use text::{Moves, When};

crate::word::words! {
    /// A switch that homing looks at.
    Signal {
        /// The negative limit switch.
        NegativeLimit = "negative_limit",
        /// The positive limit switch.
        PositiveLimit = "positive_limit",
        /// The home switch.
        Home = "home",
    }

    /// A direction of motion, or a side, seen from a signal.
    Side {
        /// Towards lower positions.
        Negative = "negative",
        /// Towards higher positions.
        Positive = "positive",
    }

    /// How fast a move goes.
    Pace {
        /// At the speed for the search of a switch, 6099:01.
        Fast = "fast",
        /// At the speed for the search of zero, 6099:02.
        Slow = "slow",
    }

    /// Whether a drive has a method.
    HomingStatus {
        /// It has it.
        Supported = "supported",
        /// The number is kept for later.
        Reserved = "reserved",
        /// The manual names it and says that the drive does not have it.
        NotAvailable = "not available",
    }

    /// Direction of the first move.
    HomingStart {
        /// Towards lower positions.
        Negative = "negative",
        /// Towards higher positions.
        Positive = "positive",
        /// It depends on the switch at the start.
        BySwitch = "by switch",
    }

    /// What a method looks for.
    HomingSignal {
        /// The negative limit switch.
        NegativeLimit = "negative_limit",
        /// The positive limit switch.
        PositiveLimit = "positive_limit",
        /// The home switch.
        Home = "home",
        /// The index pulse of the encoder.
        Index = "index",
        /// A hard stop.
        Stall = "stall",
        /// The place where the axis stands.
        Here = "here",
    }

    /// A change of a signal, as time goes on.
    Edge {
        /// It becomes active.
        Rising = "rising",
        /// It becomes inactive.
        Falling = "falling",
    }
}

/// What ends a move.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Event {
    /// A switch becomes active (`true`) or inactive.
    Switch(Signal, bool),
    /// The first index pulse after the move began.
    Index,
    /// The torque reaches the level of the drive for its time (`true`), or falls below it.
    Torque(bool),
    /// A hard stop: the torque at its limit and no motion, for the time of the drive.
    Stall,
}

impl Event {
    /// `signal` becomes active.
    pub const fn on(signal: Signal) -> Self {
        Self::Switch(signal, true)
    }

    /// `signal` becomes inactive.
    pub const fn off(signal: Signal) -> Self {
        Self::Switch(signal, false)
    }
}

/// A step of a homing program.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Step {
    /// Moves until something happens.
    Move {
        /// Where to.
        direction: Side,
        /// How fast.
        pace: Pace,
        /// Until when.
        until: Event,
    },
    /// Brakes and waits for standstill.
    Stop,
    /// Takes home.
    Latch,
    /// Goes back to what was latched.
    Return,
    /// The axis is at home already.
    Done,
    /// The manual does not say what follows.
    NotStated,
}

impl Step {
    /// Moves fast until something happens.
    pub const fn fast(direction: Side, until: Event) -> Self {
        Self::Move { direction, pace: Pace::Fast, until }
    }

    /// Moves slowly until something happens.
    pub const fn slow(direction: Side, until: Event) -> Self {
        Self::Move { direction, pace: Pace::Slow, until }
    }
}

/// What is seen at a moment.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Level {
    /// A switch is active (`true`) or inactive.
    Switch(Signal, bool),
    /// The axis does not move.
    Standstill,
    /// The axis stands at home.
    AtHome,
}

impl Level {
    /// `signal` is active.
    pub const fn on(signal: Signal) -> Self {
        Self::Switch(signal, true)
    }

    /// `signal` is inactive.
    pub const fn off(signal: Signal) -> Self {
        Self::Switch(signal, false)
    }
}
