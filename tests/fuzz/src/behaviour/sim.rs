//! The virtual drive with a master, supplies and loads that do as they like.

use std::time::Duration;

use drivewright_runtime::cia402::{State, Statusword};
use drivewright_runtime::model::EsmState;
use drivewright_runtime::sim::{Config, VirtualDrive, cells};
use savch_sdv3_e::MODEL;

use super::bytes::Bytes;
use crate::targets::Reached;

/// The most actions of an input: each is few cycles.
const ACTIONS: usize = 60;
/// Bytes of the process data that the drive receives as it ships.
const RECEIVED: usize = 13;

/// The seventeen transitions as pairs of states: number of the state before, and of those after it.
const NEXT: [&[usize]; 8] = [&[1], &[2], &[1, 3], &[1, 2, 4], &[1, 2, 3, 5], &[1, 4], &[7], &[1]];

/// One input.
pub(super) fn step(input: &[u8]) -> Reached {
    let (mut bytes, mut reached) = (Bytes(input), Reached::default());
    let mut memory = vec![0; cells(&MODEL)];
    let Ok(mut drive) = VirtualDrive::new(&MODEL, &mut memory, config(&mut bytes)) else { panic!("memory") };
    if !bytes.once_in(8) {
        let _ = start(&mut drive);
    }
    for _ in 0..ACTIONS {
        if bytes.is_empty() {
            break;
        }
        act(&mut drive, &mut bytes, &mut reached);
        for _ in 0..bytes.byte() % 3 {
            let before = drive.state();
            drive.step();
            judge(&drive, before);
        }
        reached.sound |= drive.state() == State::OperationEnabled;
    }
    values(&mut drive, &mut bytes);
    reached
}

fn config(bytes: &mut Bytes<'_>) -> Config {
    let mut config = Config::default();
    config.cycle = Duration::from_micros(bytes.pick(&[62, 125, 1_000, 1_000, 1_000, 10_000, 1_000_000]));
    config.start_up = Duration::ZERO;
    config.counts_per_revolution = bytes.pick(&[131_072, 131_072, 10_000, 1, u32::MAX]);
    config.target_jump = bytes.pick(&[4, 0, 255]);
    let options = [
        &mut config.quick_stop_option,
        &mut config.shutdown_option,
        &mut config.disable_option,
        &mut config.halt_option,
        &mut config.fault_option,
    ];
    options.into_iter().for_each(|option| *option = bytes.pick(&[0, 1, 2, 3, 4, 5, 6, 7, 8, -1, i16::MIN]));
    config
}

fn start(drive: &mut VirtualDrive<'_, '_>) -> Option<()> {
    drive.step();
    [EsmState::PreOp, EsmState::SafeOp, EsmState::Op]
        .into_iter()
        .try_for_each(|state| drive.request(state).ok())
}

fn act(drive: &mut VirtualDrive<'static, '_>, bytes: &mut Bytes<'_>, reached: &mut Reached) {
    let on = bytes.byte() % 2 == 0;
    match bytes.byte() % 24 {
        0..=5 => {
            let object = bytes.pick(MODEL.objects());
            let length = if bytes.once_in(8) {
                usize::from(bytes.byte() % 9)
            } else {
                object.data_type().bytes().min(8)
            };
            let data = bytes.number().to_le_bytes();
            let written = drive.download(object.address(), &data[..length]);
            reached.codes.push(if written.is_ok() { "written" } else { "refused" });
        }
        6..=14 => {
            let _ = drive.receive(&frame(drive, bytes));
            drive.step();
        }
        15 => drop(drive.request(bytes.pick(&[
            EsmState::Init,
            EsmState::PreOp,
            EsmState::SafeOp,
            EsmState::Op,
        ]))),
        16 => {
            let alarm = bytes.pick(MODEL.alarms());
            let _ = if on {
                drive.raise(alarm.display(), alarm.number())
            } else {
                drive.raise_for_good(alarm.display(), alarm.number())
            };
            let _ = drive.emergency();
        }
        17 => {
            let alarm = bytes.pick(MODEL.alarms());
            let _ = drive.end_cause(alarm.display(), alarm.number());
        }
        18 => match bytes.byte() % 16 {
            0 => drive.set_mains(on),
            1 => drive.allow_torque(on),
            2 => drive.set_supply(on),
            3 => drive.operate_locally(on),
            4 => drive.power_cycle(),
            // What was off comes back.
            _ => {
                drive.set_supply(true);
                drive.set_mains(true);
                drive.allow_torque(true);
                drive.operate_locally(false);
            }
        },
        19 => _ = start(drive),
        22 => drive.axis_mut().set_load(bytes.signed32()),
        _ => drive.set_probe(usize::from(bytes.byte()), on),
    }
}

/// A controlword that mostly leads on, targets, a mode.
fn frame(drive: &VirtualDrive<'_, '_>, bytes: &mut Bytes<'_>) -> [u8; RECEIVED] {
    let word = match (bytes.byte() % 8, drive.state()) {
        (0, _) => bytes.word(),
        (1, _) => bytes.pick(&[0x06, 0x07, 0x80, 0x00, 0x02, 0x10F]),
        (_, State::SwitchOnDisabled) => 0x06,
        (_, State::ReadyToSwitchOn) => 0x07,
        (_, State::Fault) => bytes.pick(&[0x00, 0x80]),
        (_, State::QuickStopActive) => bytes.pick(&[0x00, 0x0F]),
        _ => bytes.pick(&[0x0F, 0x0F, 0x0F, 0x1F, 0x3F, 0x5F]),
    };
    let mut data = [0; RECEIVED];
    data[..2].copy_from_slice(&word.to_le_bytes());
    data[2..6].copy_from_slice(&bytes.signed32().to_le_bytes());
    data[6..10].copy_from_slice(&bytes.signed32().to_le_bytes());
    data[10..12].copy_from_slice(&bytes.word().to_le_bytes());
    data[12] = bytes.pick(&[1, 3, 4, 6, 8, 9, 10, 0, 200]);
    data
}

/// One cycle leads from a state to a state that a transition leads to, and the statusword shows it.
fn judge(drive: &VirtualDrive<'_, '_>, before: State) {
    let (from, to) = (place(before), place(drive.state()));
    let fault = to == 6 && from < 6;
    assert!(from == to || fault || to == 0 || NEXT[from].contains(&to), "from {before} to {}", drive.state());
    let shown = Statusword(drive.statusword().0).state();
    assert!(
        shown == Some(drive.state()) || drive.statusword().0 == 0,
        "{} is shown as {shown:?}",
        drive.state()
    );
}

fn place(state: State) -> usize {
    State::ALL.iter().position(|s| *s == state).unwrap_or(0)
}

/// Whatever happened, each value is one of its type.
fn values(drive: &mut VirtualDrive<'_, '_>, bytes: &mut Bytes<'_>) {
    let start = bytes.below(MODEL.objects().len());
    for object in MODEL.objects().iter().cycle().skip(start).take(40) {
        let mut data = [0; 64];
        let Ok(length) = drive.upload(object.address(), &mut data) else { continue };
        let data_type = object.data_type();
        if data_type.is_integer() {
            let read = data_type.decode_int(&data[..length]);
            assert!(read.is_ok(), "{} is {read:?}", object.address());
            let used = drive.value(object.address()).map_or(0, i128::from);
            let (min, max) = data_type.range().unwrap_or_default();
            assert!((min..=max).contains(&used), "{} is {used}", object.address());
        }
    }
}
