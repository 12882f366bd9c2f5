//! The eight states and the statusword that shows them.

use core::fmt;

crate::word::words! {
    /// A state of the power drive system, CiA 402.
    State {
        /// The drive starts up; it does not take commands yet.
        NotReadyToSwitchOn = "Not ready to switch on",
        /// Power must not be switched on; parameters may be set.
        SwitchOnDisabled = "Switch on disabled",
        /// Power may be switched on.
        ReadyToSwitchOn = "Ready to switch on",
        /// Power is on, the motor is without torque.
        SwitchedOn = "Switched on",
        /// The motor follows the mode of operation.
        OperationEnabled = "Operation enabled",
        /// A quick stop runs, or holds the axis.
        QuickStopActive = "Quick stop active",
        /// A fault has been found and the axis is being stopped.
        FaultReactionActive = "Fault reaction active",
        /// A fault, the motor is without torque.
        Fault = "Fault",
    }
}

impl State {
    /// The bits of the statusword that tell the state, and their value.
    pub const fn pattern(self) -> (u16, u16) {
        match self {
            Self::NotReadyToSwitchOn => (0x4F, 0x00),
            Self::SwitchOnDisabled => (0x4F, 0x40),
            Self::ReadyToSwitchOn => (0x6F, 0x21),
            Self::SwitchedOn => (0x6F, 0x23),
            Self::OperationEnabled => (0x6F, 0x27),
            Self::QuickStopActive => (0x6F, 0x07),
            Self::FaultReactionActive => (0x4F, 0x0F),
            Self::Fault => (0x4F, 0x08),
        }
    }

    /// Whether torque may be on the motor.
    pub const fn is_powered(self) -> bool {
        matches!(self, Self::OperationEnabled | Self::QuickStopActive | Self::FaultReactionActive)
    }

    /// Whether a fault is being handled or waits to be reset.
    pub const fn is_fault(self) -> bool {
        matches!(self, Self::FaultReactionActive | Self::Fault)
    }
}

/// A statusword, 6041h: one sample, decoded as a whole.
///
/// ```
/// use drivewright_runtime::cia402::{State, Statusword};
///
/// let word = Statusword(0x1237);
/// assert_eq!(word.state(), Some(State::OperationEnabled));
/// assert!(word.is_remote() && word.voltage_enabled() && !word.has_warning());
/// assert_eq!(Statusword(0x0001).state(), None, "no state looks like that");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Statusword(pub u16);

macro_rules! bits {
    ($word:ident { $($(#[$doc:meta])* $constant:ident = $bit:literal, $get:ident;)* }) => {
        impl $word {
            $($(#[$doc])* pub const $constant: u16 = 1 << $bit;)*

            $(
                $(#[$doc])*
                pub const fn $get(self) -> bool {
                    self.0 & Self::$constant != 0
                }
            )*
        }
    };
}
pub(super) use bits;

bits! {
    Statusword {
        /// Bit 4: voltage is on the power stage.
        VOLTAGE_ENABLED = 4, voltage_enabled;
        /// Bit 7: a warning is active.
        WARNING = 7, has_warning;
        /// Bit 8: for the maker.
        MANUFACTURER_8 = 8, manufacturer_8;
        /// Bit 9: the drive obeys the controlword.
        REMOTE = 9, is_remote;
        /// Bit 10: the target is reached; with halt: the axis stands.
        TARGET_REACHED = 10, target_reached;
        /// Bit 11: a limit inside the drive holds the axis back.
        INTERNAL_LIMIT = 11, internal_limit;
        /// Bit 12: depends on the mode.
        MODE_12 = 12, mode_12;
        /// Bit 13: depends on the mode.
        MODE_13 = 13, mode_13;
        /// Bit 14: for the maker.
        MANUFACTURER_14 = 14, manufacturer_14;
        /// Bit 15: for the maker.
        MANUFACTURER_15 = 15, manufacturer_15;
    }
}

impl Statusword {
    /// The state that it shows; `None` where it is that of no state. No two states share a word.
    pub fn state(self) -> Option<State> {
        State::ALL.iter().copied().find(|state| {
            let (mask, value) = state.pattern();
            self.0 & mask == value
        })
    }
}

impl fmt::Display for Statusword {
    /// The state with the word in brackets: `Switched on (0233h)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.state() {
            Some(state) => write!(f, "{state} ({:04X}h)", self.0),
            None => write!(f, "no state of CiA 402 ({:04X}h)", self.0),
        }
    }
}

impl fmt::Debug for Statusword {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
