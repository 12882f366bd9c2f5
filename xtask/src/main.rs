//! The project's own commands: `cargo xtask regen`, `new`, `test`, `tidy`, `bench`, `fuzz`.
//!
//! Exit codes: 0 fine, 1 findings, 2 usage, 3 the disk refused.

#![allow(clippy::disallowed_methods, reason = "a program, not a library: it reads, writes and measures time")]

mod audits;
mod judges;
mod links;
mod mutants;
mod new;
mod outcome;
mod outside;
mod regen;
mod snapshots;
mod test;
mod tidy;
mod tools;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use lexopt::prelude::*;

const HELP: &str = "\
Usage: cargo xtask <COMMAND> [OPTIONS]

Commands:
  regen [DRIVE...]   compile every profile (or those named) to every output under generated/
    --check          write nothing; name every missing, changed and orphaned file, and exit 1 if there is one
    --diff           write nothing; show what would change
  new VENDOR/DRIVE   make a profile that compiles, and list what it does not state yet
  test               run everything and say what was skipped, and why
    --full           add the slow parts
    --mutants        put known bugs back, one at a time, and expect a test to see each; with `--only b04` that one
  tidy               check what no other tool knows
  bench              measure beside other compilers and budgets; `bench --help` has its options
  fuzz               feed the compiler a million inputs of a stable generator
  fuzz TARGET        the same with libFuzzer; what follows are its options

Options:
      --root DIR     work on another checkout
  -q, --quiet        say only what is wrong
  -h, --help         show this

Exit codes: 0 fine, 1 findings, 2 usage, 3 the disk refused.

Examples:
  cargo xtask regen
  cargo xtask regen --check sdv3-e
  cargo xtask new acme/x1
  cargo xtask test --full
  cargo xtask test --mutants --only b04
  cargo xtask bench --quick
  cargo xtask fuzz parse_profile -max_total_time=60
";

/// What the command line asks for.
#[derive(Default)]
pub struct Options {
    check: bool,
    diff: bool,
    full: bool,
    mutants: bool,
    /// Bugs that `--mutants` is for; none: all.
    only: Vec<String>,
    quiet: bool,
    root: Option<PathBuf>,
    drives: Vec<String>,
    /// What `bench` and `fuzz` pass on.
    rest: Vec<std::ffi::OsString>,
}

/// How a command ends.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum End {
    Fine = 0,
    Findings = 1,
    Usage = 2,
    Disk = 3,
}

fn main() -> ExitCode {
    let end = match parse() {
        Ok(None) => {
            print!("{HELP}");
            End::Fine
        }
        Ok(Some((command, options))) => run(&command, &options),
        Err(error) => {
            eprintln!("error: {error}\n\n{HELP}");
            End::Usage
        }
    };
    ExitCode::from(end as u8)
}

fn run(command: &str, options: &Options) -> End {
    let root = options.root.clone().unwrap_or_else(root);
    match command {
        "regen" => regen::run(&root, options),
        "new" => new::run(&root, options),
        "test" if options.mutants => mutants::run(&root, options),
        "test" => test::run(&root, options),
        "tidy" => tidy::run(&root, options),
        "bench" => tools::bench(&root, options),
        "fuzz" => tools::fuzz(&root, options),
        other => {
            eprintln!("error: there is no command `{other}`\n\n{HELP}");
            End::Usage
        }
    }
}

/// The repository's root, wherever the command is called from.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new(".")).to_owned()
}

fn parse() -> Result<Option<(String, Options)>, lexopt::Error> {
    let (mut command, mut options) = (None, Options::default());
    let mut args = lexopt::Parser::from_env();
    while let Some(arg) = args.next()? {
        match arg {
            Short('h') | Long("help") => return Ok(None),
            Short('q') | Long("quiet") => options.quiet = true,
            Long("check") => options.check = true,
            Long("diff") => options.diff = true,
            Long("full") => options.full = true,
            Long("mutants") => options.mutants = true,
            Long("only") => options.only.push(args.value()?.string()?),
            Long("root") => options.root = Some(args.value()?.into()),
            Value(value) if command.is_none() => {
                let name = value.string()?;
                if ["bench", "fuzz"].contains(&name.as_str()) {
                    options.rest = args.raw_args()?.collect();
                }
                command = Some(name);
            }
            Value(value) => options.drives.push(value.string()?),
            other => return Err(other.unexpected()),
        }
    }
    Ok(command.map(|command| (command, options)))
}
