//! Builds the programs without std beside the tests, each a workspace of its own.

use std::path::Path;
use std::process::{Command, Output};

/// A microcontroller whose target many have installed.
pub const MICROCONTROLLER: &str = "thumbv7em-none-eabihf";

/// Without start files there is no `main`; `memcpy` and its kin still come from the C library.
const LINKED: &str = "build.rustflags = ['-Clink-arg=-nostartfiles', '-Clink-arg=-lc']";

/// What must hold on this machine: a target, or nothing for the machine itself; the reason where it cannot be built.
pub fn buildable(target: Option<&str>) -> Result<(), String> {
    match target {
        None if !cfg!(target_os = "linux") => Err("the linker flags are those of Linux".into()),
        Some(target) if !installed(target) => {
            Err(format!("target {target} is not installed (rustup target add {target})"))
        }
        _ => Ok(()),
    }
}

/// Builds `tests/<name>` for this machine or a target, with everything kept out of its folder.
///
/// # Errors
/// Where `cargo` cannot be started.
pub fn build(name: &str, target: Option<&str>, arguments: &[&str]) -> std::io::Result<Output> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--offline", "--manifest-path"]).arg(folder.join("Cargo.toml"));
    cargo.arg("--target-dir").arg(scratch().join(name)).args(arguments);
    match target {
        None => cargo.args(["--config", LINKED]),
        Some(target) => cargo.args(["--target", target]),
    };
    // Flags of the surrounding build, such as coverage, would ask for std.
    cargo.env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    cargo.output()
}

/// A folder beside the program that runs.
fn scratch() -> std::path::PathBuf {
    let program = std::env::current_exe().unwrap_or_default();
    program.ancestors().nth(3).unwrap_or(Path::new("target")).join("bare")
}

/// Whether the standard library of a target is there, asked of the compiler itself.
fn installed(target: &str) -> bool {
    let rustc = env!("CARGO").replace("cargo", "rustc");
    let output = Command::new(rustc).args(["--print", "target-libdir", "--target", target]).output();
    output.is_ok_and(|o| Path::new(String::from_utf8_lossy(&o.stdout).trim()).exists())
}
