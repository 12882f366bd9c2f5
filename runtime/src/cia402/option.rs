//! Option codes: how the axis is stopped, and what follows.

crate::word::words! {
    /// How an axis is stopped.
    Reaction {
        /// The power stage is switched off at once and the axis runs out.
        Coast = "switched off at once",
        /// Along the ramp of the profile.
        SlowDownRamp = "slow-down ramp",
        /// Along the ramp of the quick stop.
        QuickStopRamp = "quick-stop ramp",
        /// With all the current that the drive allows.
        CurrentLimit = "current limit",
        /// With all the voltage that the drive has.
        VoltageLimit = "voltage limit",
    }
}

/// What an option code says.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StopOption {
    /// How the axis is stopped.
    pub reaction: Reaction,
    /// Whether the state is kept afterwards: quick stop active for 605Ah, operation enabled for 605Dh. Otherwise the
    /// power stage goes off at standstill.
    pub stays: bool,
}

impl StopOption {
    const fn new(reaction: Reaction, stays: bool) -> Self {
        Self { reaction, stays }
    }

    /// 605Ah, quick stop: 0 to 8. `None`: of the maker or reserved.
    pub const fn quick_stop(code: i16) -> Option<Self> {
        match code {
            0..=4 => Self::ramp(code, false),
            5..=8 => Self::ramp(code - 4, true),
            _ => None,
        }
    }

    /// 605Bh, shutdown, and 605Ch, disable operation: 0 or 1. `None`: of the maker or reserved.
    pub const fn disable(code: i16) -> Option<Self> {
        match code {
            0 | 1 => Self::ramp(code, false),
            _ => None,
        }
    }

    /// 605Dh, halt: 1 to 4. `None`: of the maker or reserved, as 0 is.
    pub const fn halt(code: i16) -> Option<Self> {
        match code {
            1..=4 => Self::ramp(code, true),
            _ => None,
        }
    }

    /// 605Eh, fault reaction: 0 to 4. `None`: of the maker or reserved.
    pub const fn fault(code: i16) -> Option<Self> {
        Self::ramp(code, false)
    }

    const fn ramp(code: i16, stays: bool) -> Option<Self> {
        let reaction = match code {
            0 => Reaction::Coast,
            1 => Reaction::SlowDownRamp,
            2 => Reaction::QuickStopRamp,
            3 => Reaction::CurrentLimit,
            4 => Reaction::VoltageLimit,
            _ => return None,
        };
        Some(Self::new(reaction, stays))
    }
}
