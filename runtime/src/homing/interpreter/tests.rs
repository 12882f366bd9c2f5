//! A test for each rule, on programs of manuals: CiA 402 and SDV3-E (1, 3, 4, 35, 36), IxL (1, 23, 36) and ELD2-CAN (7, -2).

use super::*;
use crate::homing::Signal::{Home, NegativeLimit, PositiveLimit};
use crate::homing::{Pace, Side};
use std::vec::Vec;

const METHOD_1: HomingDesc<'static> = HomingDesc::new(1).with_cases(&[
    HomingCase::new(
        &[Level::off(NegativeLimit)],
        &[
            Step::fast(Side::Negative, Event::on(NegativeLimit)),
            Step::slow(Side::Positive, Event::off(NegativeLimit)),
            Step::slow(Side::Positive, Event::Index),
            Step::Latch,
        ],
    ),
    HomingCase::new(
        &[Level::on(NegativeLimit)],
        &[
            Step::slow(Side::Positive, Event::off(NegativeLimit)),
            Step::slow(Side::Positive, Event::Index),
            Step::Latch,
        ],
    ),
]);

/// Cases 1 and 3 start alike, and a negative limit ends all with an error.
const METHOD_7: HomingDesc<'static> = HomingDesc::new(7).with_cases(&[
    HomingCase::new(
        &[Level::off(Home), Level::off(PositiveLimit)],
        &[
            Step::fast(Side::Positive, Event::on(Home)),
            Step::slow(Side::Negative, Event::off(Home)),
            Step::slow(Side::Negative, Event::Index),
            Step::Latch,
        ],
    )
    .with_abort(&[Level::on(NegativeLimit)]),
    HomingCase::new(
        &[Level::on(Home)],
        &[
            Step::slow(Side::Negative, Event::off(Home)),
            Step::slow(Side::Negative, Event::Index),
            Step::Latch,
        ],
    )
    .with_abort(&[Level::on(NegativeLimit)]),
    HomingCase::new(
        &[Level::off(Home), Level::off(PositiveLimit)],
        &[
            Step::fast(Side::Positive, Event::on(PositiveLimit)),
            Step::fast(Side::Negative, Event::on(Home)),
            Step::slow(Side::Negative, Event::off(Home)),
            Step::slow(Side::Negative, Event::Index),
            Step::Latch,
        ],
    )
    .with_abort(&[Level::on(NegativeLimit)]),
]);

const HOME_OFF: Level = Level::off(Home);

const FAST_UP: Command = Command::Move { direction: Side::Positive, pace: Pace::Fast };
const FAST_DOWN: Command = Command::Move { direction: Side::Negative, pace: Pace::Fast };
const SLOW_UP: Command = Command::Move { direction: Side::Positive, pace: Pace::Slow };
const SLOW_DOWN: Command = Command::Move { direction: Side::Negative, pace: Pace::Slow };

/// An axis that stands, off all switches.
const CLEAR: Levels =
    Levels { negative_limit: false, positive_limit: false, home: false, standstill: true, at_home: false };

fn up(run: &mut Run<'_>, event: Event, position: i64) -> Command {
    run.event(Crossing { event, position, direction: Side::Positive });
    run.command()
}

fn down(run: &mut Run<'_>, event: Event, position: i64) -> Command {
    run.event(Crossing { event, position, direction: Side::Negative });
    run.command()
}

fn rest(run: &mut Run<'_>, position: i64) -> Command {
    run.standstill(position);
    run.command()
}

/// A method with one case that holds at any start.
fn start<'m>(method: &'m HomingDesc<'m>) -> Run<'m> {
    Run::start(method, CLEAR).unwrap()
}

#[test]
fn the_start_chooses_the_case() {
    let off = Run::start(&METHOD_1, CLEAR).unwrap();
    assert_eq!((off.case(), off.command()), (Some(1), FAST_DOWN));
    let on = Run::start(&METHOD_1, CLEAR.with(NegativeLimit, true)).unwrap();
    assert_eq!((on.case(), on.command()), (Some(2), SLOW_UP));
}

#[test]
fn a_move_that_turns_counts_from_its_own_direction_on() {
    let mut run = start(&METHOD_1);
    assert_eq!(down(&mut run, Event::Index, -100), FAST_DOWN, "nobody waits for a pulse yet");
    assert_eq!(down(&mut run, Event::on(NegativeLimit), -500), SLOW_UP);
    // On the way to its turning point the axis passes a pulse and, by a bouncing switch, an edge.
    assert_eq!(down(&mut run, Event::Index, -510), SLOW_UP);
    assert_eq!(down(&mut run, Event::off(NegativeLimit), -520), SLOW_UP);
    assert_eq!(down(&mut run, Event::on(NegativeLimit), -521), SLOW_UP);
    assert_eq!(up(&mut run, Event::Index, -510), SLOW_UP, "before the edge");
    assert_eq!(up(&mut run, Event::off(NegativeLimit), -500), SLOW_UP);
    assert_eq!(run.awaits().collect::<Vec<_>>(), [Event::Index]);
    assert_eq!(up(&mut run, Event::Index, -410), Command::Brake);
    assert_eq!(run.latched(), Some(-410));
    assert_eq!(rest(&mut run, -400), Command::Finished { home: Some(-410) }, "where the pulse was");
}

#[test]
fn a_move_that_goes_on_counts_at_once() {
    let moves =
        [Step::slow(Side::Positive, Event::on(Home)), Step::slow(Side::Positive, Event::Index), Step::Latch];
    let cases = [HomingCase::new(&[HOME_OFF], &moves)];
    let method = HomingDesc::new(4).with_cases(&cases);
    let mut run = start(&method);
    assert_eq!(up(&mut run, Event::on(Home), 100), SLOW_UP);
    assert_eq!(up(&mut run, Event::Index, 100), Command::Brake, "a pulse at the place of the edge");
    assert_eq!(run.latched(), Some(100));
}

#[test]
fn a_change_counts_and_not_a_level() {
    let moves = [Step::fast(Side::Positive, Event::off(Home)), Step::Latch];
    let cases = [HomingCase::new(&[], &moves)];
    let method = HomingDesc::new(-3).with_cases(&cases);
    let mut run = start(&method);
    assert_eq!(run.command(), FAST_UP, "off already, and yet it moves");
    assert_eq!(up(&mut run, Event::on(Home), 10), FAST_UP);
    assert_eq!(up(&mut run, Event::off(Home), 20), Command::Brake);
    assert_eq!(rest(&mut run, 25), Command::Finished { home: Some(20) });
}

#[test]
fn the_first_event_rules_candidates_out() {
    let mut run = start(&METHOD_7);
    assert_eq!((run.case(), run.command()), (None, FAST_UP));
    assert_eq!(run.awaits().collect::<Vec<_>>(), [Event::on(Home), Event::on(PositiveLimit)]);
    let both = run;
    assert_eq!(up(&mut run, Event::on(Home), 300), SLOW_DOWN);
    assert_eq!(run.case(), Some(1));

    let mut run = both;
    assert_eq!(up(&mut run, Event::on(PositiveLimit), 900), FAST_DOWN);
    assert_eq!(run.case(), Some(3));
    assert_eq!(down(&mut run, Event::off(PositiveLimit), 900), FAST_DOWN);
    assert_eq!(down(&mut run, Event::on(Home), 400), SLOW_DOWN);
    assert_eq!(down(&mut run, Event::off(Home), 300), SLOW_DOWN);
    assert_eq!(down(&mut run, Event::Index, 250), Command::Brake);
    assert_eq!(rest(&mut run, 240), Command::Finished { home: Some(250) });
}

#[test]
fn latch_after_stop_takes_the_place_of_rest() {
    let moves = [Step::fast(Side::Negative, Event::on(NegativeLimit)), Step::Stop, Step::Latch];
    let cases = [HomingCase::new(&[], &moves)];
    let method = HomingDesc::new(1).with_cases(&cases);
    let mut run = start(&method);
    assert_eq!(down(&mut run, Event::on(NegativeLimit), -500), Command::Brake);
    assert_eq!(down(&mut run, Event::Index, -505), Command::Brake);
    assert_eq!(rest(&mut run, -530), Command::Finished { home: Some(-530) });
}

#[test]
fn return_goes_back_to_what_was_latched() {
    let moves = [Step::slow(Side::Positive, Event::Index), Step::Latch, Step::Return];
    let cases = [HomingCase::new(&[], &moves)];
    let method = HomingDesc::new(34).with_cases(&cases);
    let mut run = start(&method);
    assert_eq!(up(&mut run, Event::Index, 70), Command::Return { to: 70 });
    assert_eq!(down(&mut run, Event::Index, 70), Command::Return { to: 70 });
    assert_eq!(rest(&mut run, 70), Command::Finished { home: Some(70) });
}

#[test]
fn a_latch_without_an_event_takes_the_place_of_rest() {
    let cases = [HomingCase::new(&[Level::Standstill], &[Step::Latch])];
    let method = HomingDesc::new(35).with_cases(&cases);
    let moving = Levels { standstill: false, ..CLEAR };
    assert_eq!(Run::start(&method, moving), Err(StartError::NoCase), "it wants standstill");
    let mut run = start(&method);
    assert_eq!(run.command(), Command::Brake);
    assert_eq!(rest(&mut run, 77), Command::Finished { home: Some(77) });
}

#[test]
fn what_the_manual_does_not_say_is_told() {
    let moves = [Step::fast(Side::Positive, Event::Stall), Step::NotStated];
    let cases = [HomingCase::new(&[], &moves)];
    let method = HomingDesc::new(36).with_cases(&cases);
    let mut run = start(&method);
    assert_eq!(up(&mut run, Event::on(PositiveLimit), 900), FAST_UP);
    let failure = Failure::NotStated { case: 1, step: 2 };
    assert_eq!(up(&mut run, Event::Stall, 999), Command::Failed(failure));
    assert_eq!(std::format!("{failure}"), "the manual does not say what follows: case 1, step 2");
}

#[test]
fn an_abort_ends_the_run() {
    let mut run = Run::start(&METHOD_7, CLEAR.with(Home, true)).unwrap();
    assert_eq!(down(&mut run, Event::off(Home), 300), SLOW_DOWN);
    assert_eq!(down(&mut run, Event::on(NegativeLimit), -500), Command::Failed(Failure::Aborted { case: 2 }));
    assert!(!run.event(Crossing { event: Event::Index, position: -510, direction: Side::Negative }));
    run.standstill(-520);
    assert_eq!(run.command(), Command::Failed(Failure::Aborted { case: 2 }), "it stays so");
    // A level, not a change: it holds at the start already.
    let run = Run::start(&METHOD_7, CLEAR.with(NegativeLimit, true)).unwrap();
    assert_eq!(run.command(), Command::Failed(Failure::Aborted { case: 1 }));
}

#[test]
fn an_abort_of_one_candidate_leaves_the_other() {
    let first = [Step::fast(Side::Positive, Event::on(Home)), Step::Latch];
    let second =
        [Step::fast(Side::Positive, Event::on(NegativeLimit)), Step::fast(Side::Negative, Event::Index)];
    let abort = [Level::on(PositiveLimit)];
    let cases = [HomingCase::new(&[], &first).with_abort(&abort), HomingCase::new(&[], &second)];
    let method = HomingDesc::new(-1).with_cases(&cases);
    let mut run = start(&method);
    assert_eq!(up(&mut run, Event::on(PositiveLimit), 900), FAST_UP);
    assert_eq!(run.case(), Some(2));
}

#[test]
fn a_masked_signal_has_no_effect() {
    let moves = [Step::fast(Side::Negative, Event::Stall), Step::Latch];
    let abort = [Level::on(NegativeLimit)];
    let cases = [HomingCase::new(&[], &moves).with_abort(&abort).with_mask(&[NegativeLimit, PositiveLimit])];
    let method = HomingDesc::new(36).with_cases(&cases);
    let mut run = start(&method);
    assert_eq!(down(&mut run, Event::on(NegativeLimit), -500), FAST_DOWN);
    assert_eq!(up(&mut run, Event::Stall, -600), FAST_DOWN, "driven in the other direction");
    assert_eq!(down(&mut run, Event::Stall, -600), Command::Brake);
    assert_eq!(rest(&mut run, -600), Command::Finished { home: Some(-600) });
}

#[test]
fn an_axis_at_home_is_the_exception() {
    let search = [Step::fast(Side::Positive, Event::on(Home)), Step::Stop, Step::Latch];
    let other = [
        Step::fast(Side::Positive, Event::on(PositiveLimit)),
        Step::fast(Side::Negative, Event::off(Home)),
        Step::Stop,
        Step::Latch,
    ];
    let cases = [
        HomingCase::new(&[HOME_OFF], &search),
        HomingCase::new(&[HOME_OFF], &other),
        HomingCase::new(&[Level::AtHome], &[Step::Done]),
    ];
    let method = HomingDesc::new(23).with_cases(&cases);
    let run = Run::start(&method, Levels { at_home: true, ..CLEAR }).unwrap();
    assert_eq!((run.case(), run.command()), (Some(3), Command::Finished { home: None }));
    assert_eq!(start(&method).case(), None, "two candidates");
    assert_eq!(Run::start(&method, CLEAR.with(Home, true)), Err(StartError::NoCase));
    // One that still moves comes to rest first.
    let mut run = Run::start(&method, Levels { at_home: true, standstill: false, ..CLEAR }).unwrap();
    assert_eq!(run.command(), Command::Brake);
    assert_eq!(rest(&mut run, 5), Command::Finished { home: None });
}

#[test]
fn torque_and_index_make_a_program_too() {
    let moves = [
        Step::slow(Side::Negative, Event::Torque(true)),
        Step::slow(Side::Positive, Event::Torque(false)),
        Step::slow(Side::Positive, Event::Index),
        Step::Latch,
    ];
    let cases = [HomingCase::new(&[], &moves)];
    let method = HomingDesc::new(-2).with_cases(&cases);
    let mut run = start(&method);
    assert_eq!(down(&mut run, Event::Torque(true), -600), SLOW_UP);
    assert_eq!(down(&mut run, Event::Torque(false), -600), SLOW_UP, "it is still driven down");
    assert_eq!(up(&mut run, Event::Torque(false), -599), SLOW_UP);
    assert_eq!(up(&mut run, Event::Index, -580), Command::Brake);
}

#[test]
fn cases_that_nothing_tells_apart_fail() {
    let (one, other) =
        ([Step::slow(Side::Positive, Event::Index)], [Step::slow(Side::Negative, Event::Index)]);
    let cases = [HomingCase::new(&[], &one), HomingCase::new(&[HOME_OFF], &other)];
    let method = HomingDesc::new(-4).with_cases(&cases);
    let failure = Failure::Parted { case: 1, other: 2, step: 1 };
    assert_eq!(start(&method).command(), Command::Failed(failure));
    assert_eq!(Run::start(&method, CLEAR.with(Home, true)).unwrap().case(), Some(1));
}

#[test]
fn return_without_a_latch_is_not_stated() {
    let cases = [HomingCase::new(&[], &[Step::Return])];
    let method = HomingDesc::new(-5).with_cases(&cases);
    assert_eq!(start(&method).command(), Command::Failed(Failure::NotStated { case: 1, step: 1 }));
}

#[test]
fn what_cannot_start_says_why() {
    let refused = |method: HomingDesc<'_>| Run::start(&method, CLEAR).map(|_| ()).unwrap_err();
    let reserved = HomingDesc::new(15).with_status(HomingStatus::Reserved);
    assert_eq!(refused(reserved), StartError::NotThere(HomingStatus::Reserved));
    assert_eq!(refused(HomingDesc::new(7).with_same(3)), StartError::SameAs(3));
    assert_eq!(refused(HomingDesc::new(7)), StartError::NoCase);
    let many = [HomingCase::new(&[], &[]); 33];
    assert_eq!(refused(HomingDesc::new(-6).with_cases(&many)), StartError::TooManyCases);
}

#[test]
fn runs_that_know_the_same_are_equal() {
    let seen = |pulses: &[i64]| {
        let mut run = start(&METHOD_1);
        for pulse in pulses {
            down(&mut run, Event::Index, *pulse);
        }
        down(&mut run, Event::on(NegativeLimit), -500);
        run.state()
    };
    assert_eq!(seen(&[]), seen(&[-100, -200]), "a pulse that does not count is forgotten");
    assert_ne!(seen(&[]), start(&METHOD_1).state());
}
