//! `cargo xtask test` runs this: many inputs in a row, the same on every machine.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use drivewright_fuzz::behaviour;
use drivewright_fuzz::input::Inputs;
use drivewright_fuzz::run::{Plan, Report, run};
use drivewright_fuzz::targets::{Kind, Target, all, targets};
use lexopt::prelude::*;

const HELP: &str = "\
Usage: drivewright-fuzz [OPTIONS]

Options:
      --inputs N   how many inputs (default 1000000)
      --from N     number of the first (default 0)
      --only NAME  one target
      --print N    print input N and end
      --corpus DIR  write the first thousand inputs to a folder and end
";

/// Inputs from which on a run must have reached much: fewer may have missed it.
const MANY: u64 = 100_000;
/// Different codes that many inputs reach at least.
const CODES: usize = 90;
/// One of how many inputs is a sound profile at least.
const SOUND: u64 = 10;
/// Memory that the process may need at its peak.
const MEMORY: u64 = 2 << 30;
/// Of this many inputs each backend gets one, `parse_profile` the others: emitting and reading back is the slow part.
const ROUND: usize = 16;
/// Of so many inputs the client gets three: a virtual drive takes longer.
const SHARES: [usize; 2] = [3, 1];

fn main() -> ExitCode {
    match start() {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}\n\n{HELP}");
            ExitCode::from(2)
        }
    }
}

fn start() -> Result<bool, Box<dyn Error>> {
    let (mut many, mut from, mut only) = (1_000_000_u64, 0_u64, None);
    let mut args = lexopt::Parser::from_env();
    while let Some(arg) = args.next()? {
        match arg {
            Long("inputs") => many = args.value()?.parse()?,
            Long("from") => from = args.value()?.parse()?,
            Long("only") => only = Some(args.value()?.string()?),
            Long("print") => return print(args.value()?.parse()?),
            Long("corpus") => return corpus(Path::new(&args.value()?)),
            other => return Err(other.unexpected().into()),
        }
    }
    let (compiler, runtime) = (targets(), behaviour::targets());
    let asked = |targets: Vec<Target>| -> Vec<Target> {
        targets.into_iter().filter(|t| only.as_ref().is_none_or(|name| *name == t.name)).collect()
    };
    let (compiler, runtime) = (asked(compiler), asked(runtime));
    if compiler.is_empty() && runtime.is_empty() {
        return Err("there is no such target".into());
    }
    let (numbers, part) = (from..from + many, only.is_some());
    let mut fine = true;
    if !compiler.is_empty() {
        let others = compiler.len() - 1;
        let first = |n| if n == 0 { ROUND.saturating_sub(others).max(1) } else { 1 };
        let shares = compiler.into_iter().enumerate().map(|(n, t)| (t, first(n))).collect();
        let report = fed(shares, numbers.clone())?;
        fine &= told(&report, &folder()?)? && reached(&report, many, part);
    }
    if !runtime.is_empty() {
        let shares = runtime.into_iter().zip(SHARES).collect();
        let report = fed(shares, numbers)?;
        fine &= told(&report, &folder()?)? && operated(&report, many, part);
    }
    Ok(fine && memory())
}

/// Feeds some targets, each with its share of the inputs.
fn fed(targets: Vec<(Target, usize)>, numbers: std::ops::Range<u64>) -> Result<Report, Box<dyn Error>> {
    let (inputs, many) = (Inputs::new(), numbers.end - numbers.start);
    println!("{} seeds", inputs.seeds());
    let plan = Plan {
        targets,
        numbers,
        threads: std::thread::available_parallelism().map_or(1, usize::from),
        patience: Duration::from_secs(30),
        notes: Some(folder()?),
    };
    let start = Instant::now();
    let report = run(inputs, plan);
    println!("{many} inputs in {:.1} s", start.elapsed().as_secs_f64());
    Ok(report)
}

/// Where failing inputs go.
fn folder() -> std::io::Result<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/fuzz-findings");
    std::fs::create_dir_all(&folder)?;
    Ok(folder)
}

fn print(number: u64) -> Result<bool, Box<dyn Error>> {
    use std::io::Write;
    std::io::stdout().write_all(&Inputs::new().get(number))?;
    Ok(true)
}

/// What libFuzzer begins with.
fn corpus(folder: &Path) -> Result<bool, Box<dyn Error>> {
    let inputs = Inputs::new();
    for number in 0..1_000 {
        std::fs::write(folder.join(number.to_string()), inputs.get(number))?;
    }
    Ok(true)
}

/// Says what each target reached, and keeps the inputs that failed.
fn told(report: &Report, folder: &Path) -> std::io::Result<bool> {
    println!("{:<16} {:>9} {:>9} {:>6}", "target", "inputs", "sound", "codes");
    for count in &report.counts {
        println!("{:<16} {:>9} {:>9} {:>6}", count.name, count.inputs, count.sound, count.codes.len());
    }
    for failure in &report.failures {
        let path = folder.join(format!("{}-{}", failure.target, failure.number));
        std::fs::write(&path, failing(&failure.target, failure.number))?;
        println!(
            "FAILED: {}, input {}: {}\n  kept as {}",
            failure.target,
            failure.number,
            failure.why,
            path.display()
        );
    }
    Ok(report.failures.is_empty())
}

/// The input that a target failed with.
fn failing(target: &str, number: u64) -> Vec<u8> {
    let kind = all().into_iter().find(|t| t.name == target).map_or(Kind::Text, |t| t.kind);
    Inputs::new().of(kind, number)
}

/// Client and drive are in operation in many inputs; otherwise little was tried.
fn operated(report: &Report, many: u64, part: bool) -> bool {
    let enough = report.counts.iter().all(|c| c.sound >= c.inputs / SOUND && c.codes.len() > 1);
    if many >= MANY && !part && !enough {
        println!("FAILED: one input of {SOUND} is to reach operation, with each target");
    }
    enough || part || many < MANY
}

/// A fuzzer that reaches nothing finds nothing.
fn reached(report: &Report, many: u64, part: bool) -> bool {
    let codes: std::collections::BTreeSet<&str> =
        report.counts.iter().flat_map(|c| c.codes.iter().copied()).collect();
    let sound: u64 = report.counts.iter().map(|c| c.sound).sum();
    println!("{} different codes, {sound} sound profiles", codes.len());
    let enough = codes.len() >= CODES && sound >= many / SOUND;
    if many >= MANY && !part && !enough {
        println!("FAILED: at least {CODES} codes and {} sound profiles are to be reached", many / SOUND);
        return false;
    }
    true
}

/// No input may need much memory. Where the system does not say how much was needed, nothing is said.
fn memory() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|l| l.strip_prefix("VmHWM:"));
    let kilobytes = peak.and_then(|l| l.trim().trim_end_matches(" kB").parse::<u64>().ok());
    let Some(bytes) = kilobytes.map(|kb| kb << 10) else { return true };
    println!("{} MB of memory at the peak", bytes >> 20);
    if bytes > MEMORY {
        println!("FAILED: {} MB are the most", MEMORY >> 20);
    }
    bytes <= MEMORY
}
