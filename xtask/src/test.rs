//! Runs everything, step by step, with the time of each, and says what was skipped and why.

use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use crate::outcome::Outcome;
use crate::{End, Options, audits, judges, outside, regen, snapshots};

/// A step that ran.
pub struct Step {
    pub name: String,
    pub outcome: Outcome,
    pub time: Duration,
}

/// Runs every step.
pub fn run(root: &Path, options: &Options) -> End {
    let mut steps = Vec::new();
    snapshots::forget(root);
    // There is none before the first run.
    let _ = std::fs::remove_file(skips(root));
    for run in COMMANDS {
        step(&mut steps, run.0, options, || command(run, &[], root, options));
    }
    for run in SLOW {
        let why = "only with --full".to_owned();
        step(&mut steps, run.0, options, || {
            if options.full { command(run, MANY, root, options) } else { Outcome::Skipped(why) }
        });
    }
    step(&mut steps, "every snapshot is referenced", options, || snapshots::unreferenced(root));
    let drives = regen::drives(root);
    audits::run(root, &drives, options, &mut |name, audit| step(&mut steps, name, options, audit));
    judges::run(root, options, &mut |name, judge| step(&mut steps, name, options, judge));
    let skips = std::fs::read_to_string(skips(root)).unwrap_or_default();
    for (name, why) in skips.lines().filter_map(|l| l.split_once(": ")) {
        steps.push(Step {
            name: name.to_owned(),
            outcome: Outcome::Skipped(why.to_owned()),
            time: Duration::ZERO,
        });
    }
    summary(&steps)
}

/// Where tests write down what they could not do on this machine, and why.
fn skips(root: &Path) -> std::path::PathBuf {
    root.join("target").join("skipped.txt")
}

/// Name, program, arguments, folder.
type Run = (&'static str, &'static str, &'static [&'static str], &'static str);

/// A driver crate as a user would write it, a workspace of its own.
const EXAMPLE: &str = "examples/sdv3-e-driver";

#[rustfmt::skip]
const COMMANDS: &[Run] = &[
    ("format", "cargo", &["fmt", "--all", "--check"], "."),
    ("format of xtask", "cargo", &["fmt", "--check"], "xtask"),
    ("clippy", "cargo", &["clippy", "--workspace", "--all-targets", "--quiet", "--", "-D", "warnings"], "."),
    ("clippy of xtask", "cargo", &["clippy", "--all-targets", "--quiet", "--", "-D", "warnings"], "xtask"),
    ("generated files are fresh", "cargo", &["xtask", "regen", "--check"], "."),
    ("tests", "cargo", &["test", "--workspace", "--quiet"], "."),
    ("tests of xtask", "cargo", &["test", "--quiet"], "xtask"),
    ("example: format", "cargo", &["fmt", "--check"], EXAMPLE),
    ("example: clippy", "cargo", &["clippy", "--all-targets", "--quiet", "--", "-D", "warnings"], EXAMPLE),
    ("example: tests", "cargo", &["test", "--quiet"], EXAMPLE),
    ("documentation", "cargo", &["doc", "--workspace", "--no-deps", "--quiet"], "."),
    ("tidy", "cargo", &["xtask", "tidy"], "."),
];

/// What `--full` adds: the same tests with many more random cases and kills, and optimized.
#[rustfmt::skip]
const SLOW: &[Run] = &[
    ("tests, optimized, many cases", "cargo", &["test", "--workspace", "--quiet", "--release"], "."),
];
/// How many cases the slow tests try: read by proptest, and by the test that kills the sink.
const MANY: &[(&str, &str)] = &[("PROPTEST_CASES", "5000"), ("DRIVEWRIGHT_KILLS", "400")];

fn step(steps: &mut Vec<Step>, name: &str, options: &Options, run: impl FnOnce() -> Outcome) {
    if !options.quiet {
        println!("== {name}");
    }
    let start = Instant::now();
    let outcome = run();
    let time = start.elapsed();
    if !options.quiet {
        println!("== {name}: {} in {:.1} s", outcome.word(), time.as_secs_f64());
    }
    steps.push(Step { name: name.to_owned(), outcome, time });
}

fn command(run: &Run, variables: &[(&str, &str)], root: &Path, options: &Options) -> Outcome {
    let (_, program, args, folder) = *run;
    let folder = root.join(folder);
    let mut command = Command::new(program);
    command.args(args).current_dir(folder).env("INSTA_UPDATE", "no").env("RUSTDOCFLAGS", "-D warnings");
    command.envs(variables.iter().copied()).envs(outside::variables());
    command.env(snapshots::VARIABLE, snapshots::references(root)).env("DRIVEWRIGHT_SKIPS", skips(root));
    if options.quiet {
        command.stdout(std::process::Stdio::null());
    }
    match command.status() {
        Ok(status) if status.success() => Outcome::Passed,
        Ok(status) => Outcome::Failed(format!("`{program} {}` ended with {status}", args.join(" "))),
        Err(error) => Outcome::Failed(format!("`{program}` cannot be started: {error}")),
    }
}

fn summary(steps: &[Step]) -> End {
    println!("\n{:<40} {:>8}  result", "step", "seconds");
    for step in steps {
        println!("{:<40} {:>8.1}  {}", step.name, step.time.as_secs_f64(), step.outcome.word());
    }
    for step in steps {
        match &step.outcome {
            Outcome::Passed => {}
            Outcome::Failed(why) => println!("failed: {}: {why}", step.name),
            Outcome::Skipped(why) => println!("skipped: {}: {why}", step.name),
        }
    }
    let count = |of: &str| steps.iter().filter(|s| s.outcome.word() == of).count();
    let failed = count("FAILED");
    println!("{} passed, {failed} failed, {} skipped", count("passed"), count("skipped"));
    if failed == 0 { End::Fine } else { End::Findings }
}
