//! `cargo xtask test` runs this: many inputs in a row, the same on every machine.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use drivewright_fuzz::input::Inputs;
use drivewright_fuzz::run::{Plan, Report, run};
use drivewright_fuzz::targets::{Target, targets};
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
    let inputs = Inputs::new();
    println!("{} seeds", inputs.seeds());
    let mut targets: Vec<(Target, usize)> = targets().into_iter().map(|t| (t, 1)).collect();
    targets.retain(|(t, _)| only.as_ref().is_none_or(|name| *name == t.name));
    let others = targets.len().saturating_sub(1);
    targets.first_mut().ok_or("there is no such target")?.1 = ROUND.saturating_sub(others).max(1);
    let folder = folder()?;
    let plan = Plan {
        targets,
        numbers: from..from + many,
        threads: std::thread::available_parallelism().map_or(1, usize::from),
        patience: Duration::from_secs(30),
        notes: Some(folder.clone()),
    };
    let start = Instant::now();
    let report = run(inputs, plan);
    println!("{many} inputs in {:.1} s", start.elapsed().as_secs_f64());
    Ok(told(&report, &folder)? && reached(&report, many, only.is_some()) && memory())
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
        std::fs::write(&path, Inputs::new().get(failure.number))?;
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
