//! Switches and the index pulse: levels, and edges at their own place.

use super::*;
use crate::homing::{Event, Signal};
use crate::sim::lcg::Lcg;
use std::vec::Vec;
use Side::{Negative, Positive};

const fn at(event: Event, position: i64, direction: Side) -> Crossing {
    Crossing { event, position, direction }
}

fn with(switches: Switches) -> PlantConfig {
    PlantConfig { switches, ..bare() }
}

/// All that is crossed in a time.
fn crossed(axis: &mut Plant, setpoint: Setpoint, time: Duration, dt: Duration) -> Vec<Crossing> {
    let (mut gone, mut all) = (Duration::ZERO, Vec::new());
    while gone < time {
        axis.step(setpoint, dt);
        assert!(!axis.crossed_more());
        all.extend_from_slice(axis.crossings());
        gone += dt;
    }
    all
}

#[test]
fn an_edge_lies_between_two_counts_from_both_sides() {
    let home = [Band::new(100, 200), Band::default()];
    let switches = Switches { negative_limit: Some(-50), positive_limit: Some(250), home, ..Switches::NONE };
    let levels = |count| {
        let seen = switches.levels(count);
        (seen.negative_limit, seen.home, seen.positive_limit)
    };
    assert_eq!(levels(-51), (true, false, false));
    assert_eq!(levels(-50), (false, false, false));
    assert_eq!(levels(99), (false, false, false));
    assert_eq!(levels(100), (false, true, false));
    assert_eq!(levels(199), (false, true, false));
    assert_eq!(levels(200), (false, false, false));
    assert_eq!(levels(249), (false, false, false));
    assert_eq!(levels(250), (false, false, true));

    let (on, off) = (Event::on(Signal::Home), Event::off(Signal::Home));
    for dt in STEPS {
        let mut axis = axis(with(switches));
        let there = crossed(&mut axis, torque(1_000), MS * 24, dt);
        // 1,000,000 t² / 2: 100 counts at 14.1 ms, 200 at 20 ms, 250 at 22.4 ms.
        let limit = |on, side| at(Event::Switch(Signal::PositiveLimit, on), 250, side);
        assert_eq!(there, [at(on, 100, Positive), at(off, 200, Positive), limit(true, Positive)], "{dt:?}");
        assert!(axis.levels().positive_limit);
        let back = crossed(&mut axis, torque(-2_000), MS * 52, dt);
        let lower = at(Event::on(Signal::NegativeLimit), -50, Negative);
        assert_eq!(
            back,
            [limit(false, Negative), at(on, 200, Negative), at(off, 100, Negative), lower],
            "{dt:?}"
        );
    }
}

#[test]
fn an_index_pulse_comes_once_in_each_revolution() {
    let mut axis = axis(with(Switches { revolution: 1_000, index: Some(375), ..Switches::NONE }));
    let index = |position, direction| at(Event::Index, position, direction);
    let pulses = crossed(&mut axis, torque(1_000), MS * 80, MS);
    // 3200 counts.
    let expected = [375, 1_375, 2_375].map(|position| index(position, Positive));
    assert_eq!(pulses, expected);
    let pulses = crossed(&mut axis, torque(-1_000), MS * 320, MS);
    // It turns at 6400 and is at -19,200 + 6,400 at the end.
    assert_eq!(pulses.first(), Some(&index(3_375, Positive)));
    assert_eq!(pulses.get(3), Some(&index(5_375 + 1_000, Positive)));
    assert_eq!(pulses.get(4), Some(&index(6_375, Negative)), "the same place from the other side");
    let below: Vec<i64> = pulses.iter().filter(|c| c.position < 0).map(|c| c.position).collect();
    assert_eq!(below.first(), Some(&-625));
    assert!(below.windows(2).all(|pair| pair[0] - pair[1] == 1_000));
}

#[test]
fn an_index_pulse_on_an_edge_comes_after_it() {
    let home = [Band::above(100), Band::default()];
    let mut axis = axis(with(Switches { home, revolution: 1_000, index: Some(100), ..Switches::NONE }));
    let (on, off) = (Event::on(Signal::Home), Event::off(Signal::Home));
    let up = crossed(&mut axis, torque(1_000), MS * 20, MS);
    assert_eq!(up, [at(on, 100, Positive), at(Event::Index, 100, Positive)]);
    let down = crossed(&mut axis, torque(-1_000), MS * 60, MS);
    assert_eq!(down, [at(off, 100, Negative), at(Event::Index, 100, Negative)]);
}

#[test]
fn a_turn_within_a_step_crosses_twice() {
    let home = [Band::above(2), Band::default()];
    let config = with(Switches { home, ..Switches::NONE });
    // 1 ms at 10,000,000: 5 counts, 10,000 counts/s; so from -5 it is at 0.
    let mut axis = axis(PlantConfig { start: -5, acceleration: 10_000_000, torque: 2_000, ..config });
    axis.step(torque(1_000), MS);
    assert_eq!((axis.position(), axis.velocity()), (0, 10_000 * 256));
    assert_eq!(axis.crossings(), []);
    // Against 20,000,000 it turns after 0.5 ms and 2.5 counts, and is at 0 again after 1 ms.
    axis.step(torque(-2_000), MS);
    assert_eq!((axis.position(), axis.velocity()), (0, -10_000 * 256));
    let on = at(Event::on(Signal::Home), 2, Positive);
    let off = at(Event::off(Signal::Home), 2, Negative);
    assert_eq!(axis.crossings(), [on, off]);
}

#[test]
fn bands_that_touch_are_one() {
    let home = [Band::new(10, 20), Band::new(20, 30)];
    let mut axis = axis(with(Switches { home, ..Switches::NONE }));
    let all = crossed(&mut axis, torque(1_000), MS * 20, MS);
    let (on, off) = (Event::on(Signal::Home), Event::off(Signal::Home));
    assert_eq!(all, [at(on, 10, Positive), at(off, 30, Positive)]);
}

#[test]
fn more_than_fits_is_said() {
    let mut axis = axis(with(Switches { revolution: 2, index: Some(0), ..Switches::NONE }));
    run(&mut axis, torque(1_000), MS * 20, MS);
    assert!(axis.crossed_more());
    assert_eq!(axis.crossings().len(), 8);
    run(&mut axis, torque(-1_000), MS * 20, MS);
    axis.step(Setpoint::Off, MS);
    assert!(!axis.crossed_more(), "of the last step only");
}

#[test]
fn crossings_add_up_to_the_levels() {
    let home = [Band::new(-300, 200), Band::new(700, 710)];
    let switches = Switches {
        negative_limit: Some(-2_000),
        positive_limit: Some(705),
        home,
        revolution: 997,
        index: Some(7),
    };
    let mut axis = axis(PlantConfig { lower_stop: -3_000, upper_stop: 3_000, coulomb: 20, ..with(switches) });
    let (mut random, mut seen, mut count) = (Lcg::new(4), axis.levels(), 0);
    let mut drive = 0;
    for n in 0..20_000 {
        if n % 20 == 0 {
            drive = i32::try_from(random.between(-500, 500)).unwrap();
        }
        axis.step(torque(drive), random.step());
        for crossing in axis.crossings() {
            if let Event::Switch(signal, on) = crossing.event {
                assert_ne!(seen.switch(signal), on, "a change each time");
                seen = seen.with(signal, on);
            }
            count += 1;
        }
        seen.standstill = axis.standstill();
        assert_eq!(seen, axis.levels());
    }
    assert!(count > 400, "{count}");
}
