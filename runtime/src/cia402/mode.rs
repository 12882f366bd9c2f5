//! Modes of operation and what the bits of the words mean in them.

use core::fmt;
use core::hash::{Hash, Hasher};

crate::wire_enum! {
    /// A mode of operation, 6060h and 6061h. Open: negative ones are the maker's.
    pub struct Mode(i8) = "mode of operation" {
        /// None: the drive waits for a mode.
        NONE = 0 => "no mode",
        /// Moves to a target along a profile that the drive makes.
        PROFILE_POSITION = 1 => "profile position",
        /// Speed of a frequency converter, with ramps.
        VELOCITY = 2 => "velocity",
        /// Goes to a speed along a ramp and keeps it.
        PROFILE_VELOCITY = 3 => "profile velocity",
        /// Goes to a torque along a slope and keeps it.
        PROFILE_TORQUE = 4 => "profile torque",
        /// Finds home.
        HOMING = 6 => "homing",
        /// Runs through points that the drive connects.
        INTERPOLATED_POSITION = 7 => "interpolated position",
        /// Follows a position that comes every cycle.
        CYCLIC_POSITION = 8 => "cyclic synchronous position",
        /// Follows a speed that comes every cycle.
        CYCLIC_VELOCITY = 9 => "cyclic synchronous velocity",
        /// Follows a torque that comes every cycle.
        CYCLIC_TORQUE = 10 => "cyclic synchronous torque",
        /// Follows a torque and an angle of the field.
        CYCLIC_TORQUE_ANGLE = 11 => "cyclic synchronous torque with commutation angle",
    }
}

impl Mode {
    /// Its bit in 6502h, supported drive modes; `None` for no mode and for the maker's, whose bits 16 to 31 no standard
    /// assigns.
    pub const fn supported_bit(self) -> Option<u32> {
        match self.0 {
            1..=11 => Some(1 << (self.0 - 1)),
            _ => None,
        }
    }

    /// Whether it follows a target that comes every cycle.
    pub const fn is_cyclic(self) -> bool {
        matches!(
            self,
            Self::CYCLIC_POSITION | Self::CYCLIC_VELOCITY | Self::CYCLIC_TORQUE | Self::CYCLIC_TORQUE_ANGLE
        )
    }
}

impl fmt::Display for Mode {
    /// The name with the number in brackets: `homing (6)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self, f)
    }
}

impl Hash for Mode {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.hash(state);
    }
}

/// Names of the bits that depend on the mode.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ModeBits;

impl ModeBits {
    /// Profile position, controlword bit 4: a new set-point.
    pub const NEW_SET_POINT: u16 = 1 << 4;
    /// Profile position, controlword bit 5: it replaces the one that is being approached.
    pub const CHANGE_IMMEDIATELY: u16 = 1 << 5;
    /// Profile position, controlword bit 6: the target is a distance.
    pub const RELATIVE: u16 = 1 << 6;
    /// Profile position, controlword bit 9: the set-points are passed without a stop between them.
    pub const CHANGE_ON_SET_POINT: u16 = 1 << 9;
    /// Homing, controlword bit 4: start.
    pub const START_HOMING: u16 = 1 << 4;
    /// Profile position, statusword bit 12: the set-point has been taken.
    pub const SET_POINT_ACKNOWLEDGE: u16 = 1 << 12;
    /// Position modes, statusword bit 13: following error.
    pub const FOLLOWING_ERROR: u16 = 1 << 13;
    /// Profile velocity, statusword bit 12: the axis stands.
    pub const SPEED_IS_ZERO: u16 = 1 << 12;
    /// Cyclic modes, statusword bit 12: the axis follows the target.
    pub const FOLLOWS_TARGET: u16 = 1 << 12;
    /// Homing, statusword bit 12: home has been found.
    pub const HOMING_ATTAINED: u16 = 1 << 12;
    /// Homing, statusword bit 13: homing has failed.
    pub const HOMING_ERROR: u16 = 1 << 13;
}
