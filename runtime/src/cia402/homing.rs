//! What the statusword says of homing.

use super::mode::ModeBits;
use super::state::Statusword;

crate::word::words! {
    /// Bits 13, 12 and 10 of the statusword in homing mode.
    HomingState {
        /// Homing runs.
        InProgress = "in progress",
        /// Homing has not been started, or was interrupted: before a start this is normal.
        NotStarted = "not started or interrupted",
        /// Home is found and the axis still moves.
        Attained = "attained, target not reached",
        /// Home is found and the axis stands.
        Completed = "completed",
        /// Homing has failed and the axis still moves.
        ErrorMoving = "error, still moving",
        /// Homing has failed and the axis stands.
        ErrorStopped = "error, at standstill",
        /// Found and failed at once: the standard has no such pattern.
        Reserved = "reserved pattern",
    }
}

impl HomingState {
    /// What one sample says.
    pub const fn of(word: Statusword) -> Self {
        let error = word.0 & ModeBits::HOMING_ERROR != 0;
        let attained = word.0 & ModeBits::HOMING_ATTAINED != 0;
        match (error, attained, word.target_reached()) {
            (false, false, false) => Self::InProgress,
            (false, false, true) => Self::NotStarted,
            (false, true, false) => Self::Attained,
            (false, true, true) => Self::Completed,
            (true, false, false) => Self::ErrorMoving,
            (true, false, true) => Self::ErrorStopped,
            (true, true, _) => Self::Reserved,
        }
    }
}
