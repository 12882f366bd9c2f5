//! Runs everything, step by step, with the time of each, and says what was skipped and why.

use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use crate::outcome::Outcome;
use crate::{End, Options, judges, snapshots};

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
    for (name, program, args, folder) in COMMANDS {
        step(&mut steps, name, options, || command(program, args, root, folder, options));
    }
    step(&mut steps, "every snapshot is referenced", options, || snapshots::unreferenced(root));
    judges::run(root, options.quiet, &mut |name, judge| step(&mut steps, name, options, judge));
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

#[rustfmt::skip]
const COMMANDS: &[Run] = &[
    ("format", "cargo", &["fmt", "--all", "--check"], "."),
    ("format of xtask", "cargo", &["fmt", "--check"], "xtask"),
    ("clippy", "cargo", &["clippy", "--workspace", "--all-targets", "--quiet", "--", "-D", "warnings"], "."),
    ("clippy of xtask", "cargo", &["clippy", "--all-targets", "--quiet", "--", "-D", "warnings"], "xtask"),
    ("generated files are fresh", "cargo", &["xtask", "regen", "--check"], "."),
    ("tests", "cargo", &["test", "--workspace", "--quiet"], "."),
    ("tests of xtask", "cargo", &["test", "--quiet"], "xtask"),
    ("documentation", "cargo", &["doc", "--workspace", "--no-deps", "--quiet"], "."),
    ("tidy", "cargo", &["xtask", "tidy"], "."),
];

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

fn command(program: &str, args: &[&str], root: &Path, folder: &str, options: &Options) -> Outcome {
    let folder = root.join(folder);
    let mut command = Command::new(program);
    command.args(args).current_dir(folder).env("INSTA_UPDATE", "no").env("RUSTDOCFLAGS", "-D warnings");
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
