//! Puts known bugs back, one at a time, into a copy of the checkout, and expects a test to see each.
//!
//! `tests/mutants/bNN-name.patch` is a bug: words first, then a line `tests: TARGET...` (test targets of
//! `drivewright-tests`, or `runtime` for its unit tests), then a diff. The tests whose names have `bNN_` run. `README.md` beside them lists every bug.

mod copy;
mod list;
mod run;

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::{End, Options};
use copy::Copy;
use list::Mutant;

/// Tries every mutant, or those of `--only`.
pub fn run(root: &Path, options: &Options) -> End {
    let folder = root.join("tests").join("mutants");
    let mut mutants = match list::read(&folder) {
        Ok(mutants) => mutants,
        Err(why) => return failed(&why),
    };
    if let Err(why) = list::agree(&folder, &mutants) {
        return failed(&why);
    }
    mutants.retain(|m| options.only.is_empty() || options.only.contains(&m.bug));
    if mutants.is_empty() {
        eprintln!("error: there is no such mutant");
        return End::Usage;
    }
    let copy = Copy { from: root.to_owned(), to: root.join("target").join("mutants").join("tree") };
    match try_all(&copy, &mutants) {
        Ok(0) => End::Fine,
        Ok(_) => End::Findings,
        Err(why) => failed(&why),
    }
}

fn failed(why: &str) -> End {
    eprintln!("error: {why}");
    End::Findings
}

/// How many stayed unseen.
fn try_all(copy: &Copy, mutants: &[Mutant]) -> Result<usize, String> {
    let start = Instant::now();
    copy.refresh()?;
    let programs = run::build(&copy.to, &run::targets(mutants))?;
    println!("the tests of the copy without a bug are built in {:.1} s", start.elapsed().as_secs_f64());
    for mutant in mutants {
        run::sound(mutant, &programs)?;
    }
    println!("{:<34} {:>8}  result", "bug", "seconds");
    let mut unseen = 0;
    for mutant in mutants {
        let start = Instant::now();
        let seen = tried(copy, mutant);
        unseen += usize::from(seen.is_err());
        say(mutant, start.elapsed(), &seen);
    }
    copy.refresh()?;
    println!("{} seen, {unseen} not seen, in {:.0} s", mutants.len() - unseen, start.elapsed().as_secs_f64());
    Ok(unseen)
}

/// What saw it; the reason where nothing did.
fn tried(copy: &Copy, mutant: &Mutant) -> Result<String, String> {
    copy.refresh()?;
    copy.apply(&mutant.path)?;
    let programs = run::build(&copy.to, &mutant.targets)?;
    run::red(mutant, &programs)
}

fn say(mutant: &Mutant, time: Duration, seen: &Result<String, String>) {
    let (word, more) = match seen {
        Ok(by) => ("red", by),
        Err(why) => ("NOT SEEN", why),
    };
    println!("{:<34} {:>8.1}  {word}: {more}", mutant.name, time.as_secs_f64());
}

/// A program of tests with the target that it is of.
type Program = (String, PathBuf);
