//! Feeds targets with inputs, on several threads, and says what was reached.
//!
//! An input that panics or does not end is named by its number, which is all that is needed to make it again.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::{Seek, SeekFrom, Write};
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use crate::input::Inputs;
use crate::targets::{Reached, Target};

/// What to run.
pub struct Plan {
    /// Each with its share: of ten inputs, how many it gets in its turn.
    pub targets: Vec<(Target, usize)>,
    /// Numbers of the inputs.
    pub numbers: Range<u64>,
    /// How many run at a time.
    pub threads: usize,
    /// How long one input may take: far more than any needs.
    pub patience: Duration,
    /// Where each thread notes the number that it is at, for an input that ends the process.
    pub notes: Option<PathBuf>,
}

/// What one target was given and reached.
#[derive(Clone, Default, Debug)]
pub struct Count {
    /// Name of the target.
    pub name: String,
    /// Inputs.
    pub inputs: u64,
    /// Inputs whose model was sound.
    pub sound: u64,
    /// Different codes of findings.
    pub codes: BTreeSet<&'static str>,
}

/// An input that broke a promise.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Failure {
    /// Number of the input.
    pub number: u64,
    /// Target that it was given to.
    pub target: String,
    /// What happened.
    pub why: String,
}

/// What a run came to.
#[derive(Clone, Default, Debug)]
pub struct Report {
    /// What each target reached.
    pub counts: Vec<Count>,
    /// The first failure of each thread.
    pub failures: Vec<Failure>,
}

/// What threads share.
struct Shared {
    inputs: Inputs,
    plan: Plan,
    /// Which target has its turn, for each step of a round.
    turns: Vec<usize>,
    next: AtomicU64,
    /// Number that each thread is at, and when it began; [`IDLE`] when it is at none.
    at: Vec<(AtomicU64, AtomicU64)>,
    running: AtomicUsize,
    start: Instant,
    report: Mutex<Report>,
}

const IDLE: u64 = u64::MAX;

/// Runs `plan` with `inputs`. A thread ends with its first failure; one that hangs is left behind.
pub fn run(inputs: Inputs, plan: Plan) -> Report {
    let counts =
        plan.targets.iter().map(|(t, _)| Count { name: t.name.clone(), ..Count::default() }).collect();
    let turns = plan.targets.iter().enumerate().flat_map(|(n, (_, share))| vec![n; *share]).collect();
    let shared = Arc::new(Shared {
        inputs,
        turns,
        next: AtomicU64::new(plan.numbers.start),
        at: (0..plan.threads).map(|_| (AtomicU64::new(IDLE), AtomicU64::new(0))).collect(),
        running: AtomicUsize::new(plan.threads),
        start: Instant::now(),
        report: Mutex::new(Report { counts, failures: Vec::new() }),
        plan,
    });
    for thread in 0..shared.plan.threads {
        let shared = Arc::clone(&shared);
        std::thread::spawn(move || shared.work(thread));
    }
    shared.watch();
    shared.report.lock().map(|r| r.clone()).unwrap_or_default()
}

impl Shared {
    fn now(&self) -> u64 {
        u64::try_from(self.start.elapsed().as_millis()).unwrap_or(u64::MAX)
    }

    fn target(&self, number: u64) -> usize {
        let turn = usize::try_from(number % self.turns.len() as u64).unwrap_or(0);
        self.turns[turn]
    }

    fn work(&self, thread: usize) {
        let mut note = self
            .plan
            .notes
            .as_ref()
            .and_then(|folder| File::create(folder.join(format!("thread-{thread}.txt"))).ok());
        let mut counts = vec![Count::default(); self.plan.targets.len()];
        loop {
            let number = self.next.fetch_add(1, Ordering::Relaxed);
            if number >= self.plan.numbers.end {
                break;
            }
            // Without the note an overflow of the stack is still an overflow, only harder to find.
            let _ =
                note.as_mut().map(|f| f.seek(SeekFrom::Start(0)).and_then(|_| writeln!(f, "{number:020}")));
            self.at[thread].1.store(self.now(), Ordering::Relaxed);
            self.at[thread].0.store(number, Ordering::Release);
            let place = self.target(number);
            let target = &self.plan.targets[place].0;
            let bytes = self.inputs.of(target.kind, number);
            match catch_unwind(AssertUnwindSafe(|| (target.function)(&bytes))) {
                Ok(reached) => counts[place].add(&reached),
                Err(panic) => {
                    self.fail(number, words(&*panic));
                    break;
                }
            }
        }
        self.at[thread].0.store(IDLE, Ordering::Release);
        if let Ok(mut report) = self.report.lock() {
            report.counts.iter_mut().zip(counts).for_each(|(all, some)| all.join(some));
        }
        self.running.fetch_sub(1, Ordering::Release);
    }

    fn fail(&self, number: u64, why: String) {
        let target = self.plan.targets[self.target(number)].0.name.clone();
        if let Ok(mut report) = self.report.lock() {
            report.failures.push(Failure { number, target, why });
        }
    }

    /// Waits for all threads, or for one that is at its input for too long.
    fn watch(&self) {
        while self.running.load(Ordering::Acquire) > 0 {
            std::thread::sleep(Duration::from_millis(20));
            for (number, since) in &self.at {
                let number = number.load(Ordering::Acquire);
                let patience = u64::try_from(self.plan.patience.as_millis()).unwrap_or(u64::MAX);
                if number != IDLE && self.now().saturating_sub(since.load(Ordering::Relaxed)) > patience {
                    return self.fail(number, format!("does not end within {patience} ms"));
                }
            }
        }
    }
}

impl Count {
    fn add(&mut self, reached: &Reached) {
        self.inputs += 1;
        self.sound += u64::from(reached.sound);
        self.codes.extend(&reached.codes);
    }

    fn join(&mut self, other: Self) {
        self.inputs += other.inputs;
        self.sound += other.sound;
        self.codes.extend(other.codes);
    }
}

/// What a panic said.
fn words(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
    text.unwrap_or("a panic without words").to_owned()
}
