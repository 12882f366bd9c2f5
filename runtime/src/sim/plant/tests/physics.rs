//! Inertia, friction, load, hard stops.

use super::*;

#[test]
fn constant_torque_gives_constant_acceleration() {
    for dt in STEPS {
        let mut axis = axis(bare());
        // Half of the rated torque for 0.1 s.
        run(&mut axis, torque(500), MS * 100, dt);
        assert_eq!((axis.position(), axis.velocity()), (2_500, 50_000 * 256), "{dt:?}");
        assert_eq!(axis.torque(), 500);
        run(&mut axis, torque(-500), MS * 100, dt);
        assert_eq!((axis.position(), axis.velocity()), (5_000, 0), "{dt:?}");
    }
}

#[test]
fn without_friction_it_coasts() {
    let mut axis = axis(bare());
    run(&mut axis, torque(1_000), MS * 100, MS);
    run(&mut axis, Setpoint::Off, MS * 1_000, MS);
    assert_eq!((axis.position(), axis.velocity()), (5_000 + 100_000, 100_000 * 256));
}

#[test]
fn dry_friction_stops_it_where_arithmetic_says() {
    for dt in STEPS {
        let mut axis = axis(PlantConfig { coulomb: 100, ..bare() });
        // 110 % against 10 %: 100,000 counts/s after 0.1 s and 5000 counts.
        run(&mut axis, torque(1_100), MS * 100, dt);
        assert_eq!((axis.position(), axis.velocity()), (5_000, 100_000 * 256));
        // 10 % to brake: 1 s and 50,000 counts.
        run(&mut axis, Setpoint::Off, MS * 996, dt);
        assert!(axis.velocity() > 0, "{dt:?}");
        run(&mut axis, Setpoint::Off, MS * 8, dt);
        assert_eq!((axis.position(), axis.velocity()), (55_000, 0), "{dt:?}");
    }
}

#[test]
fn dry_friction_holds_it_up_to_its_torque() {
    let mut axis = axis(PlantConfig { coulomb: 100, ..bare() });
    run(&mut axis, torque(100), MS * 100, MS);
    assert_eq!((axis.position(), axis.velocity()), (0, 0));
    // 20 % against 10 %, for 0.1 s.
    run(&mut axis, torque(-200), MS * 100, MS);
    assert_eq!((axis.position(), axis.velocity()), (-500, -10_000 * 256));
}

#[test]
fn a_load_drives_it_when_the_drive_is_off() {
    let mut axis = axis(PlantConfig { coulomb: 100, ..bare() });
    axis.set_load(-100);
    run(&mut axis, Setpoint::Off, MS * 100, MS);
    assert_eq!(axis.position(), 0);
    axis.set_load(-300);
    run(&mut axis, Setpoint::Off, MS * 100, MS);
    assert_eq!((axis.position(), axis.velocity()), (-1_000, -20_000 * 256));
    assert_eq!(axis.torque(), 0);
}

#[test]
fn viscous_friction_ends_at_the_speed_that_takes_the_torque() {
    // Half of the rated torque at 100,000 counts/s.
    let mut axis = axis(PlantConfig { viscous: 500, ..bare() });
    run(&mut axis, torque(250), MS * 4_000, MS);
    assert!(axis.velocity().abs_diff(50_000 * 256) < 256, "{}", axis.velocity());
    // The time constant is 0.2 s: a third and a bit, 1/e, is left after it.
    run(&mut axis, Setpoint::Off, MS * 200, MS);
    assert!(axis.velocity().abs_diff(18_394 * 256) < 100 * 256, "{}", axis.velocity());
}

#[test]
fn a_hard_stop_stops_it_at_once_and_holds() {
    for (drive, stop, side) in [(1_000, 1_000_000, Side::Positive), (-1_000, -1_000_000, Side::Negative)] {
        let mut axis = axis(bare());
        // 1,000,000 counts take the square root of 2 seconds.
        run(&mut axis, torque(drive), MS * 1_414, MS);
        assert_eq!(axis.contact(), None);
        run(&mut axis, torque(drive), MS, MS);
        assert_eq!((axis.position(), axis.velocity(), axis.contact()), (stop, 0, Some(side)));
        run(&mut axis, torque(drive), MS * 100, MS);
        assert_eq!((axis.position(), axis.contact()), (stop, Some(side)));
        run(&mut axis, torque(-drive), MS * 100, MS);
        assert_eq!(axis.contact(), None);
        assert!(axis.position().abs_diff(stop - 5_000 * stop.signum()) <= 1);
    }
}

#[test]
fn torque_limits_hold_in_each_direction() {
    let mut axis = axis(bare());
    axis.limit_torque(200, 100);
    run(&mut axis, torque(2_000), MS, MS);
    assert_eq!(axis.torque(), 200);
    run(&mut axis, torque(-2_000), MS, MS);
    assert_eq!(axis.torque(), -100);
    axis.limit_torque(i32::MAX, i32::MIN);
    run(&mut axis, torque(9_000), MS, MS);
    assert_eq!(axis.torque(), 3_000, "the motor has no more");
    run(&mut axis, torque(-9_000), MS, MS);
    assert_eq!(axis.torque(), 0);
}

#[test]
fn the_ends_of_the_numbers_are_held() {
    let wild = [i64::MIN, -1, 0, 1, i64::MAX];
    let far = 1 << 53;
    let extreme = PlantConfig {
        acceleration: 1 << 38,
        torque: 10_000,
        coulomb: 10_000,
        rated_speed: 1 << 36,
        lower_stop: -far,
        upper_stop: far,
        loops: Loops { position: 100, speed: 500, integral: 200 },
        ..PlantConfig::default()
    };
    for config in [extreme, PlantConfig { coulomb: 0, ..extreme }, PlantConfig::default()] {
        for (velocity, target, acceleration) in wild
            .into_iter()
            .flat_map(|v| wild.into_iter().flat_map(move |t| wild.into_iter().map(move |a| (v, t, a))))
        {
            let mut axis = axis(config);
            axis.set_load(i32::MAX);
            let all = [
                Setpoint::Position { target, velocity, acceleration },
                Setpoint::Velocity { velocity, acceleration },
                torque(i32::MIN),
                Setpoint::Off,
            ];
            for setpoint in all {
                run(&mut axis, setpoint, MS * 20, MS * 4);
                axis.step(setpoint, MS * 100);
            }
            assert!((-far..=far).contains(&axis.position()));
        }
    }
}
