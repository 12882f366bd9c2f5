//! The walls between modules: who may name whom. The pipeline runs one way, and a backend sees only the model.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "a test reads the sources")]

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, TokenStream, TokenTree};

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
    ("schema", &["raw", "merge", "resolve", "check", "backend", "facts", "sink", "load", "build"]),
    ("audit", &["raw", "merge", "resolve", "check", "backend", "emit", "sink", "load", "build"]),
    (
        "live",
        &["raw", "rows", "merge", "resolve", "check", "backend", "emit", "facts", "sink", "load", "build"],
    ),
    ("configuration", &["merge", "resolve", "check", "backend", "facts", "dcf", "sink", "load", "build"]),
    ("dcf", &["raw", "rows", "merge", "resolve", "check", "facts", "sink", "load", "build"]),
    ("diff", &["raw", "rows", "merge", "resolve", "check", "facts", "sink", "load", "build"]),
    ("todo", &["raw", "rows", "merge", "resolve", "check", "backend", "emit", "sink", "load", "build"]),
    ("coverage", &["raw", "merge", "resolve", "check", "backend", "emit", "sink", "load", "build"]),
    (
        "load",
        &["raw", "rows", "merge", "resolve", "model", "check", "backend", "emit", "facts", "sink", "build"],
    ),
    (
        "sink",
        &[
            "diag", "source", "raw", "rows", "merge", "resolve", "model", "check", "backend", "facts",
            "load", "build",
        ],
    ),
    ("convert", &["rows", "merge", "resolve", "model", "check", "backend", "facts", "sink", "load", "build"]),
    ("build", &["raw", "rows", "merge", "resolve", "check", "emit", "facts", "load"]),
    ("name", EVERYTHING),
    ("limits", EVERYTHING),
];

/// What words and numbers stand on: nothing.
const EVERYTHING: &[&str] = &[
    "source",
    "diag",
    "raw",
    "rows",
    "merge",
    "resolve",
    "model",
    "check",
    "backend",
    "emit",
    "facts",
    "schema",
    "audit",
    "coverage",
    "configuration",
    "dcf",
    "diff",
    "todo",
    "load",
    "sink",
    "build",
];

/// A crate and the only files that may name it.
const KNOWERS: &[(&str, &[&str])] = &[
    ("annotate_snippets", &["diag/render.rs"]),
    ("use ::toml", &["raw/toml.rs"]),
    ("toml_parser", &["raw/toml.rs"]),
    ("quick_xml", &["raw/xml", "backend/esi/xml.rs"]),
    ("bumpalo", &["live"]),
    ("minijinja", &["backend/template.rs"]),
];

/// The only files that may touch the file system or the environment.
const TOUCHING: &[&str] = &["load.rs", "sink.rs", "sink/", "build.rs", "build/"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// Every source file: its path below `src` with `/`, and its text.
fn sources() -> Vec<(String, String)> {
    let (mut folders, mut files) = (vec![root()], Vec::new());
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("a folder").map(|e| e.expect("an entry").path()) {
            if entry.is_dir() {
                folders.push(entry);
            } else if entry.extension().is_some_and(|e| e == "rs") {
                let path =
                    entry.strip_prefix(root()).expect("below src").to_string_lossy().replace('\\', "/");
                files.push((path, std::fs::read_to_string(&entry).expect("a text")));
            }
        }
    }
    assert!(files.len() > 30, "the walk found too little: {}", files.len());
    files
}

/// A text without comments and tests.
fn code(text: &str) -> String {
    let code = text.split("#[cfg(test)]").next().unwrap_or(text);
    code.lines().filter(|l| !l.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
}

fn belongs(path: &str, module: &str) -> bool {
    path == format!("{module}.rs") || path.starts_with(&format!("{module}/"))
}

/// The modules of the crate's root that the code of a file names: after `crate::`, or after as many `super::` as lead to
/// the root, in paths and in trees of `use`. Whatever stays below one of them names that one.
fn names(path: &str, text: &str) -> BTreeSet<String> {
    let file = path.trim_end_matches(".rs");
    let module: Vec<&str> = file.split('/').filter(|part| !["mod", "lib"].contains(part)).collect();
    let mut found = BTreeSet::new();
    scan(text.parse().unwrap_or_else(|e| panic!("{path}: {e}")), &module, &mut found);
    found
}

fn scan(code: TokenStream, module: &[&str], found: &mut BTreeSet<String>) {
    let tokens: Vec<TokenTree> = code.into_iter().collect();
    let mut test = false;
    for (at, token) in tokens.iter().enumerate() {
        match token {
            // A test may name what it wants: it ends with the braces of its module.
            TokenTree::Group(group) if group.to_string().replace(' ', "") == "[cfg(test)]" => test = true,
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace && test => test = false,
            TokenTree::Group(group) => scan(group.stream(), module, found),
            TokenTree::Ident(word) if *word == "crate" || *word == "super" => {
                tree(&tokens[at..], module, found);
            }
            _ => {}
        }
    }
}

/// Follows a path, or each path of a tree, from `module`.
fn tree(tokens: &[TokenTree], module: &[&str], found: &mut BTreeSet<String>) {
    match tokens {
        [TokenTree::Group(group), ..] => {
            let inner: Vec<TokenTree> = group.stream().into_iter().collect();
            let comma = |token: &TokenTree| matches!(token, TokenTree::Punct(sign) if sign.as_char() == ',');
            inner.split(comma).for_each(|path| tree(path, module, found));
        }
        // Two colons are two tokens.
        [TokenTree::Ident(word), rest @ ..] => match word.to_string().as_str() {
            "crate" => tree(rest.get(2..).unwrap_or_default(), &[], found),
            "super" => {
                tree(rest.get(2..).unwrap_or_default(), module.split_last().map_or(&[], |m| m.1), found);
            }
            "self" => tree(rest.get(2..).unwrap_or_default(), module, found),
            word => drop(found.insert((*module.first().unwrap_or(&word)).to_owned())),
        },
        _ => {}
    }
}

#[test]
fn stages_run_one_way() {
    for (path, text) in sources() {
        let named = names(&path, &text);
        let of_users = ["configuration", "dcf", "schema"].iter().any(|module| belongs(&path, module));
        assert!(
            of_users || path == "lib.rs" || !named.contains("configuration"),
            "{path} names `configuration`"
        );
        for (stage, walls) in WALLS.iter().filter(|(stage, _)| belongs(&path, stage)) {
            for wall in *walls {
                assert!(!named.contains(*wall), "{path} ({stage}) names `{wall}`");
            }
        }
    }
}

/// A module that no wall speaks of could name anything.
#[test]
fn every_module_has_its_walls() {
    for (path, _) in sources() {
        assert!(path == "lib.rs" || WALLS.iter().any(|(stage, _)| belongs(&path, stage)), "{path}");
    }
}

#[test]
fn foreign_crates_stay_in_their_module() {
    for (path, text) in sources() {
        let code = code(&text);
        for (krate, knowers) in KNOWERS {
            let may = knowers.iter().any(|k| path.starts_with(k));
            assert!(may || !code.contains(krate), "{path} names {krate}");
        }
    }
}

#[test]
fn only_load_sink_and_build_touch_the_file_system() {
    for (path, text) in sources() {
        let code = code(&text);
        let may = TOUCHING.iter().any(|t| path.starts_with(t));
        for word in ["std::fs", "std::env", "std::time", "std::process", "println!", "eprintln!"] {
            assert!(may || !code.contains(word), "{path} uses {word}");
        }
    }
}

#[test]
fn the_walls_would_be_seen() {
    let named = |path: &str, code: &str| names(path, code).into_iter().collect::<Vec<_>>().join(" ");
    assert_eq!(named("diag/mod.rs", "use crate::rows::Rows; use crate::rowsy;"), "rows rowsy");
    assert_eq!(named("diag/mod.rs", "use crate::{check::{a, b}, rows, self};"), "check rows");
    assert_eq!(
        named("diag/json.rs", "use super::super::{load, sink as s}; use super::Code;"),
        "diag load sink"
    );
    assert_eq!(
        named("source.rs", "fn f() -> super::load::Loaded { crate::check::run(&[crate::emit::X]) }"),
        "check emit load"
    );
    assert_eq!(
        named("emit/mod.rs", "#[cfg(test)]\nmod tests { use crate::check; } use crate::limits;"),
        "limits"
    );
    assert_eq!(named("a/b/mod.rs", "pub(super) fn f() {} use super::super::merge; use super::c;"), "a merge");
    assert!(
        belongs("diag/mod.rs", "diag") && belongs("source.rs", "source") && !belongs("diagram.rs", "diag")
    );
    assert_eq!(code("a\n// crate::rows::X\nb"), "a\nb");
}
