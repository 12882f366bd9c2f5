//! The cyclic machine of the client, with samples that are whatever they are.

use core::hint::black_box;
use core::time::Duration;

use drivewright_runtime::cia402::{Mode, Statusword};
use drivewright_runtime::client::axis::{Axis, AxisPolicy, Progress, Sample, SetPoint};

use crate::tables::Lines;

fn begin(axis: &mut Axis) {
    let (number, within) = (black_box(0_i32), Duration::from_micros(black_box(u64::MAX)));
    match black_box(0_u8) {
        0 => axis.enable(Mode(black_box(8))),
        1 => axis.enable_with_target(number),
        2 => axis.disable(),
        3 => axis.quick_stop(),
        4 => axis.resume(),
        5 => axis.reset_fault(),
        6 => axis.select_mode(Mode(black_box(8))),
        7 => axis.move_to(SetPoint::to(number), within),
        8 => axis.velocity(number, within),
        9 => axis.torque(black_box(0), within),
        10 => axis.home(within),
        11 => axis.halt(black_box(true)),
        12 => axis.set_maker_bits(black_box(0xFFFF)),
        13 => _ = black_box(axis.target_position(number)),
        14 => _ = black_box(axis.target_velocity(number)),
        15 => _ = black_box(axis.target_torque(black_box(0))),
        _ => {
            let states = drivewright_runtime::cia402::State::ALL;
            states.iter().skip(black_box(1)).take(1).for_each(|state| axis.reach(*state));
        }
    }
}

fn sample() -> Option<Sample> {
    let sample = Sample {
        mode: black_box(Some(Mode(1))),
        position: black_box(Some(1)),
        velocity: black_box(Some(1)),
        torque: black_box(Some(1)),
        error_code: black_box(Some(1)),
        ..Sample::new(Statusword(black_box(0x0237)))
    };
    black_box(true).then_some(sample)
}

/// Everything of this file.
pub fn run(lines: &mut Lines) -> core::fmt::Result {
    use core::fmt::Write;
    let mut policy = AxisPolicy::default();
    let times =
        [&mut policy.state_within, &mut policy.mode_within, &mut policy.edge_hold, &mut policy.stale_after];
    times.into_iter().for_each(|time| *time = Duration::from_micros(black_box(u64::MAX)));
    (policy.latency, policy.seed_limit) = (black_box(u8::MAX), black_box(u32::MAX));
    policy.step_limits.position = black_box(Some(u32::MAX));
    let mut axis = Axis::new(policy);
    while black_box(true) {
        begin(&mut axis);
        black_box(axis.step(Duration::from_micros(black_box(u64::MAX)), sample()));
        write!(lines, "{}", axis.feedback())?;
        if let Progress::Failed(error) = axis.progress() {
            write!(lines, "{error}")?;
        }
    }
    Ok(())
}
