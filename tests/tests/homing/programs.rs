//! Homing programs of profiles as constants of the runtime.

use drivewright_codegen::model::{
    Event, HomingMethod, HomingStatus, Level, Model, Pace, Side, Signal, Step, When,
};
use drivewright_codegen::source::Source;
use drivewright_codegen::{compile, compile_folder};
use drivewright_runtime::homing;
use drivewright_tests::cases::golden_cases;
use drivewright_tests::drives;

/// A drive and its methods.
type Drive = (String, Vec<homing::HomingDesc<'static>>);

/// The drives of the repository, and the golden cases that have homing.
pub(crate) fn drives() -> Vec<Drive> {
    let model = |folder: &std::path::Path| compile_folder(folder).0.model.expect("a model");
    let own = drives::all().into_iter().map(|folder| {
        let words: Vec<_> =
            folder.iter().rev().take(2).map(|word| word.to_string_lossy().into_owned()).collect();
        (format!("{}-{}", words[1], words[0]), methods(&model(&folder)))
    });
    let golden = golden_cases().into_iter().filter(|case| case.name.starts_with("homing"));
    own.chain(golden.map(|case| (case.name.clone(), methods(&case.model())))).collect()
}

/// CiA 402.
pub(crate) fn standard() -> Vec<homing::HomingDesc<'static>> {
    // A drive cites its manual in each row; a base does not.
    let rows = include_str!("../../../profiles/standard/cia402/homing.toml");
    let source = |path: &str, text: String| Source { path: path.into(), text };
    let compiled = compile(vec![
        source("drive.toml", include_str!("../../../codegen/tests/fixtures/drive.toml").into()),
        source("homing.toml", rows.replace(" },\n", ", src = \"1 L1\" },\n")),
    ]);
    methods(&compiled.model.expect("a model"))
}

/// They live as long as the test does.
fn methods(model: &Model) -> Vec<homing::HomingDesc<'static>> {
    model.homing.iter().map(method).collect()
}

fn method(method: &HomingMethod) -> homing::HomingDesc<'static> {
    let cases: Vec<_> = method
        .cases
        .iter()
        .map(|case| {
            let moves: Vec<_> = case.moves.value.0.iter().copied().map(step).collect();
            let mut own = homing::HomingCase::new(levels(&case.when.value), moves.leak());
            if let Some(abort) = &case.abort {
                own = own.with_abort(levels(&abort.value));
            }
            if let Some(mask) = &case.mask {
                own = own.with_mask(mask.value.iter().map(|s| signal(*s)).collect::<Vec<_>>().leak());
            }
            own
        })
        .collect();
    let own = homing::HomingDesc::new(method.number).with_cases(cases.leak());
    let own = own.with_status(match method.status.value {
        HomingStatus::Supported => homing::HomingStatus::Supported,
        HomingStatus::Reserved => homing::HomingStatus::Reserved,
        HomingStatus::NotAvailable => homing::HomingStatus::NotAvailable,
    });
    method.same.as_ref().map_or(own, |same| own.with_same(same.value))
}

fn levels(when: &When) -> &'static [homing::Level] {
    let level = |level: &Level| match level {
        Level::Switch(of, on) => homing::Level::Switch(signal(*of), *on),
        Level::Standstill => homing::Level::Standstill,
        Level::AtHome => homing::Level::AtHome,
    };
    when.0.iter().map(level).collect::<Vec<_>>().leak()
}

fn signal(signal: Signal) -> homing::Signal {
    match signal {
        Signal::NegativeLimit => homing::Signal::NegativeLimit,
        Signal::PositiveLimit => homing::Signal::PositiveLimit,
        Signal::Home => homing::Signal::Home,
    }
}

fn step(step: Step) -> homing::Step {
    match step {
        Step::Move { direction, pace, until } => Step::Move {
            direction: if direction == Side::Positive {
                homing::Side::Positive
            } else {
                homing::Side::Negative
            },
            pace: if pace == Pace::Fast { homing::Pace::Fast } else { homing::Pace::Slow },
            until: match until {
                Event::Switch(of, on) => homing::Event::Switch(signal(of), on),
                Event::Index => homing::Event::Index,
                Event::Torque(on) => homing::Event::Torque(on),
                Event::Stall => homing::Event::Stall,
            },
        },
        Step::Stop => Step::Stop,
        Step::Latch => Step::Latch,
        Step::Return => Step::Return,
        Step::Done => Step::Done,
        Step::NotStated => Step::NotStated,
    }
}
