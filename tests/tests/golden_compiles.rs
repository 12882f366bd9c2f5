//! The Rust that golden cases give compiles without a warning, all of it as modules of one crate, its own tests pass, and
//! its documentation is text: no link, no code, nothing that `cargo test` would run.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "a test builds a crate")]

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use drivewright_codegen::backend::rust::Rust;
use drivewright_codegen::{emit, live};
use drivewright_tests::cases::{Case, golden_cases};

/// A crate with a module for each of `cases`; `change` edits what is written into each file.
fn krate(name: &str, cases: &[Case], change: impl Fn(&str) -> String) -> PathBuf {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(root.join("src"));
    let runtime = Path::new(env!("CARGO_MANIFEST_DIR")).join("../runtime");
    let manifest = format!(
        "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2021\"\n\n[workspace]\n\n[features]\nsim = []\n\n\
         [dependencies]\n\
         drivewright-runtime = {{ path = {:?} }}\n",
        runtime.display().to_string()
    );
    let mut lib =
        "//! Golden cases.\n#![no_std]\n#![forbid(unsafe_code)]\n#![deny(warnings, missing_docs)]\n"
            .to_owned();
    for case in cases {
        let module = format!("case_{}", case.name.replace('-', "_"));
        let _ = writeln!(lib, "/// A case.\npub mod {module};");
        let folder = root.join("src").join(module);
        self::module(case, &folder, &change);
        fs::write(folder.join("live.txt"), loaded(case)).expect("a text");
    }
    lib.push_str(&homing_programs(cases));
    lib.push_str(&models(cases));
    fs::write(root.join("Cargo.toml"), manifest).expect("a manifest");
    fs::write(root.join("src/lib.rs"), lib).expect("a root");
    root
}

/// A test of the crate: homing programs show as the profile has them.
fn homing_programs(cases: &[Case]) -> String {
    let mut out = String::from(
        "#[cfg(test)]\nmod homing {\n    extern crate std;\n    use std::string::ToString;\n    #[test]\n    fn programs() {\n",
    );
    for case in cases {
        let model = format!("super::case_{}::MODEL", case.name.replace('-', "_"));
        for (n, method) in case.model().homing.iter().enumerate() {
            let row = format!("{model}.homing_methods()[{n}]");
            let _ = writeln!(out, "assert_eq!({row}.number(), {});", method.number);
            let _ = writeln!(out, "assert_eq!({row}.status().word(), {:?});", method.status.value.word());
            let _ = writeln!(out, "assert_eq!({row}.cases().len(), {});", method.cases.len());
            for (c, case) in method.cases.iter().enumerate() {
                let (when, moves) = (case.when.value.to_string(), case.moves.value.to_string());
                let abort = case.abort.as_ref().map(|a| a.value.to_string());
                let _ = writeln!(out, "let case = {row}.cases()[{c}];");
                let _ = writeln!(out, "assert_eq!(case.when().to_string(), {when:?});");
                let _ = writeln!(out, "assert_eq!(case.moves().to_string(), {moves:?});");
                let _ = writeln!(out, "let abort = case.abort().map(|a| a.to_string());");
                let _ = writeln!(
                    out,
                    "assert_eq!(abort.as_deref().unwrap_or(\"\"), {:?});",
                    abort.unwrap_or_default()
                );
            }
        }
    }
    out + "    }\n}\n"
}

/// The tables of a case and its alarm texts as they are when the profile is loaded at run time.
fn loaded(case: &Case) -> String {
    let (profile, arena) = (case.model(), live::Arena::default());
    let live = live::tables(&profile, &arena);
    format!("{:?} {:?}", live.model(), live.alarm_texts())
}

/// A test of the crate: its tables are those that the profile gives at run time.
fn models(cases: &[Case]) -> String {
    let mut out = String::from(
        "#[cfg(test)]\nmod live {\n    extern crate std;\n    use std::format;\n    #[test]\n    fn tables() {\n",
    );
    for case in cases {
        let module = format!("case_{}", case.name.replace('-', "_"));
        let _ = writeln!(
            out,
            "        let made = format!(\"{{:?}} {{:?}}\", super::{module}::MODEL, super::{module}::alarms::ALARM_TEXTS);\n        \
             assert_eq!(made, include_str!(\"{module}/live.txt\"), {:?});",
            case.name
        );
    }
    out + "    }\n}\n"
}

/// Writes the modules of a case. Its `lib.rs` becomes `mod.rs`, without what only the root of a crate can say.
fn module(case: &Case, folder: &Path, change: impl Fn(&str) -> String) {
    fs::create_dir_all(folder).expect("a folder");
    let (files, _) = emit(&case.model(), &[&Rust]);
    let sources = files.iter().filter_map(|(path, bytes)| Some((path.as_str().strip_prefix("src/")?, bytes)));
    for (path, bytes) in sources {
        let text = std::str::from_utf8(bytes).expect("UTF-8");
        let (path, text) = match path {
            "lib.rs" => {
                ("mod.rs", text.lines().filter(|l| !l.starts_with("#![")).collect::<Vec<_>>().join("\n"))
            }
            other => (other, change(text)),
        };
        fs::write(folder.join(path), text).expect("a module");
    }
}

/// Runs `cargo` in the folder of a crate.
fn cargo(root: &Path, arguments: &[&str]) -> Output {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(arguments).args(["--quiet", "--offline", "--target-dir"]).arg(root.join("target"));
    // Flags of the surrounding build would build everything anew.
    command.current_dir(root).env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    command.env("RUSTDOCFLAGS", "-D warnings");
    command.output().expect("cargo starts")
}

/// Builds the crate and runs the tests that generated code carries.
fn check(root: &Path) -> Output {
    cargo(root, &["test", "--lib"])
}

/// What the examples in the documentation do: how many there are, and whether they hold.
fn examples(root: &Path) -> (String, bool) {
    let output = cargo(root, &["test", "--doc"]);
    (String::from_utf8_lossy(&output.stdout).into_owned(), output.status.success())
}

/// The cases named `name`.
fn only(name: &str) -> Vec<Case> {
    golden_cases().into_iter().filter(|c| c.name == name).collect()
}

#[test]
fn golden_rust_compiles_without_warnings() {
    let root = krate("golden-rust", &golden_cases(), str::to_owned);
    let output = check(&root);
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{said}{}", String::from_utf8_lossy(&output.stderr));
    assert!(said.contains(&format!("{} passed", golden_cases().len() + 2)), "{said}");
    // A test of each virtual drive comes to that.
    let output = cargo(&root, &["test", "--lib", "--features", "sim"]);
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{said}{}", String::from_utf8_lossy(&output.stderr));
    assert!(said.contains(&format!("{} passed", golden_cases().len() * 2 + 2)), "{said}");
    let (said, passed) = examples(&root);
    assert!(passed && said.contains("running 0 tests"), "{said}");
    let documented = cargo(&root, &["doc", "--no-deps", "--features", "sim"]);
    assert!(documented.status.success(), "{}", String::from_utf8_lossy(&documented.stderr));
}

#[test]
fn a_warning_would_be_seen() {
    let unused = |text: &str| text.replacen("pub const SOMETHING", "const SOMETHING", 1);
    let output = check(&krate("golden-rust-control", &only("silence"), unused));
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success() && said.contains("is never used"), "{said}");
}

#[test]
fn a_table_unlike_that_of_its_profile_would_be_seen() {
    let other =
        |text: &str| text.replacen("\"Switch on disabled\", 0x004F", "\"Switch on disabled\", 0x006F", 1);
    let cases = [only("states-commands"), only("homing-basic")].concat();
    let output = check(&krate("golden-rust-other", &cases, other));
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(!output.status.success(), "{said}{}", String::from_utf8_lossy(&output.stderr));
    assert!(said.contains("live::tables") && said.contains("3 passed; 1 failed"), "{said}");
}

#[test]
fn text_that_runs_or_links_would_be_seen() {
    let runs = |text: &str| text.replacen("/// panic!", "///     panic!", 1);
    let (said, passed) = examples(&krate("golden-rust-runs", &only("doc-comments"), runs));
    assert!(!passed && said.contains("running 1 test"), "{said}");
    let links = |text: &str| text.replacen("https\\://", "https://", 1);
    let output = cargo(&krate("golden-rust-links", &only("doc-comments"), links), &["doc", "--no-deps"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success() && said.contains("bare_urls"), "{said}");
}
