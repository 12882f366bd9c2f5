//! A server's nonsense: wrong lengths, absurd values, words of no state, no answer. Everything ends, nothing panics.

use core::time::Duration;

use drivewright_runtime::abort::AbortCode;
use drivewright_runtime::cia402::{Mode, State, Statusword};
use drivewright_runtime::client::axis::{Axis, AxisPolicy, Progress, Request, Sample, SetPoint};
use drivewright_runtime::client::error::{ClientError, DriveError};
use drivewright_runtime::client::home::Homing;
use drivewright_runtime::client::image::{Image, ImageError};
use drivewright_runtime::client::moves::MoveTo;
use drivewright_runtime::client::object::Cause;
use drivewright_runtime::client::session::{Client, Operation, Plan, Step};
use drivewright_runtime::prelude::*;
use drivewright_runtime::procedure::{Answer, Ask, Procedure};
use drivewright_runtime::time::Instant;

use crate::bus::{drive, Faults, MODEL, RX, TX};
use crate::fake::{Fake, CYCLE};

/// Numbers that look like chance and are the same in every run.
struct Chance(u64);

impl Chance {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn of<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.next() as usize % list.len()]
    }

    fn sample(&mut self) -> Option<Sample> {
        let words = [0x0250, 0x0231, 0x0233, 0x0237, 0x0217, 0x0218, 0x021F, 0x0000, self.next() as u16];
        let bits = self.next() as u16 & 0x3C80;
        let number = self.of(&[0, 1, -1, i32::MAX, i32::MIN, self.0 as i32]);
        let sample = Sample {
            statusword: Statusword(self.of(&words) ^ bits),
            mode: self.of(&[None, Some(Mode(self.0 as i8)), Some(Mode::HOMING), Some(Mode::CYCLIC_POSITION)]),
            position: self.of(&[None, Some(number), Some(0)]),
            velocity: Some(number),
            torque: Some(number as i16),
            error_code: self.of(&[None, Some(number as u16)]),
        };
        self.of(&[Some(sample), Some(sample), Some(sample), None])
    }

    fn request(&mut self) -> Request {
        let mode = Mode(self.of(&[0, 1, 3, 4, 6, 8, 9, 10, 11, -1, 127]));
        let number = self.of(&[0, i32::MAX, i32::MIN, 7]);
        let within = self.of(&[Duration::ZERO, CYCLE, Duration::from_secs(1)]);
        let state = State::ALL[self.next() as usize % State::ALL.len()];
        let set_point = SetPoint { target: number, relative: number > 0, immediately: number < 0 };
        let requests = [
            Request::Enable(mode),
            Request::EnableWithTarget(number),
            Request::Reach(state),
            Request::Disable,
            Request::Shutdown,
            Request::QuickStop,
            Request::Resume,
            Request::ResetFault,
            Request::SelectMode(mode),
            Request::MoveTo(set_point, within),
            Request::Velocity(number, within),
            Request::Torque(number as i16, within),
            Request::Home(within),
        ];
        self.of(&requests)
    }
}

#[test]
fn an_axis_takes_everything() {
    for seed in 0..300 {
        let mut chance = Chance(seed);
        let mut axis = Axis::new(AxisPolicy::default());
        for _ in 0..50 {
            let request = chance.request();
            axis.start(request);
            let ends = (0..6_000).any(|_| {
                let (position, torque) = (chance.next() as i32, chance.next() as i16);
                let _ = (axis.target_position(position), axis.target_torque(torque));
                let outputs = axis.step(CYCLE, chance.sample());
                let powers = outputs.controlword.enable_operation();
                let asked =
                    matches!(request, Request::Enable(_) | Request::EnableWithTarget(_) | Request::Resume)
                        || request == Request::Reach(State::OperationEnabled);
                assert!(!powers || asked || axis.is_enabled(), "{request:?}");
                axis.progress() != Progress::Pending
            });
            assert!(ends, "{request:?} is {:?} after six seconds", axis.progress());
        }
    }
}

#[test]
fn an_operation_takes_everything() {
    let layouts =
        [Image::new(&RX, &TX).unwrap(), Image::new(&[], &[]).unwrap(), Image::new(&RX[..1], &[]).unwrap()];
    for seed in 0..900 {
        let mut chance = Chance(seed);
        let mut client = Client::new(&MODEL, chance.of(&layouts), AxisPolicy::default());
        let mut now = 0;
        for _ in 0..5 {
            let mut asked = 0;
            let mut hold = || {
                asked += 1;
                asked % 7 != 0
            };
            let plan = Plan::EMPTY
                .then(Step::NeedResettable)
                .then(Step::Set(Address::new(0x6081, 0), i64::from(chance.next() as u16)))
                .then(Step::Hold(CYCLE * 20))
                .then(Step::Goal(chance.request()))
                .then(Step::RestoreMode);
            let mut operation = Operation::new(&mut client, plan).while_held(&mut hold);
            let mut answers = 0;
            while !is_done(&mut operation, &mut chance, &mut now) {
                answers += 1;
                assert!(answers < 100_000, "seed {seed}");
            }
        }
    }
}

/// One more answer, of whatever kind.
fn is_done(operation: &mut Operation<'_, '_>, chance: &mut Chance, now: &mut u64) -> bool {
    *now += chance.of(&[1, 100, 1_000, 10_000]);
    let bytes: Vec<u8> = (0..chance.of(&[0, 1, 2, 4, 7, 8, 13, 200])).map(|_| chance.next() as u8).collect();
    let answer = match chance.next() % 12 {
        0 => Answer::NoAnswer,
        1 => Answer::TooLong,
        2 => Answer::Abort(AbortCode(chance.next() as u32)),
        3 => Answer::Begin,
        4..=6 => Answer::Written,
        7..=9 => Answer::Inputs(&bytes),
        _ => Answer::Data(&bytes),
    };
    matches!(operation.next(Instant::from_micros(*now), answer), Ask::Done(_))
}

fn all_calls(faults: Faults) -> Vec<DriveError<&'static str>> {
    let fresh = || {
        let mut drive = drive(Fake::new(State::SwitchOnDisabled));
        drive.enable(Mode::PROFILE_POSITION).unwrap();
        drive.client_mut().forget();
        drive.bus().faults = faults;
        drive
    };
    let second = Duration::from_secs(1);
    let errors = [
        fresh().enable(Mode::CYCLIC_POSITION).err(),
        fresh().disable().err(),
        fresh().quick_stop().err(),
        fresh().select_mode(Mode::HOMING).err(),
        fresh().reset_fault().err(),
        fresh().home(Homing::method(1)).err(),
        fresh().move_to(MoveTo::to(1)).err(),
        fresh().velocity(1, second).err(),
        fresh().cycle().err(),
    ];
    errors.into_iter().flatten().collect()
}

#[test]
fn a_mute_server_is_a_typed_error() {
    let errors = all_calls(Faults { mute: true, ..Faults::default() });
    assert!(!errors.is_empty());
}

#[test]
fn a_server_that_refuses_everything_is_a_typed_error() {
    let errors = all_calls(Faults { refuses: true, ..Faults::default() });
    assert_eq!(errors.len(), 9);
    let refused = |error: &DriveError<_>| matches!(error, DriveError::Client(ClientError::Access(access)) if access.cause == Cause::Abort(AbortCode::NO_OBJECT));
    assert!(errors.iter().all(refused), "{errors:?}");
}

#[test]
fn answers_of_a_wrong_length_are_typed_errors() {
    for bytes in [0, 1, 3, 7, 8, 255] {
        let errors = all_calls(Faults { answer_bytes: Some(bytes), ..Faults::default() });
        assert_eq!(errors.len(), 9, "{bytes}");
        let wrong = |error: &DriveError<_>| matches!(error, DriveError::Client(ClientError::Access(access)) if matches!(access.cause, Cause::Wire(_)));
        assert!(errors.iter().all(wrong), "{errors:?}");
    }
}

#[test]
fn process_data_of_a_wrong_length_are_a_typed_error() {
    for bytes in [0, 1, 6, 8, 256, 300] {
        let mut drive = drive(Fake::new(State::SwitchOnDisabled));
        drive.bus().faults.frame_bytes = Some(bytes);
        let error = drive.enable(Mode::CYCLIC_VELOCITY).unwrap_err();
        match error {
            DriveError::Client(ClientError::Image(ImageError::Length { expected: 7, found })) => {
                assert_eq!(found, bytes);
            }
            // Longer than there is room for: it comes as no answer.
            DriveError::Client(ClientError::Axis(_)) => assert_eq!(bytes, 300),
            other => panic!("{bytes}: {other:?}"),
        }
        assert!(drive.bus().fake.transitions.is_empty());
    }
}

#[test]
fn a_cable_that_is_off_is_the_error_of_the_bus() {
    let mut drive = drive(Fake::new(State::SwitchOnDisabled));
    drive.bus().faults.cut_after = Some(3);
    assert_eq!(drive.enable(Mode::CYCLIC_VELOCITY), Err(DriveError::Link("the cable is off")));
}
