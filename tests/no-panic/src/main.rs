//! What firmware calls in a control loop, in a program whose panic handler names a function that does not exist.
//!
//! It links only if the optimizer finds that nothing here can panic. It is built, not run.
#![no_std]
#![no_main]

mod axis;
mod cia402;
mod client;
#[cfg(feature = "drive")]
mod drive;
mod objects;
mod procedure;
mod services;
mod tables;

use core::panic::PanicInfo;

/// Where the program would begin.
#[no_mangle]
pub extern "C" fn _start() -> ! {
    objects::run();
    cia402::run();
    tables::run();
    procedure::run();
    services::run();
    let _ = axis::run(&mut tables::Lines(0));
    client::run(procedure::Anything);
    #[cfg(feature = "drive")]
    drive::run(core::hint::black_box(&mut [0; 16]));
    #[cfg(feature = "planted")]
    planted(core::hint::black_box(&[1, 2, 3]), core::hint::black_box(5));
    #[allow(clippy::empty_loop)]
    loop {}
}

/// The negative control: with it the program must not link.
#[cfg(feature = "planted")]
fn planted(bytes: &[u8], at: usize) {
    core::hint::black_box(bytes[at]);
}

extern "C" {
    fn something_in_the_runtime_can_panic() -> !;
}

/// Divisions of 128 bits come from a library that was built to unwind: it names this, and does not call it.
#[no_mangle]
extern "C" fn rust_eh_personality() {}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    // Never runs: the program does not link if this is reachable.
    unsafe { something_in_the_runtime_can_panic() }
}
