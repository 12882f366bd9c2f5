//! The calls of a client, on a bus that answers as it likes.

use core::fmt::Write;
use core::hint::black_box;
use core::time::Duration;

use drivewright_runtime::cia402::{Mode, State};
use drivewright_runtime::client::axis::AxisPolicy;
use drivewright_runtime::client::drive::Drive;
use drivewright_runtime::client::home::Homing;
use drivewright_runtime::client::image::Image;
use drivewright_runtime::client::moves::MoveTo;
use drivewright_runtime::client::session::Client;
use drivewright_runtime::client::units::Amount;
use drivewright_runtime::transport::Transport;
use drivewright_runtime::Address;
use savch_sdv3_e::{alarms, MODEL};

use crate::tables::Lines;

fn one<T: Transport>(drive: &mut Drive<'static, T>, lines: &mut Lines) -> bool
where
    T::Error: core::fmt::Display,
{
    let (amount, within) = (Amount::from(black_box(1)), Duration::from_micros(black_box(u64::MAX)));
    let ended = match black_box(0_u8) {
        0 => drive.enable(Mode(black_box(8))),
        1 => drive.disable(),
        2 => drive.shutdown(),
        3 => drive.reach(State::SwitchedOn),
        4 => drive.quick_stop(),
        5 => drive.resume(),
        6 => drive.reset_fault(),
        7 => drive.select_mode(Mode(black_box(8))),
        8 => drive.halt(black_box(true)),
        9 => drive.home(Homing::method(black_box(1)).within(within)),
        10 => drive.move_to(MoveTo::to(amount).within(within)),
        11 => drive.velocity(amount, within),
        12 => drive.torque(amount, within),
        13 => drive.jog(amount, within, || black_box(true)),
        14 => drive.write(Address::new(black_box(0x6081), black_box(0)), amount),
        15 => drive.read(Address::new(black_box(0x6081), black_box(0))).map(|number| _ = black_box(number)),
        16 => match drive.fault(&alarms::ALARM_TEXTS) {
            Ok(fault) => return fault.map_or(true, |fault| write!(lines, "{fault}").is_ok()),
            Err(error) => Err(error),
        },
        _ => drive.cycle().map(|sample| _ = black_box(sample)),
    };
    ended.map_or_else(|error| write!(lines, "{error}").is_ok(), |()| true)
}

/// Everything of this file.
pub fn run<T: Transport>(bus: T)
where
    T::Error: core::fmt::Display,
{
    let Ok(image) = Image::of(&MODEL, black_box(0x1600), black_box(0x1A00)) else { return };
    let client = Client::new(&MODEL, image, AxisPolicy::default());
    let (mut drive, mut lines) = (Drive::new(client, bus), Lines(0));
    while black_box(true) && one(&mut drive, &mut lines) {}
}
