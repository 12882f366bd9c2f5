//! Measures drivewright beside its neighbours, on one machine, in one run: `cargo xtask bench`.
//!
//! Each figure stands beside its budget; nothing here fails because of one. What cannot be measured is skipped with the reason.

mod child;
mod crates;
mod feed;
mod flash;
mod pdo;
mod peers;
mod report;
mod run;
mod runtime;
mod script;
mod speed;
mod synthetic;

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use lexopt::prelude::*;

const HELP: &str = "\
Usage: cargo xtask bench [OPTIONS]

Options:
      --quick          fewer and smaller measurements, no other compilers
      --json           print JSON
      --update-readme  put the table into README.md
";

/// What the command line asks for.
#[derive(Default)]
pub struct Options {
    quick: bool,
    json: bool,
    update_readme: bool,
}

fn main() -> ExitCode {
    if let Some(code) = crates::wrapper() {
        return ExitCode::from(u8::try_from(code).unwrap_or(1));
    }
    match start() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn start() -> Result<(), Box<dyn Error>> {
    let (mut options, mut args) = (Options::default(), lexopt::Parser::from_env());
    while let Some(arg) = args.next()? {
        match arg {
            Long("quick") => options.quick = true,
            Long("json") => options.json = true,
            Long("update-readme") => options.update_readme = true,
            // This program again, as the process that is measured.
            Long("measure-compile") => return speed::print(args.value()?.parse()?, args.value()?.parse()?),
            Short('h') | Long("help") => {
                print!("{HELP}");
                return Ok(());
            }
            other => return Err(other.unexpected().into()),
        }
    }
    let report = run::all(&options, &root())?;
    if options.json {
        println!("{:#}", report::json(&report));
    } else {
        print!("{}", report::text(&report));
    }
    if options.update_readme {
        let path = root().join("README.md");
        let readme = std::fs::read_to_string(&path)?;
        let new = report::in_readme(&report, &readme).ok_or("README.md lacks the two marks of the table")?;
        std::fs::write(path, new)?;
    }
    Ok(())
}

/// The checkout.
fn root() -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.ancestors().nth(2).unwrap_or(here).to_owned()
}
