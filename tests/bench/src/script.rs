//! The compiler inside a build script of a debug build, where nothing of it is optimized.

use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::crates::write;
use crate::{child, feed, synthetic};

const BUILD: &str = r#"
use std::{env, fs, path::Path, time::Instant};
fn main() {
    let start = Instant::now();
    let (compiled, _) = drivewright_codegen::compile_folder(Path::new("profile"));
    let model = compiled.sound().expect("a sound profile");
    let (files, _) = drivewright_codegen::emit(model, drivewright_codegen::backend::ALL);
    assert!(!files.is_empty());
    let all = start.elapsed();
    let start = Instant::now();
    drivewright_codegen::build("profile");
    fs::write(env::var("BENCH_OUT").unwrap(), format!("{} {}", all.as_secs_f64(), start.elapsed().as_secs_f64())).unwrap();
}
"#;

/// Seconds for every output, and of `build()`, which writes the Rust file alone.
pub struct Times {
    pub all: f64,
    pub build: f64,
}

/// Measures a drive of `entries` once.
pub fn measure(entries: usize, scratch: &Path, root: &Path, target: &Path) -> Result<Times, Box<dyn Error>> {
    let folder = scratch.join("script");
    let codegen = root.join("codegen");
    let manifest = format!(
        "[package]\nname = \"script\"\nversion = \"0.0.0\"\nedition = \"2021\"\n[workspace]\n[build-dependencies]\ndrivewright-codegen = {{ path = {codegen:?} }}\n"
    );
    write(&folder.join("Cargo.toml"), manifest.as_bytes())?;
    write(&folder.join("build.rs"), BUILD.as_bytes())?;
    write(&folder.join("src").join("lib.rs"), b"")?;
    for source in feed::profile::write(&synthetic::drive(entries)) {
        write(&folder.join("profile").join(source.path), source.text.as_bytes())?;
    }
    let out = scratch.join("script.txt");
    let mut cargo = Command::new("cargo");
    cargo.args(["build", "--quiet", "--target-dir"]).arg(target).current_dir(&folder);
    child::run(cargo.env("BENCH_OUT", &out))?;
    let text = fs::read_to_string(&out)?;
    let (all, build) = text.split_once(' ').ok_or("the build script measured nothing")?;
    Ok(Times { all: all.parse()?, build: build.parse()? })
}
