//! What the standard leaves open and drives do differently: times, quirks, limits.

use core::fmt;
use core::time::Duration;

use crate::cia402::{Command, Mode, StopOption};

/// A set of modes of operation, as the bits of 6502h.
///
/// ```
/// use drivewright_runtime::cia402::Mode;
/// use drivewright_runtime::client::axis::Modes;
///
/// // On the wire 25 02 00 00, little endian.
/// let modes = Modes(u32::from_le_bytes([0x25, 0x02, 0, 0]));
/// assert!(modes.has(Mode::CYCLIC_TORQUE) && !modes.has(Mode::CYCLIC_POSITION));
/// assert_eq!(
///     modes.to_string(),
///     "profile position (1), profile velocity (3), homing (6), cyclic synchronous torque (10)"
/// );
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Modes(pub u32);

impl Modes {
    /// Nothing is known: every mode is tried.
    pub const ANY: Self = Self(u32::MAX);

    /// None at all; for [`with`](Self::with).
    pub const NONE: Self = Self(0);

    /// Whether a mode is among them. No mode, 0, and the maker's modes always are: no bit is assigned to them.
    pub const fn has(self, mode: Mode) -> bool {
        match mode.supported_bit() {
            Some(bit) => self.0 & bit != 0,
            None => mode.0 <= 0 || self.0 == Self::ANY.0,
        }
    }

    /// The same with one more.
    #[must_use]
    pub const fn with(self, mode: Mode) -> Self {
        match mode.supported_bit() {
            Some(bit) => Self(self.0 | bit),
            None => self,
        }
    }
}

impl fmt::Display for Modes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if *self == Self::ANY {
            return f.write_str("any");
        }
        let mut modes = (1..=11).map(Mode).filter(|mode| self.has(*mode));
        match modes.next() {
            Some(first) => write!(f, "{first}")?,
            None => return f.write_str("none"),
        }
        modes.try_for_each(|mode| write!(f, ", {mode}"))
    }
}

/// How far a target that comes every cycle may be from the one before it, in raw counts. `None`: as far as it likes.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct StepLimits {
    /// 607Ah.
    pub position: Option<u32>,
    /// 60FFh.
    pub velocity: Option<u32>,
    /// 6071h.
    pub torque: Option<u32>,
}

/// Times, quirks and limits of an axis. [`Default`] has what suits most drives; what a manual or a bench says otherwise is
/// set by the program.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
#[allow(clippy::struct_excessive_bools)] // Each is a quirk of its own.
pub struct AxisPolicy {
    /// Modes that the drive has. Default: [`Modes::ANY`].
    pub modes: Modes,
    /// The longest walk through the states, brake included. Default: 3 s.
    pub state_within: Duration,
    /// The longest time until 6061h shows a mode. Default: 1 s.
    pub mode_within: Duration,
    /// Whether 6061h must show the mode before the states are walked; `false` for drives that show it afterwards.
    /// Default: `true`.
    pub mode_before_enable: bool,
    /// Whether halt keeps the drive from taking a mode: then halt is released first. Default: `false`.
    pub mode_needs_halt_off: bool,
    /// How long each level of an edge is held: bit 7 of a fault reset, bit 4 of homing. Default: 10 ms.
    pub edge_hold: Duration,
    /// The longest time from the edge of a fault reset until the fault is gone. Default: 1 s.
    pub reset_within: Duration,
    /// A statusword older than this is not believed. Default: 100 ms.
    pub stale_after: Duration,
    /// How many cycles pass until a sample can show what an output has done. Default: 2.
    pub latency: u8,
    /// How far the first target position may be from the actual one, in user units. Default: 1000.
    pub seed_limit: u32,
    /// How far later targets of the cyclic modes may be from the one before. Default: no limit, for none suits every gear.
    pub step_limits: StepLimits,
    /// What 605Ah says, where it is known. Default: not known.
    pub quick_stop: Option<StopOption>,
    /// The command when the axis was in operation and has left it, or is not heard any more. Default: Shutdown.
    pub safe_command: Command,
    /// Whether bit 12 may be high in profile position mode before the first set-point. Default: `false`.
    pub acknowledge_may_be_high: bool,
    /// Whether bit 6 means absolute, against the standard. Default: what the model says, where there is one.
    pub relative_bit_is_inverted: Option<bool>,
    /// The longest time until a set-point is acknowledged. Default: 1 s.
    pub acknowledge_within: Duration,
    /// The longest time until homing is seen to start. Default: 1 s.
    pub homing_start_within: Duration,
    /// How long homing may look interrupted, as it does at a reversal. Default: 500 ms.
    pub homing_idle: Duration,
    /// Whether the drive clears bit 12 when homing starts. `false`: an old one counts when homing has had the time to start.
    /// Default: `true`.
    pub homing_clears_attained: bool,
}

impl Default for AxisPolicy {
    fn default() -> Self {
        Self {
            modes: Modes::ANY,
            state_within: Duration::from_secs(3),
            mode_within: Duration::from_secs(1),
            mode_before_enable: true,
            mode_needs_halt_off: false,
            edge_hold: Duration::from_millis(10),
            reset_within: Duration::from_secs(1),
            stale_after: Duration::from_millis(100),
            latency: 2,
            seed_limit: 1_000,
            step_limits: StepLimits::default(),
            quick_stop: None,
            safe_command: Command::Shutdown,
            acknowledge_may_be_high: false,
            relative_bit_is_inverted: None,
            acknowledge_within: Duration::from_secs(1),
            homing_start_within: Duration::from_secs(1),
            homing_idle: Duration::from_millis(500),
            homing_clears_attained: true,
        }
    }
}
