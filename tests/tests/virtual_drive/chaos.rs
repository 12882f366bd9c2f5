//! A master without sense: whatever it sends, the drive shows one of the eight states and makes no transition but the
//! seventeen. Overflows count as failures here: tests are built with their checks.

use std::collections::BTreeSet;
use std::path::Path;
use std::time::Duration;

use drivewright_codegen::{compile_folder, live};
use drivewright_runtime::Address;
use drivewright_runtime::cia402::{State, Statusword};
use drivewright_runtime::model::EsmState;
use drivewright_runtime::sim::Config;
use drivewright_runtime::sim::plant::PlantConfig;
use savch_sdv3_e::MODEL;

use crate::Rig;

/// The same numbers in every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 ^ self.0 >> 29
    }

    fn below(&mut self, end: u64) -> u64 {
        self.next() % end
    }

    /// A number near an edge of its type as often as any other.
    fn value(&mut self) -> i64 {
        let edges = [0, 1, -1, i64::from(i32::MAX), i64::from(i32::MIN), i64::from(u32::MAX), 0x7FFF, 6, 15];
        let any = i64::from_le_bytes(self.next().to_le_bytes());
        match self.below(3) {
            0 => any,
            1 => any >> 40,
            _ => edges[usize::try_from(self.below(9)).unwrap()],
        }
    }
}

/// A controlword: mostly one that leads on, sometimes any.
fn word(state: State, numbers: &mut Numbers) -> u16 {
    let on = match state {
        State::SwitchOnDisabled => 0x06,
        State::ReadyToSwitchOn => 0x07,
        State::Fault => [0x80, 0x00][usize::try_from(numbers.below(2)).unwrap()],
        _ => [0x0F, 0x0F, 0x1F, 0x1F, 0x3F, 0x5F, 0x0F, 0x02][usize::try_from(numbers.below(8)).unwrap()],
    };
    let any = [0x06, 0x07, 0x0F, 0x00, 0x02, 0x10F, 0x80, 0xFFFF];
    if numbers.below(12) == 0 { any[usize::try_from(numbers.below(8)).unwrap()] } else { on }
}

/// One thing that a master, a supply or a load may do.
fn act(rig: &mut Rig, numbers: &mut Numbers, config: Config) {
    let drive = &mut rig.drive;
    match numbers.below(24) {
        0..=6 => {
            let at = usize::try_from(numbers.below(MODEL.objects().len() as u64)).unwrap();
            let object = &MODEL.objects()[at];
            let length = if numbers.below(9) == 0 { 3 } else { object.data_type().bytes().min(8) };
            let _ = drive.download(object.address(), &numbers.value().to_le_bytes()[..length]);
        }
        7..=11 => {
            let mut data = [0; 13];
            let word = word(drive.state(), numbers);
            data[..2].copy_from_slice(&word.to_le_bytes());
            data[2..10].copy_from_slice(&numbers.value().to_le_bytes());
            let modes = [1, 3, 4, 6, 8, 9, 10, 200];
            data[12] = modes[usize::try_from(numbers.below(8)).unwrap()];
            if !drive.receive(&data) {
                let _ = drive.download(Address::new(0x6040, 0), &data[..2]);
            }
        }
        12 => {
            let _ = drive.upload(Address::new(0x6041, 0), &mut [0; 2]);
        }
        13 if numbers.below(10) == 0 => {
            let states = [EsmState::Init, EsmState::PreOp, EsmState::SafeOp, EsmState::Op];
            let _ = drive.request(states[usize::try_from(numbers.below(4)).unwrap()]);
        }
        14 => drive.set_mains(numbers.below(40) != 0),
        15 => drive.allow_torque(numbers.below(40) != 0),
        16 if numbers.below(20) == 0 => drive.power_cycle(),
        17 => drive.axis_mut().set_load(i32::try_from(numbers.value() % 1_000).unwrap()),
        18 => drive.set_probe(usize::try_from(numbers.below(3)).unwrap(), numbers.below(2) == 0),
        19 if numbers.below(20) == 0 => {
            let at = usize::try_from(numbers.below(37)).unwrap();
            let _ = drive.raise(MODEL.alarms()[at].display(), MODEL.alarms()[at].number());
        }
        _ => {
            let before = drive.state();
            drive.advance(config.cycle);
            check(before, rig);
        }
    }
}

fn check(before: State, rig: &Rig) {
    let after = rig.drive.state();
    match rig.drive.transition() {
        Some(transition) => assert_eq!(transition.to(), after),
        None => assert_eq!(before, after),
    }
    assert_eq!(rig.drive.statusword().state(), Some(after), "{}", rig.drive.statusword());
}

#[test]
fn nothing_that_is_sent_breaks_the_drive() {
    for seed in 0..8 {
        let mut config = Config::default();
        config.cycle =
            [Duration::from_nanos(62_500), Duration::from_millis(1), Duration::from_millis(4)][seed % 3];
        let mut rig = Rig::with(config, PlantConfig::default());
        let mut numbers = Numbers(seed as u64);
        for _ in 0..20_000 {
            act(&mut rig, &mut numbers, config);
        }
    }
}

/// What a master without sense sees of a drive.
fn trace(mut rig: Rig) -> Vec<(Statusword, i64)> {
    let mut numbers = Numbers(5);
    let mut seen = Vec::new();
    for _ in 0..10_000 {
        act(&mut rig, &mut numbers, Config::default());
        seen.push((rig.drive.statusword(), rig.drive.axis().position()));
    }
    seen
}

#[test]
fn the_same_master_sees_the_same_drive() {
    let seen = trace(Rig::new());
    assert_eq!(trace(Rig::new()), seen);
    let moved = seen.iter().any(|(_, position)| *position != 0);
    let states: BTreeSet<_> = seen.iter().filter_map(|(word, _)| word.state()).collect();
    assert!(moved && states.len() == 8, "it does something: {states:?}");
}

#[test]
fn a_folder_that_is_loaded_at_run_time_gives_the_same_drive() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../profiles/savch/sdv3-e");
    let profile = Box::leak(Box::new(compile_folder(&folder).0.sound().cloned().unwrap()));
    let loaded = live::tables(profile, Box::leak(Box::default())).model();
    let rig = Rig::of(loaded, Config::default(), PlantConfig::default());
    assert_eq!(trace(rig), trace(Rig::new()));
}
