//! The homing language: what an axis does until it has found home, as plain data.
//! What its words mean is said in [`drivewright_runtime::homing`], which defines them.

use std::fmt;

pub use drivewright_runtime::homing::{Event, Level, Pace, Step};

use super::{Edge, Fact, HomingSignal, HomingStart, HomingStatus, Side, Signal};

/// A homing program.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Moves(pub Vec<Step>);

/// What is seen at the start, all of it; nothing: any start.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct When(pub Vec<Level>);

/// A case of a homing method.
#[derive(Clone, PartialEq, Debug)]
pub struct HomingCase {
    /// Its number, where the manual gives one.
    pub number: Option<u8>,
    /// At which start it holds.
    pub when: Fact<When>,
    /// What the axis does.
    pub moves: Fact<Moves>,
    /// What ends it with an error.
    pub abort: Option<Fact<When>>,
    /// Signals without effect while it runs.
    pub mask: Option<Fact<Vec<Signal>>>,
}

/// A homing method (6098h).
#[derive(Clone, PartialEq, Debug)]
pub struct HomingMethod {
    /// The value of 6098h.
    pub number: i8,
    /// Whether the drive has it. The origin is that of the method's first row.
    pub status: Fact<HomingStatus>,
    /// The method that it is the same as.
    pub same: Option<Fact<i8>>,
    /// Direction of the first move, as the manual's table has it.
    pub start: Option<Fact<HomingStart>>,
    /// Signal that ends the fast move, as the manual's table has it.
    pub approach: Option<Fact<HomingSignal>>,
    /// Signal that is the home, as the manual's table has it.
    pub reference: Option<Fact<HomingSignal>>,
    /// Side of the approach signal on which home lies, as the manual's table has it.
    pub side: Option<Fact<Side>>,
    /// Edge of the approach signal that counts, as the manual's table has it.
    pub edge: Option<Fact<Edge>>,
    /// Its cases, in the order of the profile; none for a method that is the same as another or not there.
    pub cases: Vec<HomingCase>,
    /// What to know about it.
    pub text: Option<String>,
    /// A remark for the reader.
    pub note: Option<String>,
    /// Why it may differ from the standard method.
    pub deviation: Option<String>,
}

impl fmt::Display for Moves {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        drivewright_runtime::homing::Moves(&self.0).fmt(f)
    }
}

impl fmt::Display for When {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        drivewright_runtime::homing::When(&self.0).fmt(f)
    }
}

impl Moves {
    /// The moves, without what comes between and after them.
    pub fn moves(&self) -> impl Iterator<Item = (Side, Pace, Event)> {
        self.0.iter().filter_map(|step| match step {
            Step::Move { direction, pace, until } => Some((*direction, *pace, *until)),
            _ => None,
        })
    }

    /// The event and direction at which home is latched: those of the last move before the latch. `None` where nothing is
    /// latched, or where it is without a move or after a stop.
    pub fn latched(&self) -> Option<(Side, Event)> {
        let latch = self.0.iter().position(|step| *step == Step::Latch)?;
        match self.0.get(latch.checked_sub(1)?)? {
            Step::Move { direction, until, .. } => Some((*direction, *until)),
            _ => None,
        }
    }
}
