//! What the runtime costs: a cycle of the client, a look-up in a dictionary, a second of a virtual drive.

use std::hint::black_box;
use std::time::{Duration, Instant};

use drivewright_runtime::cia402::{Mode, Statusword};
use drivewright_runtime::client::axis::{Axis, AxisPolicy, Outputs, Sample};
use drivewright_runtime::client::image::Image;
use drivewright_runtime::model::EsmState;
use drivewright_runtime::prelude::*;
use drivewright_runtime::sim::{Config, VirtualDrive, cells};
use savch_sdv3_e::MODEL;

/// The fastest of so many rounds counts.
const ROUNDS: usize = 5;
const LOOK_UPS: u32 = 200_000;
const CYCLES: u32 = 200_000;
/// Cycles of the virtual drive, of 1 ms.
const MILLISECONDS: u32 = 10_000;

/// Seconds of the fastest round.
fn fastest(mut round: impl FnMut() -> f64) -> f64 {
    (0..ROUNDS).map(|_| round()).fold(f64::INFINITY, f64::min)
}

/// Seconds that `run` takes, for each of `times`.
fn each(times: u32, run: impl FnOnce()) -> f64 {
    let start = Instant::now();
    run();
    start.elapsed().as_secs_f64() / f64::from(times)
}

/// Seconds to find an entry in a dictionary of so many.
pub fn look_up(entries: u32) -> f64 {
    let address = |n: u32| Address::new(0x2000 + (n >> 8) as u16, n as u8);
    let row = |n| ObjectDesc::new(address(n), DataType::UNSIGNED32, Access::Rw, Mapping::RxTx, "X");
    let objects: Vec<ObjectDesc<'_>> = (0..entries).map(row).collect();
    let model = DriveModel::new(Identity::new("x", "y", "z")).with_objects(&objects);
    fastest(|| {
        each(LOOK_UPS, || {
            let mut n = 1_u32;
            for _ in 0..LOOK_UPS {
                n = n.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                black_box(model.object(black_box(address((n >> 8) % entries))));
            }
        })
    })
}

/// Process data of a cycle by an image whose offsets come at run time, and by hand; and with the machine of CiA 402. In
/// seconds; `None` where the model lacks the layouts.
pub fn cycle() -> Option<[f64; 3]> {
    let image = Image::of(&MODEL, 0x1600, 0x1A00).ok()?;
    let mut frame = [0; 13];
    let by_image = fastest(|| {
        each(CYCLES, || {
            for n in 0..CYCLES as i32 {
                let outputs = Outputs { position: black_box(n), ..Outputs::default() };
                image.pack(&outputs, &mut frame);
                black_box(image.unpack(black_box(&frame)).ok().and_then(|reading| reading.sample()));
            }
        })
    });
    let by_hand = fastest(|| {
        each(CYCLES, || {
            for n in 0..CYCLES as i32 {
                let outputs = Outputs { position: black_box(n), ..Outputs::default() };
                frame = hand_pack(&outputs);
                black_box(hand_unpack(black_box(&frame)));
            }
        })
    });
    let mut axis = Axis::new(AxisPolicy::default());
    axis.enable(Mode::CYCLIC_POSITION);
    let sample = Sample { mode: Some(Mode(8)), position: Some(7), ..Sample::new(Statusword(0x0237)) };
    let whole = fastest(|| {
        each(CYCLES, || {
            for _ in 0..CYCLES {
                let outputs = axis.step(Duration::from_millis(1), black_box(Some(sample)));
                image.pack(&outputs, &mut frame);
                black_box(image.unpack(black_box(&frame)).ok().and_then(|reading| reading.sample()));
            }
        })
    });
    Some([by_image, by_hand, whole])
}

fn hand_pack(outputs: &Outputs) -> [u8; 13] {
    let mut out = [0; 13];
    out[0..2].copy_from_slice(&outputs.controlword.0.to_le_bytes());
    out[2..6].copy_from_slice(&outputs.position.to_le_bytes());
    out[6..10].copy_from_slice(&outputs.velocity.to_le_bytes());
    out[10..12].copy_from_slice(&outputs.torque.to_le_bytes());
    out[12] = outputs.mode.0 as u8;
    out
}

fn hand_unpack(frame: &[u8; 13]) -> Sample {
    // Bytes 10 and 11 are the current, which the client does not look at.
    let long = |at: usize| i32::from_le_bytes([frame[at], frame[at + 1], frame[at + 2], frame[at + 3]]);
    Sample {
        mode: Some(Mode(frame[12] as i8)),
        position: Some(long(2)),
        velocity: Some(long(6)),
        ..Sample::new(Statusword(u16::from_le_bytes([frame[0], frame[1]])))
    }
}

/// Seconds that a second of a virtual axis takes: cyclic synchronous position at 1 kHz, process data in both directions in
/// every cycle. `None` where the drive does not come into operation.
pub fn axis_second() -> Option<f64> {
    let mut memory = vec![0; cells(&MODEL)];
    let mut drive = VirtualDrive::new(&MODEL, &mut memory, Config::default()).ok()?;
    drive.advance(Duration::from_millis(200));
    [EsmState::SafeOp, EsmState::Op].into_iter().try_for_each(|state| drive.request(state)).ok()?;
    let mut outputs = Outputs { mode: Mode::CYCLIC_POSITION, ..Outputs::default() };
    for word in [0x06, 0x06, 0x07, 0x07, 0x0F, 0x0F] {
        outputs.controlword.0 = word;
        exchange(&mut drive, &outputs);
    }
    let mut position = 0;
    let seconds = fastest(|| {
        each(MILLISECONDS / 1_000, || {
            for n in 0..MILLISECONDS {
                // There and back: the axis has hard stops.
                position += if n % 2_000 < 1_000 { 3 } else { -3 };
                outputs.position = position;
                exchange(&mut drive, &outputs);
            }
        })
    });
    (drive.statusword().0 & 0x6F == 0x27).then_some(seconds)
}

fn exchange(drive: &mut VirtualDrive<'_, '_>, outputs: &Outputs) {
    let mut answer = [0; 32];
    drive.receive(&hand_pack(outputs));
    drive.step();
    black_box(drive.send(&mut answer));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two that do not do the same are not compared, and a drive at rest is not measured.
    #[test]
    fn both_give_the_same_bytes_and_the_drive_operates() {
        let image = Image::of(&MODEL, 0x1600, 0x1A00).expect("the layouts as the drive ships");
        let outputs = Outputs { position: -5, velocity: 7, torque: -9, mode: Mode(8), ..Outputs::default() };
        let mut frame = [0; 13];
        image.pack(&outputs, &mut frame);
        assert_eq!(frame, hand_pack(&outputs));
        let sample = image.unpack(&frame).expect("a frame").sample();
        assert_eq!(sample, Some(hand_unpack(&frame)));
        assert!(axis_second().is_some());
    }
}
