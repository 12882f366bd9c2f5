//! Generated crates on disk, and what their compilation costs.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

use drivewright_codegen::{backend, compile, emit};

use crate::{child, feed, synthetic};

/// Name of the crate that a made-up drive becomes.
pub const OURS: &str = "acme-s1";

/// A generated crate.
pub struct Crate {
    pub name: String,
    pub folder: PathBuf,
}

/// What `rustc` needed for one crate, without its dependencies.
#[derive(Clone, Copy)]
pub struct Cost {
    pub cpu: f64,
    pub memory: u64,
}

/// Writes the crate that drivewright makes of a drive of `entries`.
pub fn ours(entries: usize, scratch: &Path, root: &Path) -> Result<Crate, Box<dyn Error>> {
    let folder = scratch.join("ours");
    let compiled = compile(feed::profile::write(&synthetic::drive(entries)));
    let model = compiled.sound().ok_or("the made-up drive is not sound")?;
    let (files, _) = emit(model, &[&backend::rust::Rust]);
    for (path, text) in files.iter() {
        let mut text = text.to_vec();
        if path.as_str() == "Cargo.toml" {
            text = manifest(&String::from_utf8(text)?, root).into_bytes();
        }
        write(&folder.join(path.as_str()), &text)?;
    }
    Ok(Crate { name: OURS.into(), folder })
}

/// The manifest as it is outside of the checkout: the runtime is where it is, and the crate stands alone.
fn manifest(text: &str, root: &Path) -> String {
    let runtime = format!("path = {:?}", root.join("runtime"));
    text.replace("path = \"../../runtime\"", &runtime) + "\n[workspace]\n"
}

/// Writes a crate of one file.
pub fn single(name: &str, manifest: &str, code: &str, scratch: &Path) -> Result<Crate, Box<dyn Error>> {
    let folder = scratch.join(name);
    write(&folder.join("Cargo.toml"), manifest.as_bytes())?;
    write(&folder.join("src").join("lib.rs"), code.as_bytes())?;
    Ok(Crate { name: format!("made-{name}"), folder })
}

/// Writes a file and the folders above it.
pub fn write(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    path.parent().map_or(Ok(()), fs::create_dir_all)?;
    fs::write(path, bytes)
}

/// What `cargo ARGUMENTS` costs for `of` itself: what it depends on is built before. The least of `runs`.
pub fn cost(of: &Crate, arguments: &[&str], runs: usize, target: &Path) -> Result<Cost, Box<dyn Error>> {
    let used = target.join("used.txt");
    let mut costs = Vec::new();
    for _ in 0..=runs {
        let source = fs::File::options().append(true).open(of.folder.join("src").join("lib.rs"))?;
        source.set_modified(SystemTime::now())?;
        let _ = fs::remove_file(&used);
        let mut cargo = Command::new("cargo");
        cargo.args(arguments).args(["--quiet", "--target-dir"]).arg(target).current_dir(&of.folder);
        cargo.env("CARGO_INCREMENTAL", "0").env("RUSTC_WRAPPER", std::env::current_exe()?);
        cargo.env(WATCHED, of.name.replace('-', "_")).env(USED, &used);
        child::run(&mut cargo)?;
        let text = fs::read_to_string(&used)?;
        let (cpu, memory) = text.trim().split_once(' ').ok_or("rustc was not run")?;
        costs.push(Cost { cpu: cpu.parse()?, memory: memory.parse()? });
    }
    // The first run built the dependencies and warmed the disk.
    let costs = costs.split_off(1);
    let memory = child::least(costs.iter().map(|c| c.memory as f64).collect()) as u64;
    Ok(Cost { cpu: child::least(costs.iter().map(|c| c.cpu).collect()), memory })
}

/// Bytes that a package of the crate would hold.
pub fn packed(of: &Crate) -> Result<u64, Box<dyn Error>> {
    let mut cargo = Command::new("cargo");
    cargo.args(["package", "--list", "--allow-dirty", "--quiet"]).current_dir(&of.folder);
    let list = child::run(&mut cargo)?.text;
    Ok(list.lines().filter_map(|l| fs::metadata(of.folder.join(l)).ok()).map(|m| m.len()).sum())
}

/// Environment of the wrapper: the crate whose cost is asked, and the file for the answer.
const WATCHED: &str = "BENCH_WATCHED";
const USED: &str = "BENCH_USED";

/// Stands between cargo and `rustc`, if this process was started for that; gives the exit code.
pub fn wrapper() -> Option<i32> {
    let watched = std::env::var(WATCHED).ok()?;
    let args: Vec<String> = std::env::args().skip(1).collect();
    let (rustc, rest) = args.split_first()?;
    let name = rest.iter().skip_while(|a| *a != "--crate-name").nth(1);
    if name != Some(&watched) {
        return Some(Command::new(rustc).args(rest).status().ok()?.code().unwrap_or(1));
    }
    use wait4::Wait4;
    let used = Command::new(rustc).args(rest).spawn().ok()?.wait4().ok()?;
    let cpu = used.rusage.utime + used.rusage.stime;
    let line = format!("{} {}\n", cpu.as_secs_f64(), used.rusage.maxrss);
    fs::write(std::env::var(USED).ok()?, line).ok()?;
    Some(used.status.code().unwrap_or(1))
}
