//! A trace: what a drive did over virtual time, and the forms in which it is shown.
//!
//! It knows neither how a drive is simulated nor what was asked of it: whoever runs a drive pushes samples and events.

mod bits;
mod plot;
mod rows;
mod text;
mod unit;

#[cfg(test)]
mod tests;

use drivewright_runtime::cia402::{Mode, State, Statusword};
use drivewright_runtime::time::Instant;

pub(crate) use bits::BitNames;
pub(crate) use plot::svg;
pub(crate) use rows::{csv, json_lines};
pub(crate) use text::{mode_name, text};
pub(crate) use unit::Unit;

/// What a drive did.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Trace {
    /// The drive, and what was done with it.
    pub(crate) title: String,
    pub(crate) units: Units,
    pub(crate) bits: BitNames,
    /// Ascending by time.
    pub(crate) samples: Vec<Sample>,
    /// Ascending by time.
    pub(crate) events: Vec<Event>,
}

/// What one count of each quantity is worth.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Units {
    pub(crate) position: Unit,
    pub(crate) speed: Unit,
    pub(crate) force: Unit,
    /// Torque, or current where the drive does not tell its torque.
    pub(crate) force_name: &'static str,
}

/// A drive at one moment, in the counts of its objects.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Sample {
    pub(crate) at: Instant,
    /// 6064h.
    pub(crate) position: i64,
    /// 606Ch.
    pub(crate) speed: i64,
    /// 6077h, or 6078h.
    pub(crate) force: i64,
    /// 6061h.
    pub(crate) mode: Mode,
    /// 6041h.
    pub(crate) status: Statusword,
    /// 6040h, as the drive has it.
    pub(crate) control: u16,
}

impl Sample {
    /// The state that the statusword shows; `None` where it is that of no state.
    pub(crate) fn state(&self) -> Option<State> {
        self.status.state()
    }

    /// The state in words.
    pub(crate) fn state_word(&self) -> &'static str {
        self.state().map_or("no state", State::word)
    }
}

/// What kind of event it is: it chooses the colour of a marker, and programs may look for it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Kind {
    /// Something else is done from here on.
    Step,
    /// The drive has a fault.
    Fault,
    /// A fault is reset.
    Reset,
    /// Home has been found.
    Homed,
    /// Something worth a line.
    Note,
}

impl Kind {
    /// Its name for programs.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Step => "step",
            Self::Fault => "fault",
            Self::Reset => "reset",
            Self::Homed => "homed",
            Self::Note => "note",
        }
    }
}

/// Something that happened.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Event {
    pub(crate) at: Instant,
    pub(crate) kind: Kind,
    pub(crate) text: String,
}

impl Trace {
    /// Nothing yet.
    pub(crate) fn new(title: String, units: Units, bits: BitNames) -> Self {
        Self { title, units, bits, samples: Vec::new(), events: Vec::new() }
    }

    /// Adds a sample. One that is not later than the last takes its place.
    pub(crate) fn push(&mut self, sample: Sample) {
        while self.samples.last().is_some_and(|last| last.at >= sample.at) {
            self.samples.pop();
        }
        self.samples.push(sample);
    }

    /// Adds an event.
    pub(crate) fn note(&mut self, at: Instant, kind: Kind, text: impl Into<String>) {
        self.events.push(Event { at, kind, text: text.into() });
    }

    /// Samples in which something other than a measured value differs from the sample before, with that one; and events.
    /// In the order of time, events after a sample of the same time.
    fn changes(&self) -> Vec<Change<'_>> {
        let mut before = None;
        let mut changes: Vec<Change<'_>> = Vec::new();
        let mut events = self.events.iter().peekable();
        for sample in &self.samples {
            while let Some(event) = events.next_if(|event| event.at < sample.at) {
                changes.push(Change::Event(event));
            }
            let seen = |s: &Sample| (s.status, s.mode, s.control);
            if before.map(seen) != Some(seen(sample)) {
                changes.push(Change::Sample { before, now: sample });
            }
            before = Some(sample);
        }
        changes.extend(events.map(Change::Event));
        changes
    }
}

/// A line of a trace for people.
enum Change<'t> {
    Sample { before: Option<&'t Sample>, now: &'t Sample },
    Event(&'t Event),
}

/// Milliseconds with a decimal.
pub(crate) fn millis(at: Instant) -> String {
    let tenths = at.micros().saturating_add(50) / 100;
    format!("{}.{}", tenths / 10, tenths % 10)
}
