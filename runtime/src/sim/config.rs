//! What a simulation needs and a manual need not say. [`super::ASSUMPTIONS`] has the reasons.

use core::time::Duration;

/// What happens with values that a master writes over SDO, where the drive has no 1010h, store parameters.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Keeps {
    /// All are gone after a power cycle but those that take effect only then.
    Nothing,
    /// Those of the maker's range, 2000h to 5FFFh, are kept at once.
    MakerRange,
    /// All are kept at once.
    Everything,
}

/// What the position is where home has been found.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum HomeOffset {
    /// Minus 607Ch: zero is home plus offset.
    ZeroIsHomePlusOffset,
    /// 607Ch: the position at home is the offset.
    HomeIsOffset,
}

/// The settings of a virtual drive.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Config {
    /// The cycle of the drive: how often it looks at the controlword, the set-points and the axis. 62.5 us to 10 ms.
    pub cycle: Duration,
    /// From power-on to switch on disabled.
    pub start_up: Duration,
    /// Process data that do not come for so long are an alarm in OP; zero switches the watchdog off.
    pub watchdog: Duration,
    /// Whether distributed clocks are used, which decides what rules hold for the cycle.
    pub distributed_clocks: bool,
    /// What survives a power cycle without 1010h.
    pub keeps: Keeps,
    /// What the position is at home.
    pub home_offset: HomeOffset,
    /// Counts of the encoder in a revolution, where no object says it.
    pub counts_per_revolution: u32,
    /// The change of speed, in rpm, that takes the time in 6083h and 6084h where their unit is a time.
    pub ramp_speed: u32,
    /// The ramp of a quick stop in rpm/s, where there is no 6085h.
    pub quick_stop_ramp: u32,
    /// 605Ah where there is none.
    pub quick_stop_option: i16,
    /// 605Bh where there is none.
    pub shutdown_option: i16,
    /// 605Ch where there is none.
    pub disable_option: i16,
    /// 605Dh where there is none.
    pub halt_option: i16,
    /// 605Eh where there is none.
    pub fault_option: i16,
    /// The longest that a quick stop or a fault reaction waits for standstill; then the power stage goes off.
    pub stop_time: Duration,
    /// How long homing may take; zero: for ever.
    pub homing_time: Duration,
    /// How long the torque may be above rated torque, at twice the rated torque; shorter for more.
    pub overload_time: Duration,
    /// How far a target of cyclic synchronous position may be from the one before, as a multiple of the way at the
    /// highest speed of the motor; zero: any.
    pub target_jump: u8,
}

impl Default for Config {
    fn default() -> Self {
        Self {
            cycle: Duration::from_millis(1),
            start_up: Duration::from_millis(100),
            watchdog: Duration::from_millis(100),
            distributed_clocks: false,
            keeps: Keeps::MakerRange,
            home_offset: HomeOffset::ZeroIsHomePlusOffset,
            counts_per_revolution: 1 << 17,
            ramp_speed: 2_000,
            quick_stop_ramp: 60_000,
            quick_stop_option: 2,
            shutdown_option: 0,
            disable_option: 1,
            halt_option: 1,
            fault_option: 2,
            stop_time: Duration::from_secs(5),
            homing_time: Duration::from_secs(60),
            overload_time: Duration::from_secs(10),
            target_jump: 4,
        }
    }
}
