//! What is measured, in which order, and the budget of each figure.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::crates::{Cost, Crate};
use crate::peers::{Made, Peer};
use crate::report::{PEERS, Report, Row, Unit};
use crate::speed::Speed;
use crate::{Options, child, crates, flash, pdo, peers, runtime, script, speed};

/// The size that budgets are given for, and that of the crates that `rustc` compiles.
const SIZE: usize = 5_000;
const CRATE: usize = 1_000;
/// What neighbours do not read in one go: more indices than their dictionaries have.
const LARGE: usize = 50_000;

/// Budgets. Time is that of one thread; growth is time for an entry of `LARGE` over that of `SIZE`.
mod budget {
    pub const SECONDS: f64 = 0.30;
    pub const MEMORY: f64 = 120e6;
    pub const GROWTH: f64 = 1.5;
    pub const SCRIPT: f64 = 1.0;
    pub const CHECK: f64 = 0.25;
    pub const RELEASE: f64 = 0.5;
    pub const PDO: f64 = 1.05;
    pub const FLASH: f64 = 2_000.0;
    pub const AXIS_SECOND: f64 = 1e-4;
}

struct Bench<'a> {
    options: &'a Options,
    root: &'a Path,
    target: PathBuf,
    scratch: PathBuf,
    peers: [Option<Peer>; PEERS.len()],
    report: Report,
}

/// Measures everything.
pub fn all(options: &Options, root: &Path) -> Result<Report, Box<dyn Error>> {
    let target = root.join("target").join("bench");
    let scratch = target.join("scratch");
    std::fs::create_dir_all(&scratch)?;
    let report = Report { machine: machine(), ..Report::default() };
    let mut bench = Bench { options, root, target, scratch, peers: [None, None], report };
    bench.build_peers();
    bench.compile()?;
    bench.in_a_build_script();
    bench.generated_crate()?;
    eprintln!("process data");
    let row = Row::new("PDO pack and unpack, over bytes by hand", Unit::Ratio, pdo::ratio());
    bench.report.rows.push(row.budget(budget::PDO));
    bench.runtime();
    Ok(bench.report)
}

/// Cores and compiler: what a figure means without them, nobody knows.
fn machine() -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let rustc =
        child::run(Command::new("rustc").arg("--version")).map_or_else(|_| "rustc".into(), |r| r.text);
    let rustc = rustc.split(" (").next().unwrap_or_default().trim().to_owned();
    format!("{rustc} on {} {}, {cores} cores", std::env::consts::ARCH, std::env::consts::OS)
}

impl Bench<'_> {
    fn runs(&self) -> usize {
        if self.options.quick { 3 } else { 7 }
    }

    /// What was measured, unless it was skipped.
    fn tried<T>(&mut self, what: &str, tried: Result<T, Box<dyn Error>>) -> Option<T> {
        tried.map_err(|why| self.report.skipped.push(format!("{what}: {why}"))).ok()
    }

    fn build_peers(&mut self) {
        if self.options.quick {
            return self.report.skipped.push("other compilers: not with --quick".into());
        }
        for (n, name) in PEERS.into_iter().enumerate() {
            eprintln!("building {name}");
            let built = peers::build(name, &self.root.join("tests").join("bench"), &self.target);
            self.peers[n] = self.tried(name, built);
        }
    }

    /// What each peer makes of a drive of `entries`.
    fn made(&mut self, entries: usize) -> [Option<Made>; PEERS.len()] {
        let (runs, scratch) = (self.runs().min(3), self.scratch.clone());
        std::array::from_fn(|n| {
            let made = self.peers[n].as_ref().map(|p| p.make(entries, runs, &scratch))?;
            self.tried(&format!("{} on {entries} entries", PEERS[n]), made)
        })
    }

    fn compile(&mut self) -> Result<(), Box<dyn Error>> {
        let program = std::env::current_exe()?;
        let measure = |entries: usize, runs: usize| {
            eprintln!("compiling {entries} entries");
            speed::measure(&program, entries, runs)
        };
        let (small, middle) = (measure(CRATE, self.runs())?, measure(SIZE, self.runs())?);
        let made = [self.made(CRATE), self.made(SIZE)];
        for (speed, made) in [&small, &middle].into_iter().zip(&made) {
            let row = Row::new(format!("compile {} entries", speed.entries), Unit::Seconds, speed.total);
            let row = row.beside(made.each_ref().map(|m| Some(m.as_ref()?.seconds)));
            self.report.rows.push(if speed.entries == SIZE { row.budget(budget::SECONDS) } else { row });
        }
        let peers = made[1].each_ref();
        self.stages(&middle);
        let memory = Row::new(format!("memory for {SIZE} entries"), Unit::Bytes, middle.memory as f64);
        let memory = memory.budget(budget::MEMORY).beside(peers.map(|m| Some(m.as_ref()?.memory as f64)));
        let output = Row::new(format!("output of {SIZE} entries"), Unit::Bytes, middle.output as f64);
        let output = output.beside(peers.map(|m| Some(m.as_ref()?.code.len() as f64)));
        self.report.rows.extend([memory, output]);
        if self.options.quick {
            self.report.skipped.push(format!("{LARGE} entries: not with --quick"));
            return Ok(());
        }
        let large = measure(LARGE, 3)?;
        self.growth(&middle, &large);
        Ok(())
    }

    fn stages(&mut self, speed: &Speed) {
        for (stage, seconds) in &speed.stages {
            let what = format!("  of {} entries: {stage}", speed.entries);
            self.report.rows.push(Row::new(what, Unit::Seconds, *seconds));
        }
    }

    fn growth(&mut self, middle: &Speed, large: &Speed) {
        let each = |seconds: f64, of: &Speed| seconds / of.entries as f64;
        let row = Row::new(format!("compile {} entries", large.entries), Unit::Seconds, large.total);
        let growth = each(large.total, large) / each(middle.total, middle);
        let what = format!("time for an entry: of {LARGE} over of {SIZE}");
        self.report.rows.extend([row, Row::new(what, Unit::Ratio, growth).budget(budget::GROWTH)]);
        for ((stage, late), (_, early)) in large.stages.iter().zip(&middle.stages) {
            let what = format!("  the same: {stage}");
            self.report.rows.push(Row::new(what, Unit::Ratio, each(*late, large) / each(*early, middle)));
        }
    }

    fn in_a_build_script(&mut self) {
        if self.options.quick {
            return self.report.skipped.push("a debug build script: not with --quick".into());
        }
        eprintln!("compiling in a debug build script");
        let times = script::measure(SIZE, &self.scratch, self.root, &self.target);
        if let Some(times) = self.tried("a debug build script", times) {
            let what = format!("compile {SIZE} entries in a debug build script");
            self.report.rows.push(Row::new(what, Unit::Seconds, times.all).budget(budget::SCRIPT));
            self.report.rows.push(Row::new(
                "  the same: build(), the Rust file alone",
                Unit::Seconds,
                times.build,
            ));
        }
    }

    /// What the crate of `CRATE` entries costs its users.
    fn generated_crate(&mut self) -> Result<(), Box<dyn Error>> {
        let ours = crates::ours(CRATE, &self.scratch, self.root)?;
        let made = self.made(CRATE);
        let theirs: [Option<Crate>; PEERS.len()] = std::array::from_fn(|n| {
            let (peer, made) = (self.peers[n].as_ref()?, made[n].as_ref()?);
            let written = crates::single(peer.name, peer.manifest(), &made.code, &self.scratch);
            self.tried(&format!("crate of {}", PEERS[n]), written)
        });
        for (arguments, budget) in
            [(&["check"][..], budget::CHECK), (&["build", "--release"], budget::RELEASE)]
        {
            let name = format!("`cargo {}` of {CRATE} entries", arguments.join(" "));
            eprintln!("{name}");
            let cost = crates::cost(&ours, arguments, self.runs().min(5), &self.target)?;
            let others: [Option<Cost>; PEERS.len()] = std::array::from_fn(|n| {
                let cost = theirs[n].as_ref().map(|c| crates::cost(c, arguments, 1, &self.target))?;
                self.tried(&format!("{name}: {}", PEERS[n]), cost)
            });
            let time = Row::new(format!("{name}, processor time"), Unit::Seconds, cost.cpu);
            let memory = Row::new(format!("{name}, rustc's memory"), Unit::Bytes, cost.memory as f64);
            self.report.rows.push(time.budget(budget).beside(others.map(|c| Some(c?.cpu))));
            self.report.rows.push(memory.beside(others.map(|c| Some(c?.memory as f64))));
        }
        let size = crates::packed(&ours)? as f64;
        let sizes = std::array::from_fn(|n| {
            let size = theirs[n].as_ref().map(crates::packed)?;
            self.tried(&format!("package of {}", PEERS[n]), size).map(|n| n as f64)
        });
        let row = Row::new(format!("package of {CRATE} entries, unpacked"), Unit::Bytes, size);
        self.report.rows.push(row.beside(sizes));
        eprintln!("flash");
        let flash = flash::measure(&ours, CRATE, &self.scratch, &self.target);
        if let Some(flash) = self.tried(&format!("flash on {}", flash::TARGET), flash) {
            let more = flash.ours as f64 - flash.hand as f64;
            let what = format!("flash for 10 of {CRATE} objects, over {} B by hand", flash.hand);
            self.report.rows.push(Row::new(what, Unit::Bytes, more).budget(budget::FLASH));
        }
        Ok(())
    }

    /// Client, dictionary and virtual drive.
    fn runtime(&mut self) {
        eprintln!("client and virtual drive");
        for entries in [10, 1_000, 50_000] {
            let what = format!("look-up in a dictionary of {entries} entries");
            self.report.rows.push(Row::new(what, Unit::Seconds, runtime::look_up(entries)).headline());
        }
        let cycle = runtime::cycle().ok_or("the SDV3-E lacks the layouts".into());
        if let Some([image, hand, whole]) = self.tried("a cycle of the client", cycle) {
            let what = format!("process image of the client, beside {} by hand", Unit::Seconds.text(hand));
            self.report.rows.push(Row::new(what, Unit::Seconds, image).headline());
            self.report
                .rows
                .push(Row::new("  the same with the machine of CiA 402", Unit::Seconds, whole).headline());
        }
        let axis = runtime::axis_second().ok_or("the virtual drive does not operate".into());
        if let Some(seconds) = self.tried("a second of a virtual axis", axis) {
            let row = Row::new("a second of a virtual axis at 1 kHz", Unit::Seconds, seconds);
            self.report.rows.push(row.budget(budget::AXIS_SECOND));
        }
        let flash = flash::enable_and_move(self.root, &self.scratch, &self.target);
        if let Some(flash) = self.tried("flash of enable and move", flash) {
            let what = format!("flash to enable and move an axis, beside {} B by hand", flash.hand);
            self.report.rows.push(Row::new(what, Unit::Bytes, flash.ours as f64).headline());
        }
        let ram = std::mem::size_of::<drivewright_runtime::client::axis::Axis>();
        self.report
            .rows
            .push(Row::new("memory of an axis in the client", Unit::Bytes, ram as f64).headline());
    }
}
