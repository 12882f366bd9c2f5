//! What an axis is made of.

use super::switches::Switches;

/// A physical axis with its motor. Torque is in 0.1 % of the rated torque, places are in counts of the encoder.
///
/// The default is an axis of our own for demonstrations, not one of a maker: 17 bit encoder, 21 revolutions between the
/// hard stops with 0 in the middle, rated torque takes it to 3000 rpm in 50 ms.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PlantConfig {
    /// Where it stands at first.
    pub start: i64,
    /// Acceleration at rated torque, in counts per square second: what inertia says. 1 to 2^38.
    pub acceleration: i64,
    /// The most torque that the motor has, in 0.1 % of rated. 1 to 10000.
    pub torque: i32,
    /// Dry friction, in 0.1 % of rated torque, against any motion and against setting off. 0 to 10000.
    pub coulomb: i32,
    /// Viscous friction at the rated speed, in 0.1 % of rated torque. 0 to 10000.
    pub viscous: i32,
    /// Rated speed, in counts per second. 1 to 2^36.
    pub rated_speed: i64,
    /// The lower hard stop: the lowest place. Not below -2^53.
    pub lower_stop: i64,
    /// The upper hard stop: the highest place. Not above 2^53.
    pub upper_stop: i64,
    /// Limit switches, home switch and index pulse.
    pub switches: Switches,
    /// Speed up to which the axis counts as standing, in 1/256 count per second.
    pub standstill: i64,
    /// The inner loops of the drive.
    pub loops: Loops,
}

/// Gains of the inner loops, in 1/s. They hold for steps up to 1 ms; a longer step is divided.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Loops {
    /// Speed for each count of position error. 0 to 100. Without feed-forward the axis lags by its speed divided by this.
    pub position: i64,
    /// Acceleration for each count per second of speed error. 1 to 500.
    pub speed: i64,
    /// What the integral of the speed error adds to that in a second. 0 to 200.
    pub integral: i64,
}

/// What [`PlantConfig::default`] says although no maker does, and why it says so.
pub const ASSUMPTIONS: [(&str, &str); 9] = [
    ("encoder", "131072 counts in a revolution: 17 bits are usual, and all places are whole numbers"),
    ("inertia", "rated torque gives 3000 rpm in 50 ms: a small motor with a load of about its own inertia"),
    ("torque", "300 % of rated: the overload of most servo motors"),
    (
        "friction",
        "3 % dry, 5 % viscous at 3000 rpm: enough to hold a light axis, too little to matter in a move",
    ),
    ("travel", "21 revolutions between hard stops without rebound: a spindle of 10 mm gives 210 mm"),
    ("switches", "limits a quarter of a revolution before the stops: enough to brake at homing speeds"),
    ("home switch", "active in the middle: methods for switches of either kind find an edge"),
    ("index pulse", "three eighths of a revolution from 0: on no edge, so that no home is ambiguous"),
    ("inner loops", "40/s, 250/s, 60/s: stable for 62.5 us to 1 ms; no maker prints those of its drive"),
];

impl Default for Loops {
    fn default() -> Self {
        Self { position: 40, speed: 250, integral: 60 }
    }
}

impl PlantConfig {
    /// Counts of a revolution of the default axis.
    pub const REVOLUTION: i64 = 131_072;
}

impl Default for PlantConfig {
    fn default() -> Self {
        let revolution = Self::REVOLUTION;
        Self {
            start: 0,
            acceleration: revolution * 1_000,
            torque: 3_000,
            coulomb: 30,
            viscous: 50,
            rated_speed: revolution * 50,
            lower_stop: -(revolution * 10 + revolution / 2),
            upper_stop: revolution * 10 + revolution / 2 - 1,
            switches: Switches::default(),
            standstill: revolution * 256 / 600,
            loops: Loops::default(),
        }
    }
}

/// A configuration that no axis can have.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ConfigError {
    /// The acceleration at rated torque is not within 1 to 2^38.
    Acceleration(i64),
    /// A torque or friction is not within its range.
    Torque(i32),
    /// The rated speed is not within 1 to 2^36.
    Speed(i64),
    /// Viscous friction that would stop the axis within a step of 1 ms.
    Viscous(i32),
    /// The hard stops are out of order or beyond 2^53 counts, or the axis starts beyond them.
    Stops,
    /// A gain is not within its range.
    Gain(i64),
    /// A revolution has not 1 to 2^40 counts, or the index pulse is not within it.
    Revolution(i64),
}

impl core::fmt::Display for ConfigError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Acceleration(value) => write!(f, "acceleration at rated torque: {value} is not 1 to 2^38"),
            Self::Torque(value) => write!(f, "torque or friction: {value} is out of range (0.1 % of rated)"),
            Self::Speed(value) => write!(f, "rated speed: {value} is not 1 to 2^36"),
            Self::Viscous(value) => write!(f, "viscous friction: {value} stops the axis within a step"),
            Self::Stops => f.write_str("the axis starts beyond its hard stops, or they are out of order"),
            Self::Gain(value) => write!(f, "gain of an inner loop: {value} is out of range"),
            Self::Revolution(value) => write!(f, "revolution or index pulse: {value} is out of range"),
        }
    }
}

impl core::error::Error for ConfigError {}

/// The farthest that a hard stop may be from 0.
const FARTHEST: i64 = 1 << 53;

/// Most of a torque, in 0.1 % of rated.
const MOST: i32 = 10_000;

impl PlantConfig {
    /// Refuses what no axis can have, or what the arithmetic does not hold.
    pub(super) fn check(&self) -> Result<(), ConfigError> {
        within(self.acceleration, 1, 1 << 38, ConfigError::Acceleration)?;
        within(self.torque, 1, MOST, ConfigError::Torque)?;
        within(self.coulomb, 0, MOST, ConfigError::Torque)?;
        within(self.viscous, 0, MOST, ConfigError::Torque)?;
        within(self.rated_speed, 1, 1 << 36, ConfigError::Speed)?;
        within(self.loops.position, 0, 100, ConfigError::Gain)?;
        within(self.loops.speed, 1, 500, ConfigError::Gain)?;
        within(self.loops.integral, 0, 200, ConfigError::Gain)?;
        within(self.damping(), 0, 500 << 12, |_| ConfigError::Viscous(self.viscous))?;
        let places = [-FARTHEST, self.lower_stop, self.start, self.upper_stop, FARTHEST];
        if !places.windows(2).all(|pair| pair.first() <= pair.last()) {
            return Err(ConfigError::Stops);
        }
        self.switches.check()
    }

    /// Deceleration by viscous friction for each count per second, in 1/4096 1/s.
    pub(super) fn damping(&self) -> i64 {
        let at_rated = i128::from(self.viscous) * i128::from(self.acceleration) * 4_096 / 1_000;
        let each = at_rated.checked_div(i128::from(self.rated_speed)).unwrap_or(0);
        i64::try_from(each).unwrap_or(i64::MAX)
    }
}

fn within<T: PartialOrd + Copy, E>(value: T, low: T, high: T, error: impl Fn(T) -> E) -> Result<(), E> {
    if low <= value && value <= high {
        Ok(())
    } else {
        Err(error(value))
    }
}
