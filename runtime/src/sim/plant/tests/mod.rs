//! Expectations are arithmetic: `v = a t`, `x = a t² / 2`, `x = v² / (2 a)`.

mod crossings;
mod loops;
mod physics;

use super::*;
use core::time::Duration;

const MS: Duration = Duration::from_millis(1);

/// Steps from 62.5 µs to 4 ms.
const STEPS: [Duration; 4] =
    [Duration::from_nanos(62_500), Duration::from_micros(250), MS, Duration::from_millis(4)];

/// Rated torque makes it quicker by 1,000,000 counts per second in a second; no friction, no switches, 1,000,000 counts
/// to the hard stops.
fn bare() -> PlantConfig {
    PlantConfig {
        start: 0,
        acceleration: 1_000_000,
        torque: 3_000,
        coulomb: 0,
        viscous: 0,
        rated_speed: 100_000,
        lower_stop: -1_000_000,
        upper_stop: 1_000_000,
        switches: Switches::NONE,
        standstill: 256,
        loops: Loops::default(),
    }
}

fn axis(config: PlantConfig) -> Plant {
    Plant::new(config).unwrap()
}

/// Steps for a time in all.
fn run(axis: &mut Plant, setpoint: Setpoint, time: Duration, dt: Duration) {
    let mut gone = Duration::ZERO;
    while gone < time {
        axis.step(setpoint, dt);
        gone += dt;
    }
}

const fn torque(torque: i32) -> Setpoint {
    Setpoint::Torque { torque }
}

/// In counts per second.
const fn speed(counts: i64) -> Setpoint {
    Setpoint::Velocity { velocity: counts * 256, acceleration: 0 }
}

const fn place(target: i64) -> Setpoint {
    Setpoint::Position { target, velocity: 0, acceleration: 0 }
}

#[test]
fn configurations_that_no_axis_has_are_refused() {
    let refused = |change: fn(&mut PlantConfig)| {
        let mut config = bare();
        change(&mut config);
        Plant::new(config).unwrap_err()
    };
    assert_eq!(refused(|c| c.acceleration = 0), ConfigError::Acceleration(0));
    assert_eq!(refused(|c| c.torque = 10_001), ConfigError::Torque(10_001));
    assert_eq!(refused(|c| c.coulomb = -1), ConfigError::Torque(-1));
    assert_eq!(refused(|c| c.rated_speed = 0), ConfigError::Speed(0));
    assert_eq!(refused(|c| (c.viscous, c.rated_speed) = (1_000, 1)), ConfigError::Viscous(1_000));
    assert_eq!(refused(|c| c.lower_stop = 1), ConfigError::Stops);
    assert_eq!(refused(|c| c.upper_stop = i64::MAX), ConfigError::Stops);
    assert_eq!(refused(|c| c.loops.speed = 501), ConfigError::Gain(501));
    assert_eq!(refused(|c| c.switches.revolution = 0), ConfigError::Revolution(0));
    assert_eq!(refused(|c| c.switches.index = Some(1)), ConfigError::Revolution(1));
    assert!(PlantConfig::default().check().is_ok());
}
