//! Homing programs of all drives and of CiA 402, run event by event and on the axis of the simulation in steps of time:
//! both latch the same place, or fail in the same way.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod events;
mod programs;
mod timed;

use drivewright_runtime::homing::interpreter::{Failure, StartError};
use drivewright_runtime::homing::{HomingDesc, Step};
use drivewright_runtime::sim::plant::{Band, Switches};
use drivewright_tests::random::Random;

/// Counts of a revolution.
const REVOLUTION: i64 = 131_072;

/// Where the axis ends: three revolutions from the middle.
const STOP: i64 = 3 * REVOLUTION;

/// Speeds in counts per second, and the deceleration of both in counts per square second.
const FAST: i64 = 5 * REVOLUTION;
const SLOW: i64 = 2 * REVOLUTION;
const BRAKE: i64 = 200 * REVOLUTION;

/// How homing ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Outcome {
    /// Home is there, or where it was.
    Home(Option<i64>),
    /// The program cannot go on.
    Failed(Failure),
    /// The axis runs against a hard stop that the program does not wait for.
    Struck,
    /// The program never ends.
    Endless,
}

/// An axis and a place on it to start from.
#[derive(Clone, Copy, Debug)]
struct Scene {
    switches: Switches,
    start: i64,
}

impl Scene {
    /// A random one: a home switch that is active to one side or in the middle, an index pulse anywhere or on an edge, a
    /// start anywhere or beside an edge.
    fn random(random: &mut Random) -> Self {
        let mut between = |low: i64, high: i64| {
            let width = usize::try_from(high - low).expect("low is below high");
            low + i64::try_from(random.below(width)).expect("it is below a width")
        };
        let limit = |at: i64| at * REVOLUTION / 100;
        let (low, high) = (between(limit(-280), limit(-240)), between(limit(240), limit(280)));
        let edge = between(limit(-200), limit(100));
        let width = between(limit(2), limit(100));
        let band = match between(0, 3) {
            0 => Band::above(edge),
            1 => Band::below(edge),
            _ => Band::new(edge, edge + width),
        };
        let edges = [low, high, edge, edge + width];
        let mut on_edge = || edges[usize::try_from(between(0, 4)).expect("it is positive")];
        let (index, start) = (on_edge().rem_euclid(REVOLUTION), on_edge());
        let index = if between(0, 4) == 0 { index } else { between(0, REVOLUTION) };
        let start = if between(0, 4) == 0 { start - between(0, 2) } else { between(limit(-295), limit(295)) };
        let switches = Switches {
            negative_limit: Some(low),
            positive_limit: Some(high),
            home: [band, Band::default()],
            revolution: REVOLUTION,
            index: Some(index),
        };
        Self { switches, start }
    }
}

/// What both ways say of a scene; `None` where it hangs on the way that braking takes. That differs: the axis may brake
/// before it has its speed, and lags behind a little.
fn agreed(method: &HomingDesc<'_>, scene: Scene) -> Option<Result<Outcome, StartError>> {
    let exact = |percent: i64| {
        let way = |speed: i64| speed * speed / BRAKE / 2 * percent / 100;
        events::home(method, scene, events::Ways { fast: way(FAST).max(1), slow: way(SLOW).max(1) })
    };
    let expected = exact(100);
    // A program that takes the place of rest as home knows it to the way of braking only.
    let slack = if rests(method) { FAST * FAST / BRAKE } else { 0 };
    if [0, 25, 50, 75, 125].into_iter().any(|percent| !same(exact(percent), expected, slack)) {
        return None;
    }
    let found = timed::home(method, scene);
    assert!(same(found, expected, slack), "method {}: {found:?} {expected:?} {scene:?}", method.number());
    Some(expected)
}

fn rests(method: &HomingDesc<'_>) -> bool {
    method.cases().iter().any(|case| case.moves().0.contains(&Step::Stop))
}

/// Whether two runs end alike, homes so many counts apart at most.
fn same(a: Result<Outcome, StartError>, b: Result<Outcome, StartError>, slack: i64) -> bool {
    match (a, b) {
        (Ok(Outcome::Home(Some(a))), Ok(Outcome::Home(Some(b)))) => (a - b).abs() <= slack,
        _ => a == b,
    }
}

/// Runs each method in so many scenes; gives how many ended at a home, ended otherwise and were left out.
fn run(methods: &[HomingDesc<'_>], scenes: usize) -> (usize, usize, usize) {
    let (mut random, mut home, mut other, mut out) = (Random::new(402), 0, 0, 0);
    for method in methods.iter().filter(|method| !method.cases().is_empty()) {
        for _ in 0..scenes {
            match agreed(method, Scene::random(&mut random)) {
                Some(Ok(Outcome::Home(_))) => home += 1,
                Some(_) => other += 1,
                None => out += 1,
            }
        }
    }
    (home, other, out)
}

#[test]
fn methods_of_drives_latch_the_same_place_in_events_and_in_time() {
    for (name, methods) in programs::drives() {
        let (home, other, out) = run(&methods, 60);
        assert!(home > 0, "{name}");
        assert!(
            out * 5 < home + other,
            "{name}: {out} scenes hang on the way that braking takes, {home} {other}"
        );
    }
}

#[test]
fn methods_of_the_standard_latch_the_same_place_in_events_and_in_time() {
    let methods = programs::standard();
    assert_eq!(methods.len(), 37);
    let (home, other, out) = run(&methods, 60);
    assert!(home > 500, "{home} {other} {out}");
    assert!(out * 5 < home + other, "{out} scenes hang on the way that braking takes, {home} {other}");
}

/// Places that were worked out by hand: an axis with its home switch from 10,000 to 20,000, limits at -100,000 and at
/// 100,000, and an index pulse at 5000 of each 32,768 counts.
#[test]
fn methods_of_the_sdv3_e_find_the_home_that_a_drawing_shows() {
    let switches = Switches {
        negative_limit: Some(-100_000),
        positive_limit: Some(100_000),
        home: [Band::new(10_000, 20_000), Band::default()],
        revolution: 32_768,
        index: Some(5_000),
    };
    let (_, methods) =
        programs::drives().into_iter().find(|(name, _)| name == "savch-sdv3-e").expect("it is there");
    let home = |number: i8, start: i64| {
        let own = |number: i8| methods.iter().find(|m| m.number() == number).expect("it is there");
        let method = own(number).same().map_or(own(number), own);
        agreed(method, Scene { switches, start }).expect("it does not hang on the way of braking")
    };
    let at = |place: i64| Ok(Outcome::Home(Some(place)));
    // Pulses: ... -93,304, -60,536, -27,768, 5000, 37,768 ...
    for start in [-50_000, 0, 50_000, -110_000] {
        assert_eq!(home(1, start), at(-93_304), "right of the negative limit, from {start}");
        assert_eq!(home(17, start), at(-100_000), "the limit itself, from {start}");
    }
    for start in [-50_000, 9_999, 10_000, 15_000] {
        assert_eq!(home(3, start), at(5_000), "left of the edge, from {start}");
        assert_eq!(home(7, start), at(5_000), "the same as 3, from {start}");
        assert_eq!(home(19, start), at(10_000), "the edge itself, from {start}");
        assert_eq!(home(35, start), at(start), "where it stands");
    }
    // The manual has no reversal at the limit: from beyond the switch the axis runs against its stop.
    assert_eq!(home(3, 50_000), Ok(Outcome::Struck));
    let stated = Failure::NotStated { case: 1, step: 2 };
    assert_eq!(home(36, 0), Ok(Outcome::Failed(stated)));
    assert_eq!(home(37, 0), Ok(Outcome::Failed(stated)));
}
