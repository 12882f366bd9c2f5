//! What a homing run is told: levels of switches, and crossings.

use crate::homing::{Event, Level, Side, Signal};

/// What is seen at a moment.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
// Each is a line of its own at the drive.
#[allow(clippy::struct_excessive_bools)]
pub struct Levels {
    /// The negative limit switch is active.
    pub negative_limit: bool,
    /// The positive limit switch is active.
    pub positive_limit: bool,
    /// The home switch is active.
    pub home: bool,
    /// The axis does not move.
    pub standstill: bool,
    /// The axis stands at home, as an earlier homing has found it.
    pub at_home: bool,
}

impl Levels {
    /// Whether a switch is active.
    pub const fn switch(self, signal: Signal) -> bool {
        match signal {
            Signal::NegativeLimit => self.negative_limit,
            Signal::PositiveLimit => self.positive_limit,
            Signal::Home => self.home,
        }
    }

    /// With a switch active or not.
    #[must_use]
    pub const fn with(mut self, signal: Signal, on: bool) -> Self {
        match signal {
            Signal::NegativeLimit => self.negative_limit = on,
            Signal::PositiveLimit => self.positive_limit = on,
            Signal::Home => self.home = on,
        }
        self
    }

    /// Whether a level of a profile holds.
    pub const fn holds(self, level: Level) -> bool {
        match level {
            Level::Switch(signal, on) => self.switch(signal) == on,
            Level::Standstill => self.standstill,
            Level::AtHome => self.at_home,
        }
    }
}

/// Something that happens at a place, on the way in one direction.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Crossing {
    /// What happens.
    pub event: Event,
    /// Where: the edge or pulse itself, as the hardware of a drive latches it, in counts of the encoder.
    pub position: i64,
    /// In which direction the axis moves there; for torque and stall, in which it is driven.
    pub direction: Side,
}
