//! Builds the tests of the copy and runs those of one bug.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use super::Program;
use super::list::Mutant;

/// A bug that makes a test run without end is seen, too: no test needs as long as this.
const PATIENCE: Duration = Duration::from_secs(120);

/// The targets of all mutants, each once.
pub fn targets(mutants: &[Mutant]) -> Vec<String> {
    let mut targets: Vec<String> = mutants.iter().flat_map(|m| m.targets.iter().cloned()).collect();
    targets.sort();
    targets.dedup();
    targets
}

/// The target that stands for the unit tests of the runtime.
const UNITS: &str = "runtime";

/// Builds test targets of `drivewright-tests`, and says where each program is.
pub fn build(tree: &Path, targets: &[String]) -> Result<Vec<Program>, String> {
    let (units, others): (Vec<String>, Vec<String>) = targets.iter().cloned().partition(|t| t == UNITS);
    let mut said = String::new();
    if !others.is_empty() {
        let tests = others.iter().flat_map(|target| ["--test".to_owned(), target.clone()]);
        said += &built(tree, "drivewright-tests", &tests.collect::<Vec<_>>())?;
    }
    if !units.is_empty() {
        said += &built(tree, "drivewright-runtime", &["--lib".to_owned()])?;
    }
    let found = |target: &String| {
        Ok((target.clone(), tree.join(program(&said, target).ok_or("cargo names no program")?)))
    };
    targets.iter().map(found).collect()
}

/// What cargo says of the programs that it has built.
fn built(tree: &Path, package: &str, which: &[String]) -> Result<String, String> {
    let mut cargo = Command::new("cargo");
    cargo.args(["test", "--no-run", "--locked", "-p", package]).args(which).current_dir(tree);
    cargo.env("CARGO_TARGET_DIR", tree.with_file_name("build")).env("CARGO_INCREMENTAL", "1");
    cargo.env("CARGO_PROFILE_DEV_DEBUG", "0").env("RUSTFLAGS", "-Awarnings");
    let output = cargo.output().map_err(|e| format!("`cargo` cannot be started: {e}"))?;
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    if output.status.success() {
        return Ok(said);
    }
    let first = said.lines().find(|line| line.starts_with("error")).unwrap_or_default();
    Err(format!("it does not compile: {first}"))
}

/// `Executable tests/x.rs (path)`, as `cargo test --no-run` says it.
fn program(said: &str, target: &str) -> Option<PathBuf> {
    let mut sources = vec![format!("tests/{target}.rs ("), format!("tests/{target}/main.rs (")];
    sources.extend((target == UNITS).then(|| "unittests src/lib.rs (".to_owned()));
    let line = said.lines().find(|line| sources.iter().any(|source| line.contains(source)))?;
    Some(PathBuf::from(line.rsplit_once('(')?.1.trim_end_matches(')')))
}

/// The tests of a mutant's bug are there and green without it.
pub fn sound(mutant: &Mutant, programs: &[Program]) -> Result<(), String> {
    let mut tests = 0;
    for (target, program) in of(mutant, programs) {
        let ran = tried(&mutant.bug, program)?;
        if !ran.green {
            return Err(format!("{}: {target} is not green without it: {}", mutant.name, ran.said));
        }
        tests += ran.tests;
    }
    if tests == 0 { Err(format!("{}: no test has {}_ in its name", mutant.name, mutant.bug)) } else { Ok(()) }
}

/// The tests that see it; the reason where none does.
pub fn red(mutant: &Mutant, programs: &[Program]) -> Result<String, String> {
    let mut seen = Vec::new();
    for (_, program) in of(mutant, programs) {
        let ran = tried(&mutant.bug, program)?;
        if !ran.green {
            seen.push(ran.said);
        }
    }
    if seen.is_empty() { Err("every test stays green".into()) } else { Ok(seen.join(", ")) }
}

fn of<'p>(mutant: &'p Mutant, programs: &'p [Program]) -> impl Iterator<Item = &'p Program> {
    programs.iter().filter(|(target, _)| mutant.targets.contains(target))
}

/// What the tests of one program came to.
struct Ran {
    green: bool,
    tests: usize,
    /// Names of those that failed, or why there are none.
    said: String,
}

fn tried(bug: &str, program: &Path) -> Result<Ran, String> {
    let mut command = Command::new(program);
    command.arg(format!("{bug}_")).current_dir(folder(program)).stdout(Stdio::piped()).stderr(Stdio::null());
    let child = command.spawn().map_err(|e| format!("{}: {e}", program.display()))?;
    let Some(said) = ended(child) else {
        return Ok(Ran { green: false, tests: 1, said: "it does not end".into() });
    };
    let failed: Vec<&str> =
        said.lines().filter_map(|l| l.strip_prefix("test ")?.strip_suffix(" ... FAILED")).collect();
    let passed = said.lines().filter(|l| l.starts_with("test ") && l.ends_with(" ... ok")).count();
    let green = failed.is_empty() && said.contains("test result: ok");
    let tests = passed + failed.len();
    // A stack that overflows ends the program before it names a test.
    let said = if failed.is_empty() { "the program ends".into() } else { failed.join(", ") };
    Ok(Ran { green, tests, said })
}

/// Tests run in the folder of their package, as cargo does it.
fn folder(program: &Path) -> PathBuf {
    let build = program.ancestors().find(|folder| folder.ends_with("build"));
    build.map_or_else(PathBuf::new, |build| build.with_file_name("tree").join("tests"))
}

/// What a program says until its end; `None` where that does not come. Each line is read as it comes.
fn ended(mut child: Child) -> Option<String> {
    let out = child.stdout.take()?;
    let reader = std::thread::spawn(move || std::io::read_to_string(out).unwrap_or_default());
    let start = Instant::now();
    while child.try_wait().ok()?.is_none() {
        if start.elapsed() > PATIENCE {
            // It may have ended in between.
            let _ = child.kill();
            let _ = child.wait();
            return None;
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    reader.join().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_is_found_by_its_target() {
        let said = "   Compiling x\n  Executable tests/cia402/main.rs (../build/debug/deps/cia402-1)\n  Executable tests/bugs.rs (/t/bugs-2)\n";
        assert_eq!(program(said, "cia402"), Some("../build/debug/deps/cia402-1".into()));
        assert_eq!(program(said, "bugs"), Some("/t/bugs-2".into()));
        assert_eq!(program(said, "bug"), None);
        let said = "  Executable unittests src/lib.rs (../build/debug/deps/drivewright_runtime-3)";
        assert_eq!(program(said, "runtime"), Some("../build/debug/deps/drivewright_runtime-3".into()));
    }
}
