//! The walls between modules: who may name whom. The pipeline runs one way, and a backend sees only the model.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "a test reads the sources")]

use std::path::{Path, PathBuf};

/// Each stage with the modules that it must not name. A stage never names a later one, and nothing after resolving
/// names what comes before it.
const WALLS: &[(&str, &[&str])] = &[
    ("source", &["raw", "rows", "merge", "resolve", "model", "check", "backend", "sink", "load"]),
    ("diag", &["raw", "rows", "merge", "resolve", "model", "check", "backend", "sink", "load"]),
    ("raw", &["rows", "merge", "resolve", "model", "check", "backend", "sink", "load"]),
    ("rows", &["merge", "resolve", "check", "backend", "sink", "load"]),
    ("merge", &["resolve", "check", "backend", "sink", "load"]),
    ("resolve", &["check", "backend", "sink", "load"]),
    ("model", &["raw", "rows", "merge", "resolve", "check", "backend", "sink", "load"]),
    ("check", &["raw", "merge", "resolve", "backend", "sink", "load"]),
    ("emit", &["raw", "rows", "merge", "resolve", "model", "check", "backend", "sink", "load"]),
    ("backend", &["raw", "rows", "merge", "resolve", "check", "sink", "load"]),
    ("facts", &["raw", "rows", "merge", "resolve", "check", "backend", "sink", "load"]),
];

/// A crate and the only files that may name it.
const KNOWERS: &[(&str, &[&str])] = &[
    ("annotate_snippets", &["diag/render.rs"]),
    ("use ::toml", &["raw/toml.rs"]),
    ("minijinja", &["backend/rust"]),
];

/// The only files that may touch the file system or the environment.
const TOUCHING: &[&str] = &["load.rs", "sink.rs", "sink/", "build.rs", "build/"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// Every source file: its path below `src` with `/`, and its code without comments and tests.
fn sources() -> Vec<(String, String)> {
    let (mut folders, mut files) = (vec![root()], Vec::new());
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("a folder").map(|e| e.expect("an entry").path()) {
            if entry.is_dir() {
                folders.push(entry);
            } else if entry.extension().is_some_and(|e| e == "rs") {
                let path =
                    entry.strip_prefix(root()).expect("below src").to_string_lossy().replace('\\', "/");
                files.push((path, code(&std::fs::read_to_string(&entry).expect("a text"))));
            }
        }
    }
    assert!(files.len() > 30, "the walk found too little: {}", files.len());
    files
}

fn code(text: &str) -> String {
    let code = text.split("#[cfg(test)]").next().unwrap_or(text);
    code.lines().filter(|l| !l.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
}

fn belongs(path: &str, module: &str) -> bool {
    path == format!("{module}.rs") || path.starts_with(&format!("{module}/"))
}

fn names(code: &str, module: &str) -> bool {
    code.contains(&format!("crate::{module}::")) || code.contains(&format!("crate::{module};"))
}

#[test]
fn stages_run_one_way() {
    for (path, code) in sources() {
        for (stage, walls) in WALLS.iter().filter(|(stage, _)| belongs(&path, stage)) {
            for wall in *walls {
                assert!(!names(&code, wall), "{path} ({stage}) names `{wall}`");
            }
        }
    }
}

#[test]
fn foreign_crates_stay_in_their_module() {
    for (path, code) in sources() {
        for (krate, knowers) in KNOWERS {
            let may = knowers.iter().any(|k| path.starts_with(k));
            assert!(may || !code.contains(krate), "{path} names {krate}");
        }
    }
}

#[test]
fn only_load_sink_and_build_touch_the_file_system() {
    for (path, code) in sources() {
        let may = TOUCHING.iter().any(|t| path.starts_with(t));
        for word in ["std::fs", "std::env", "std::time", "std::process", "println!", "eprintln!"] {
            assert!(may || !code.contains(word), "{path} uses {word}");
        }
    }
}

#[test]
fn the_walls_would_be_seen() {
    assert!(names("use crate::rows::Rows;", "rows") && !names("use crate::rowsy::X;", "rows"));
    assert!(
        belongs("diag/mod.rs", "diag") && belongs("source.rs", "source") && !belongs("diagram.rs", "diag")
    );
    assert_eq!(code("a\n// crate::rows::X\nb"), "a\nb");
}
