//! `drivewright`: checks and builds drive profiles, and explains what it says.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    clippy::disallowed_methods,
    reason = "a program, not a library: it reads files and prints"
)]

mod arguments;
mod audit;
mod commands;
mod convert;
mod coverage;
mod dcf;
mod demo;
mod diff;
mod drives;
mod explain;
mod git;
mod output;
mod simulate;
mod stage;
mod todo;
mod trace;

use std::process::ExitCode;

use clap::Parser;

/// How a run ends; the numbers are the exit codes that `--help` names.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum End {
    Fine = 0,
    Findings = 1,
    Usage = 2,
    Disk = 3,
}

fn main() -> ExitCode {
    // clap ends with 2 on wrong usage, and with 0 on --help.
    let arguments = arguments::Arguments::parse();
    ExitCode::from(commands::run(&arguments) as u8)
}
