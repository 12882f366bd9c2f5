//! Homing programs of profiles as constants of the runtime.

use drivewright_codegen::model::Model;
use drivewright_codegen::source::Source;
use drivewright_codegen::{compile, compile_folder, live};
use drivewright_runtime::homing::HomingDesc;
use drivewright_tests::cases::golden_cases;
use drivewright_tests::drives;

/// A drive and its methods.
type Drive = (String, Vec<HomingDesc<'static>>);

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
pub(crate) fn standard() -> Vec<HomingDesc<'static>> {
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
fn methods(model: &Model) -> Vec<HomingDesc<'static>> {
    let (model, arena) = (Box::leak(Box::new(model.clone())), Box::leak(Box::default()));
    live::tables(model, arena).model().homing_methods().to_vec()
}
