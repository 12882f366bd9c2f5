//! Words, transitions, option codes and modes, of numbers that come from outside.

use core::hint::black_box;

use core::time::Duration;
use drivewright_runtime::cia402::{
    Cause, Command, Controlword, HomingState, Mode, Options, State, Statusword, StopOption, Transition,
};
use drivewright_runtime::time::Instant;

fn words() {
    let status = Statusword(black_box(0x0237));
    black_box((status.state().map(State::word), status.is_remote(), HomingState::of(status).word()));
    let control = Controlword(black_box(0x000F));
    black_box(control.with_command(Command::FaultReset).with_mode_bits(black_box(0x0110)));
    black_box(control.level().map(Command::word));
}

fn transitions() {
    let options = Options { quick_stop_stays: black_box(true), fault_persists: black_box(false) };
    let (word, before) = (Controlword(black_box(0x80)), Controlword(black_box(0)));
    for state in black_box(State::ALL).iter().copied() {
        black_box((state.pattern(), state.is_powered(), state.is_fault()));
        let command = Transition::command(state, word, before);
        for cause in
            [Some(Cause::Fault), Some(Cause::Done), command.map(Cause::Command)].into_iter().flatten()
        {
            black_box(Transition::of(state, cause, options).map(|made| (made.number(), made.to())));
        }
    }
}

fn options() {
    let code = black_box(i16::MIN);
    black_box((StopOption::quick_stop(code), StopOption::disable(code)));
    black_box((StopOption::halt(code), StopOption::fault(code)));
    let mode = Mode(black_box(i8::MIN));
    black_box((mode.name(), mode.supported_bit(), mode.is_cyclic()));
}

fn time() {
    let (now, span) = (Instant::from_micros(black_box(u64::MAX)), Duration::from_millis(black_box(u64::MAX)));
    black_box((now.after(span), now.since(now.after(span)), now.micros()));
}

/// Everything of this file.
pub fn run() {
    words();
    transitions();
    options();
    time();
}
