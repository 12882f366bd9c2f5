//! The inner loops: they follow, they are stable for each step, they keep the torque limit.

use super::*;
use crate::sim::planner::{Limits, Planner};

const REVOLUTION: i64 = PlantConfig::REVOLUTION;

/// The default axis and some that are harder to hold.
fn axes() -> [PlantConfig; 4] {
    let own = PlantConfig::default();
    [
        own,
        PlantConfig { coulomb: 0, viscous: 0, ..own },
        PlantConfig { coulomb: 200, viscous: 300, ..own },
        PlantConfig { acceleration: REVOLUTION * 100, ..own },
    ]
}

#[test]
fn a_position_is_reached_and_held() {
    for config in axes() {
        for dt in STEPS {
            let mut axis = axis(config);
            run(&mut axis, place(1_000), MS * 1_500, dt);
            assert_eq!(axis.position(), 1_000, "{dt:?} {config:?}");
            for _ in 0..200 {
                axis.step(place(1_000), dt);
                assert_eq!(axis.position(), 1_000, "{dt:?} {config:?}");
                assert!(axis.standstill());
            }
        }
    }
}

#[test]
fn a_planned_move_is_followed_and_ends_on_its_target() {
    for config in axes() {
        for dt in STEPS {
            let (mut axis, mut planner) = (axis(config), Planner::at(0));
            let rate = REVOLUTION * 50;
            let target = REVOLUTION * 5;
            planner.move_to(
                target,
                Limits { velocity: REVOLUTION * 20 * 256, acceleration: rate, deceleration: rate },
            );
            let mut worst = 0;
            while !planner.done() {
                let point = planner.step(dt);
                let (velocity, acceleration) = (point.velocity, point.acceleration);
                axis.step(Setpoint::Position { target: point.position, velocity, acceleration }, dt);
                worst = worst.max(axis.position().abs_diff(point.position));
            }
            // A twentieth of a revolution: the friction that is not fed forward, and steps of 4 ms.
            assert!(worst < 6_553, "{worst} {dt:?} {config:?}");
            run(&mut axis, place(target), MS * 1_000, dt);
            assert_eq!(axis.position(), target, "{dt:?} {config:?}");
        }
    }
}

#[test]
fn a_speed_is_reached_and_kept() {
    for config in axes() {
        for dt in STEPS {
            let mut axis = axis(config);
            run(&mut axis, speed(REVOLUTION), MS * 1_000, dt);
            for _ in 0..100 {
                axis.step(speed(REVOLUTION), dt);
                let off = axis.velocity().abs_diff(REVOLUTION * 256);
                assert!(off < (REVOLUTION * 256 / 1_000).unsigned_abs(), "{off} {dt:?} {config:?}");
            }
        }
    }
}

#[test]
fn a_load_is_held_at_a_place() {
    for config in axes() {
        let mut axis = axis(config);
        axis.set_load(-400);
        run(&mut axis, place(0), MS * 2_000, MS);
        assert_eq!(axis.position(), 0, "{config:?}");
        assert!(
            axis.torque().abs_diff(400) <= u32::try_from(config.coulomb).unwrap() + 1,
            "{}",
            axis.torque()
        );
    }
}

#[test]
fn a_stall_is_timed_and_left() {
    for (away, side) in [(-1, Side::Positive), (1, Side::Negative)] {
        let mut axis = axis(PlantConfig::default());
        axis.limit_torque(300, 300);
        run(&mut axis, speed(-away * REVOLUTION * 5), MS * 2_200, MS);
        assert_eq!(axis.contact(), Some(side));
        run(&mut axis, speed(-away * REVOLUTION * 5), MS * 200, MS);
        let stalled = axis.stalled();
        assert!(stalled >= MS * 200, "{stalled:?}");
        assert_eq!(axis.torque().abs(), 300);
        assert_eq!(axis.driven(), side);
        axis.step(speed(-away * REVOLUTION * 5), MS);
        assert_eq!(axis.stalled(), stalled + MS);
        run(&mut axis, speed(away * REVOLUTION), MS * 20, MS);
        assert_eq!((axis.contact(), axis.stalled()), (None, Duration::ZERO), "it leaves the stop at once");
    }
}

#[test]
fn a_stop_is_left_at_once_after_a_long_push() {
    for away in [-1, 1] {
        let mut axis = axis(PlantConfig { start: -away * REVOLUTION * 10, ..PlantConfig::default() });
        run(&mut axis, speed(-away * REVOLUTION / 4), MS * 10_000, MS);
        assert_eq!(axis.torque(), -3_000 * i32::try_from(away).unwrap());
        run(&mut axis, speed(away * REVOLUTION / 4), MS * 20, MS);
        assert_eq!(axis.contact(), None);
    }
}

#[test]
fn a_speed_that_takes_all_torque_is_not_overrun() {
    let mut axis = axis(PlantConfig { upper_stop: 1 << 50, ..PlantConfig::default() });
    axis.limit_torque(200, 200);
    let (wanted, mut most) = (REVOLUTION * 20, 0);
    for _ in 0..2_000 {
        axis.step(speed(wanted), MS);
        most = most.max(axis.velocity());
    }
    assert!(axis.velocity().abs_diff(wanted * 256) < (wanted * 256 / 1_000).unsigned_abs());
    assert!(most < wanted * 256 * 102 / 100, "{} of {wanted}", most / 256);
}

#[test]
fn the_torque_limit_holds_while_it_is_in_control() {
    let mut axis = axis(PlantConfig::default());
    axis.limit_torque(500, 400);
    for n in 0..2_000 {
        axis.step(place(if n / 200 % 2 == 0 { REVOLUTION } else { -REVOLUTION }), MS);
        assert!((-400..=500).contains(&axis.torque()), "{}", axis.torque());
    }
}

#[test]
fn speed_control_takes_over_from_torque_control_without_a_jump() {
    let mut axis = axis(bare());
    axis.set_load(-400);
    run(&mut axis, torque(400), MS * 100, MS);
    assert_eq!(axis.velocity(), 0);
    run(&mut axis, speed(0), MS * 100, MS);
    assert_eq!((axis.torque(), axis.velocity(), axis.position()), (400, 0, 0));
}
