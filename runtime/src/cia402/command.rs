//! Commands of the state machine and the controlword that carries them.

use core::fmt;

use super::state::bits;

crate::word::words! {
    /// A command of the state machine, CiA 402.
    Command {
        /// Transitions 2, 6 and 8.
        Shutdown = "Shutdown",
        /// Transition 3. In the state operation enabled the same bits are disable operation, transition 5.
        SwitchOn = "Switch on",
        /// Transitions 4 and 16.
        EnableOperation = "Enable operation",
        /// Transitions 7, 9, 10 and 12.
        DisableVoltage = "Disable voltage",
        /// Transitions 7, 10 and 11.
        QuickStop = "Quick stop",
        /// Transition 15, by the rising edge of bit 7.
        FaultReset = "Fault reset",
    }
}

impl Command {
    /// The bits of the controlword that a client writes for it, of those that belong to commands: 0 to 3 and 7.
    ///
    /// A fault reset goes with bits 0 to 3 clear, so that nothing is enabled by the same word.
    pub const fn bits(self) -> u16 {
        match self {
            Self::Shutdown => 0x06,
            Self::SwitchOn => 0x07,
            Self::EnableOperation => 0x0F,
            Self::DisableVoltage => 0x00,
            Self::QuickStop => 0x02,
            Self::FaultReset => 0x80,
        }
    }
}

/// A controlword, 6040h.
///
/// ```
/// use drivewright_runtime::cia402::{Command, Controlword};
///
/// let halted = Controlword::new(Command::EnableOperation).with_mode_bits(Controlword::HALT);
/// assert_eq!(halted.0, 0x010F);
/// assert_eq!(halted.level(), Some(Command::EnableOperation));
/// assert_eq!(halted.with_command(Command::Shutdown).0, 0x0106, "bits of the mode stay");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Controlword(pub u16);

bits! {
    Controlword {
        /// Bit 0: switch on.
        SWITCH_ON = 0, switch_on;
        /// Bit 1: enable voltage.
        ENABLE_VOLTAGE = 1, enable_voltage;
        /// Bit 2: quick stop; 0 asks for it.
        QUICK_STOP = 2, no_quick_stop;
        /// Bit 3: enable operation.
        ENABLE_OPERATION = 3, enable_operation;
        /// Bit 4: depends on the mode.
        MODE_4 = 4, mode_4;
        /// Bit 5: depends on the mode.
        MODE_5 = 5, mode_5;
        /// Bit 6: depends on the mode.
        MODE_6 = 6, mode_6;
        /// Bit 7: fault reset, by its rising edge.
        FAULT_RESET = 7, fault_reset;
        /// Bit 8: halt.
        HALT = 8, halt;
        /// Bit 9: depends on the mode.
        MODE_9 = 9, mode_9;
    }
}

impl Controlword {
    /// The bits that belong to commands: 0 to 3 and 7.
    pub const COMMAND: u16 = 0x008F;

    /// A command, every other bit clear.
    pub const fn new(command: Command) -> Self {
        Self(command.bits())
    }

    /// The same with another command; the bits of mode and maker stay.
    #[must_use]
    pub const fn with_command(self, command: Command) -> Self {
        Self(self.0 & !Self::COMMAND | command.bits())
    }

    /// The same with other bits of mode and maker; the command stays. Command bits of `bits` are ignored.
    #[must_use]
    pub const fn with_mode_bits(self, bits: u16) -> Self {
        Self(self.0 & Self::COMMAND | bits & !Self::COMMAND)
    }

    /// The command that the word holds as a level: bits 0 to 3, where bit 7 is clear. `None`: bit 7 is set, with which
    /// no row of the standard's table holds but that of the fault reset, which counts by its edge.
    pub const fn level(self) -> Option<Command> {
        match self.0 & Self::COMMAND {
            word if word & Self::FAULT_RESET != 0 => None,
            word if word & Self::ENABLE_VOLTAGE == 0 => Some(Command::DisableVoltage),
            word if word & Self::QUICK_STOP == 0 => Some(Command::QuickStop),
            word if word & Self::SWITCH_ON == 0 => Some(Command::Shutdown),
            word if word & Self::ENABLE_OPERATION == 0 => Some(Command::SwitchOn),
            _ => Some(Command::EnableOperation),
        }
    }
}

impl fmt::Display for Controlword {
    /// The command with the word in brackets: `Shutdown (0006h)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.level() {
            Some(command) => write!(f, "{command} ({:04X}h)", self.0),
            None => write!(f, "{} ({:04X}h)", Command::FaultReset, self.0),
        }
    }
}

impl fmt::Debug for Controlword {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
