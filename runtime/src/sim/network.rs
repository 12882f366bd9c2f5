//! The EtherCAT state machine, as the master asks it.

use crate::model::EsmState;

/// Why a state of the EtherCAT state machine was refused: the AL status code, ETG.1000.6.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum BusRefusal {
    /// 0011h: the change is not one of the state machine.
    InvalidChange,
    /// 0024h: what the drive sends cannot be laid out.
    InputMapping,
    /// 0025h: what the drive receives cannot be laid out.
    OutputMapping,
    /// 0035h: a rule for the cycle time is broken.
    CycleTime,
    /// The control supply is off.
    Off,
}

impl BusRefusal {
    /// The AL status code; 0 while the supply is off.
    pub const fn code(self) -> u16 {
        match self {
            Self::InvalidChange => 0x0011,
            Self::InputMapping => 0x0024,
            Self::OutputMapping => 0x0025,
            Self::CycleTime => 0x0035,
            Self::Off => 0,
        }
    }
}

impl core::fmt::Display for BusRefusal {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let why = match self {
            Self::InvalidChange => "states follow one another on the way up",
            Self::InputMapping => "what the drive sends cannot be laid out as it is mapped",
            Self::OutputMapping => "what the drive receives cannot be laid out as it is mapped",
            Self::CycleTime => "a rule for the cycle time is broken",
            Self::Off => return f.write_str("the control supply is off"),
        };
        write!(f, "AL status {:04X}h: {why}", self.code())
    }
}

impl core::error::Error for BusRefusal {}

/// Whether a change is one of the state machine: one step up, any number down, or none.
pub(crate) const fn is_change(from: EsmState, to: EsmState) -> bool {
    rank(to) <= rank(from) + 1
}

const fn rank(state: EsmState) -> u8 {
    match state {
        EsmState::Init => 0,
        EsmState::PreOp => 1,
        EsmState::SafeOp => 2,
        EsmState::Op => 3,
    }
}
