//! Programs of the checkout that only some need, each in a workspace of its own: the bench and the fuzzer.

use std::ffi::OsString;
use std::path::Path;
use std::process::{Command, ExitStatus};

use crate::{End, Options};

/// Measures, and prints each figure beside its budget.
pub fn bench(root: &Path, options: &Options) -> End {
    end(program(root, "bench").arg("--").args(&options.rest).status())
}

/// `cargo xtask fuzz` and nothing else: the stable generator. With a target: libFuzzer on it, with its own options behind.
pub fn fuzz(root: &Path, options: &Options) -> End {
    match options.rest.split_first() {
        Some((name, rest)) if !name.to_string_lossy().starts_with('-') => libfuzzer(root, name, rest),
        _ => end(program(root, "fuzz").arg("--").args(&options.rest).status()),
    }
}

/// `cargo run` of the program in `tests/<name>`.
fn program(root: &Path, name: &str) -> Command {
    let mut cargo = Command::new("cargo");
    cargo.args(["run", "--release", "--locked", "--quiet", "--manifest-path"]);
    cargo.arg(root.join("tests").join(name).join("Cargo.toml"));
    cargo.arg("--target-dir").arg(root.join("target").join(name));
    cargo
}

/// What libFuzzer needs of a compiler, as `cargo fuzz` asks for it; all of it is stable. The address sanitizer, which is not,
/// would find nothing: there is no unsafe code.
const INSTRUMENTS: &str = "-Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
    -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table \
    -Cllvm-args=-sanitizer-coverage-trace-compares -Ccodegen-units=1 --cfg=fuzzing";

fn libfuzzer(root: &Path, name: &OsString, rest: &[OsString]) -> End {
    if !Command::new("c++").arg("--version").output().is_ok_and(|o| o.status.success()) {
        eprintln!(
            "error: libFuzzer is not available: it is C++, and there is no `c++`. `cargo xtask fuzz` runs without"
        );
        return End::Usage;
    }
    let target = root.join("target").join("libfuzzer");
    let corpus = target.join(format!("corpus-{}", name.to_string_lossy()));
    // What it finds is no file of the checkout.
    let found = target.join("found");
    for folder in [&corpus, &found] {
        if let Err(error) = std::fs::create_dir_all(folder) {
            eprintln!("error: {}: {error}", folder.display());
            return End::Disk;
        }
    }
    // Nearly-profiles to begin with: chance would be long at finding one.
    if !program(root, "fuzz").args(["--", "--corpus"]).arg(&corpus).status().is_ok_and(|s| s.success()) {
        return End::Findings;
    }
    let mut cargo = Command::new("cargo");
    cargo.args(["run", "--release", "--locked", "--quiet", "--manifest-path"]);
    cargo.arg(root.join("tests").join("fuzz").join("libfuzzer").join("Cargo.toml"));
    // With a target named, build scripts and macros stay as they are.
    cargo.args(["--target", &host(), "--target-dir"]).arg(&target).env("RUSTFLAGS", INSTRUMENTS);
    cargo.env("DRIVEWRIGHT_TARGET", name).arg("--").arg(corpus);
    // The last of two options counts, so that the user's own does.
    cargo.arg(format!("-artifact_prefix={}/", found.display())).args(rest);
    end(cargo.status())
}

/// The triple of this machine.
fn host() -> String {
    let said =
        Command::new("rustc").arg("-vV").output().map(|o| String::from_utf8_lossy(&o.stdout).into_owned());
    let said = said.unwrap_or_default();
    said.lines().find_map(|l| l.strip_prefix("host: ")).unwrap_or_default().to_owned()
}

fn end(status: std::io::Result<ExitStatus>) -> End {
    match status {
        Ok(status) if status.success() => End::Fine,
        Ok(_) => End::Findings,
        Err(error) => {
            eprintln!("error: `cargo` cannot be started: {error}");
            End::Disk
        }
    }
}
