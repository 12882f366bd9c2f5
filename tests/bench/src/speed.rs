//! How long compiling takes, stage by stage, and how much memory: in a process of its own for each size.

use std::error::Error;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use drivewright_codegen::{backend, compile, emit};

use crate::{child, feed, synthetic};

/// Seconds of a size.
pub struct Speed {
    pub entries: usize,
    /// From texts in memory to all files in memory.
    pub total: f64,
    /// Each stage: `compile`, then each backend by its id.
    pub stages: Vec<(String, f64)>,
    /// Bytes at the peak.
    pub memory: u64,
    /// Bytes of all files.
    pub output: u64,
}

/// Measures `entries` in this process and prints a line a run: what [`measure`] reads.
pub fn print(entries: usize, runs: usize) -> Result<(), Box<dyn Error>> {
    let drive = synthetic::drive(entries);
    let sources = feed::profile::write(&drive);
    println!("entries {}", drive.entries());
    for _ in 0..runs {
        let sources = sources.clone();
        let start = Instant::now();
        let compiled = compile(sources);
        let model = compiled.sound().ok_or_else(|| format!("{:?}", compiled.diagnostics.first()))?;
        println!("compile {}", start.elapsed().as_secs_f64());
        let mut bytes = 0;
        // All files are kept to the end, as a run of the compiler keeps them.
        let mut kept = Vec::new();
        for backend in backend::ALL {
            let start = Instant::now();
            let (files, _) = emit(model, &[*backend]);
            println!("{} {}", backend.id(), start.elapsed().as_secs_f64());
            bytes += files.iter().map(|(_, text)| text.len()).sum::<usize>();
            kept.push(files);
        }
        println!("total {}\noutput {bytes}", start.elapsed().as_secs_f64());
    }
    Ok(())
}

/// Measures `entries`; each figure is the least of `runs`.
pub fn measure(program: &Path, entries: usize, runs: usize) -> Result<Speed, Box<dyn Error>> {
    let run = |runs: usize| {
        let (entries, runs) = (entries.to_string(), runs.to_string());
        child::run(Command::new(program).args(["--measure-compile", &entries, &runs]))
    };
    let memory = run(1)?.memory;
    let text = run(runs)?.text;
    let figure = |of: &str| {
        let lines = text.lines().filter_map(|l| l.split_once(' ')).filter(|l| l.0 == of);
        child::least(lines.filter_map(|l| l.1.parse().ok()).collect())
    };
    let stages = ["compile"].into_iter().chain(backend::ALL.iter().map(|b| b.id()));
    Ok(Speed {
        entries: figure("entries") as usize,
        total: figure("total"),
        stages: stages.map(|stage| (stage.to_owned(), figure(stage))).collect(),
        memory,
        output: figure("output") as u64,
    })
}
