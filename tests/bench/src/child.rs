//! Programs that are started, and the memory that they need as the operating system counts it.

use std::error::Error;
use std::io::Read;
use std::process::{Command, Stdio};

use wait4::Wait4;

/// What a program printed and cost.
pub struct Run {
    pub text: String,
    /// Memory of the program, or of one that it waited for, at the peak, in bytes.
    pub memory: u64,
}

/// Runs `command` to its end. What it says on its standard error becomes the reason of a failure.
pub fn run(command: &mut Command) -> Result<Run, Box<dyn Error>> {
    let shown = format!("{:?}", command.get_program());
    let spawned = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let mut child = spawned.map_err(|e| format!("{shown} cannot be started: {e}"))?;
    let (out, err) = (child.stdout.take(), child.stderr.take());
    let errors = std::thread::spawn(move || all(err));
    let text = all(out);
    let used = child.wait4()?;
    let errors = errors.join().unwrap_or_default();
    if used.status.success() {
        return Ok(Run { text, memory: used.rusage.maxrss });
    }
    let said = errors.lines().find(|l| l.starts_with("error")).or(errors.lines().last());
    Err(format!("{shown}: {}: {}", used.status, said.unwrap_or_default()).into())
}

fn all(pipe: Option<impl Read>) -> String {
    let mut bytes = Vec::new();
    // A pipe that breaks ends the text; how the program ended is looked at by itself.
    let _ = pipe.map(|mut pipe| pipe.read_to_end(&mut bytes));
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The least of some numbers: other work on the machine makes a run slower, and nothing makes it faster.
pub fn least(of: Vec<f64>) -> f64 {
    of.into_iter().fold(f64::NAN, f64::min)
}
