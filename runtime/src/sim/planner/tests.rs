//! Expectations are arithmetic: `v = a t`, `x = a t² / 2`, `x = v² / (2 d)`.

use super::*;
use crate::sim::lcg::Lcg;
use std::vec::Vec;

const MS: Duration = Duration::from_millis(1);

fn limits(velocity: i64, acceleration: i64, deceleration: i64) -> Limits {
    Limits { velocity: velocity * SPEED, acceleration, deceleration }
}

fn run(planner: &mut Planner, steps: usize) -> Vec<Point> {
    (0..steps).map(|_| planner.step(MS)).collect()
}

/// Steps until done.
fn time(planner: &mut Planner, dt: Duration) -> u64 {
    (1..10_000_000)
        .find(|_| {
            planner.step(dt);
            planner.done()
        })
        .unwrap()
}

#[test]
fn a_trapezoid_is_where_arithmetic_says() {
    let mut planner = Planner::at(0);
    planner.move_to(1_000, limits(1_000, 10_000, 5_000));
    // 0.1 s and 50 units to be quick; 0.2 s and 100 units to brake; 850 units at 1000 units/s.
    let trace = run(&mut planner, 1_150);
    let at = |ms: usize| (trace[ms - 1].position, trace[ms - 1].velocity);
    assert_eq!(at(50), (12, 500 * SPEED));
    assert_eq!(at(100), (50, 1_000 * SPEED));
    assert_eq!(at(500), (450, 1_000 * SPEED));
    assert_eq!(at(950), (900, 1_000 * SPEED));
    assert_eq!(at(1_050), (975, 500 * SPEED));
    assert_eq!(at(1_149).0, 999);
    assert_eq!(at(1_150), (1_000, 0));
    assert_eq!(trace[50].acceleration, 10_000);
    assert_eq!(trace[500].acceleration, 0);
    assert_eq!(trace[1_100].acceleration, -5_000);
    assert!(planner.done());
}

#[test]
fn a_short_move_is_a_triangle() {
    let mut planner = Planner::at(1_000);
    planner.move_to(900, limits(1_000_000, 10_000, 10_000));
    let trace = run(&mut planner, 200);
    // Half the way and half the time to be quick: 50 units, 0.1 s, 1000 units/s.
    assert_eq!((trace[99].position, trace[99].velocity), (950, -1_000 * SPEED));
    assert_eq!((trace[199].position, trace[199].velocity), (900, 0));
}

#[test]
fn one_unit_takes_the_time_of_a_triangle() {
    let mut planner = Planner::at(0);
    planner.move_to(1, limits(1_000, 4, 4));
    // Half a unit each: 0.5 = a t² / 2, so 0.5 s each.
    assert_eq!(time(&mut planner, MS), 1_000);
}

#[test]
fn braking_is_where_arithmetic_says() {
    let mut planner = Planner::at(0);
    planner.run_at(1_000 * SPEED, limits(0, 10_000, 10_000));
    run(&mut planner, 200);
    assert!(planner.done());
    assert_eq!(planner.point(), Point { position: 150, velocity: 1_000 * SPEED, acceleration: 0 });
    planner.stop(1_000);
    assert_eq!(planner.target(), Some(650), "v² / (2 d) is 500");
    run(&mut planner, 500);
    assert!(planner.point().position.abs_diff(150 + 375) <= 1, "v t - d t² / 2");
    planner.stop(1_000);
    // The first half microsecond, in which the way is taken up, comes on top.
    run(&mut planner, 501);
    assert!(planner.done());
    assert_eq!(planner.point(), Point { position: 650, velocity: 0, acceleration: 0 });
}

#[test]
fn a_speed_of_the_other_sign_is_reached_through_a_halt() {
    let mut planner = Planner::at(0);
    planner.run_at(1_000 * SPEED, limits(0, 10_000, 5_000));
    run(&mut planner, 100);
    planner.run_at(-1_000 * SPEED, limits(0, 10_000, 5_000));
    // 50 units to be quick, 100 to brake; 50 back.
    assert_eq!(run(&mut planner, 200).last().unwrap().position, 150);
    assert_eq!(planner.point().velocity, 0);
    let point = *run(&mut planner, 100).last().unwrap();
    assert_eq!((point.position, point.velocity), (100, -1_000 * SPEED));
    assert!(planner.done());
}

#[test]
fn a_target_that_lies_too_near_is_reached_from_behind() {
    let mut planner = Planner::at(0);
    planner.run_at(1_000 * SPEED, limits(0, 10_000, 10_000));
    run(&mut planner, 100);
    planner.move_to(60, limits(1_000, 10_000, 10_000));
    let trace = run(&mut planner, 1_000);
    assert_eq!(trace.iter().map(|p| p.position).max(), Some(100), "50 units to brake");
    assert_eq!(trace[99].velocity, 0);
    assert!(planner.done());
    assert_eq!(planner.point().position, 60);
}

#[test]
fn hold_and_seed_take_over() {
    let mut planner = Planner::at(0);
    planner.seed(500, -250 * SPEED);
    assert!(planner.done());
    assert_eq!(planner.step(MS * 1_000).position, 250);
    planner.hold(7);
    assert_eq!(planner.step(MS), Point { position: 7, velocity: 0, acceleration: 0 });
    assert!(planner.done());
}

/// A move of a random length from rest, with what may be asked of it: never beyond, never back, never too fast, there.
fn proper_move(random: &mut Lcg) {
    let start = random.between(-1_000_000_000, 1_000_000_000);
    let longest = 1 << random.between(1, 28);
    let target = start + random.between(0, longest) * random.sign();
    let velocity = random.between(1_000_000, 1_000_000_000);
    let (a, d) = (random.between(1_000_000, 1_000_000_000), random.between(1_000_000, 1_000_000_000));
    let asked = limits(velocity, a, d);
    let dt = random.step();
    let mut planner = Planner::at(start);
    planner.move_to(target, asked);
    let mut before = planner.point();
    for _ in 0..2_000_000 {
        let now = planner.step(dt);
        let forward = (target - start).signum();
        assert!((now.position - before.position) * forward >= 0, "never back");
        assert!((target - now.position) * forward >= 0, "never beyond");
        assert!(now.velocity.abs() <= asked.velocity + 1, "{now:?} {asked:?}");
        steady(before, now, a.max(d), dt);
        before = now;
        if planner.done() {
            break;
        }
    }
    assert_eq!(before, Point { position: target, velocity: 0, acceleration: 0 });
}

/// The speed does not change by more than the acceleration says, to a thousandth and a step of it.
fn steady(before: Point, now: Point, acceleration: i64, dt: Duration) {
    let change = i128::from((now.velocity - before.velocity).abs());
    let most = i128::from(acceleration) * i128::from(SPEED) * i128::from(motion::ticks(dt))
        / i128::from(motion::TICKS);
    let slack = 8 + most / 1_000 + i128::from(before.velocity.abs()) / 1_000;
    assert!(change <= most + slack, "{change} of {most}: {before:?} {now:?}");
}

#[test]
fn moves_are_proper() {
    let mut random = Lcg::new(1);
    (0..2_000).for_each(|_| proper_move(&mut random));
}

#[test]
fn a_change_of_target_on_the_way_is_steady_and_arrives() {
    let mut random = Lcg::new(2);
    for _ in 0..300 {
        let mut planner = Planner::at(0);
        let (a, d) = (random.between(1_000, 1_000_000_000), random.between(1_000, 1_000_000_000));
        let dt = random.step();
        let mut target = 0;
        let mut before = planner.point();
        for _ in 0..20 {
            target = random.between(-10_000_000, 10_000_000);
            planner.move_to(target, limits(random.between(1_000, 100_000_000), a, d));
            for _ in 0..random.between(1, 200) {
                let now = planner.step(dt);
                steady(before, now, a.max(d), dt);
                before = now;
            }
        }
        planner.move_to(target, limits(10_000_000, 1_000_000_000, 1_000_000_000));
        time(&mut planner, dt);
        assert_eq!(planner.point(), Point { position: target, velocity: 0, acceleration: 0 });
    }
}

#[test]
fn a_target_told_in_each_step_is_reached_without_going_beyond() {
    let mut random = Lcg::new(3);
    for _ in 0..200 {
        let target = random.between(1, 1_000_000_000);
        let (velocity, a) =
            (random.between(target / 20 + 1_000, 1_000_000_000), random.between(10_000_000, 10_000_000_000));
        told_in_each_step(target, velocity, a);
    }
    for _ in 0..40 {
        let (target, a) = (random.between(1, 1_000), random.between(1, 1_000));
        told_in_each_step(target, 1_000, a);
    }
}

fn told_in_each_step(target: i64, velocity: i64, a: i64) {
    let (mut planner, mut steps) = (Planner::at(0), 0);
    while !planner.done() || steps == 0 {
        // Another limit each time, so that the way is found anew.
        planner.move_to(target, limits(velocity + steps % 2, a, a));
        assert!(planner.step(MS).velocity >= 0);
        assert!(planner.place <= Place::at(target), "not by a part of a unit");
        steps += 1;
        assert!(steps < 100_000, "never there: {target} {velocity} {a} {:?}", planner.point());
    }
    assert_eq!(planner.point().position, target);
}

#[test]
fn a_long_way_is_covered_evenly() {
    let mut planner = Planner::at(0);
    // 4.7 hours at a speed that does not divide the way.
    planner.move_to(1 << 24, limits(997, 1_000_000, 1_000_000));
    let mut before = 0;
    while !planner.done() {
        let position = planner.step(MS * 1_000).position;
        assert!(position - before <= 998, "{} at {position}", position - before);
        before = position;
    }
    assert_eq!(before, 1 << 24);
}

#[test]
fn mirrored_moves_are_mirrored() {
    let (mut there, mut back) = (Planner::at(0), Planner::at(0));
    there.move_to(123_457, limits(7_001, 50_003, 30_011));
    back.move_to(-123_457, limits(7_001, 50_003, 30_011));
    while !there.done() {
        let (a, b) = (there.step(MS), back.step(MS));
        assert_eq!(a.velocity, -b.velocity);
        assert!((a.position + b.position).abs() <= 1);
    }
    assert!(back.done());
}

#[test]
fn the_length_of_a_step_does_not_change_the_way() {
    let duration = |dt: Duration| {
        let mut planner = Planner::at(0);
        planner.move_to(100_000, limits(70_000, 1_000_000, 2_000_000));
        u32::try_from(time(&mut planner, dt)).unwrap() * dt
    };
    let fine = duration(Duration::from_nanos(62_500));
    assert!(duration(MS * 4).abs_diff(fine) <= MS * 4);
    assert!(duration(MS).abs_diff(fine) <= MS);
}

#[test]
fn the_ends_of_the_numbers_are_held() {
    let wild = [i64::MIN, i64::MIN + 1, -(1 << 40), -1, 0, 1, 1 << 40, i64::MAX - 1, i64::MAX];
    for start in wild {
        for target in wild {
            for value in wild {
                let mut planner = Planner::at(start);
                let limits = Limits { velocity: value, acceleration: target, deceleration: start };
                planner.move_to(target, limits);
                run(&mut planner, 3);
                planner.run_at(value, limits);
                planner.step(MS * 2_000);
                planner.move_to(start, limits);
                planner.step(MS * 999);
                planner.stop(value);
                planner.step(MS);
                planner.seed(start, value);
                planner.move_to(target, Limits { velocity: 1, acceleration: 1, deceleration: 1 });
                planner.step(MS);
            }
        }
    }
}

#[test]
fn i32_from_end_to_end_arrives() {
    let mut planner = Planner::at(i64::from(i32::MIN));
    planner.move_to(i64::from(i32::MAX), limits(1 << 31, 1 << 31, 1 << 31));
    // 1 s to be quick, 1 s to brake, 2^31 units in each second and half of that in a ramp.
    let steps = time(&mut planner, MS);
    assert_eq!(steps, 3_000);
    assert_eq!(planner.point().position, i64::from(i32::MAX));
}

#[test]
fn a_slope_is_exact_and_turns() {
    let mut slope = Slope::at(0);
    // 250 in a second: one each 4 ms.
    for ms in 1..=40 {
        assert_eq!(i64::from(slope.step(10, 250, MS)), ms / 4);
    }
    assert!(slope.done(10));
    for _ in 0..80 {
        slope.step(-10, 250, MS);
    }
    assert_eq!(slope.value(), -10);
    assert_eq!(Slope::at(i32::MIN).step(i32::MAX, i64::MAX, MS), i32::MIN + 1_099_511_627);
    assert_eq!(Slope::at(5).step(9, 0, MS), 5, "without a slope it stays");
    assert_eq!(Slope::at(5).step(9, -1, MS), 5);
}
