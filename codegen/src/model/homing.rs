//! The homing language: what an axis does until it has found home, as plain data.
//!
//! A method has cases, told apart by the switches at the start, and where these agree by which event comes first. A case
//! is a list of steps. The rules of the language:
//!
//! - An event is a change in time. `+ fast until home off` from a place where the switch is off runs over the switch.
//! - A move that turns around counts events from when it moves in its own direction; one that goes on in the same
//!   direction at another speed counts them at once.
//! - `latch` takes the place of the last event, or after `stop` the place of rest. Home is what was latched; where the
//!   axis comes to rest is another matter, unless the program says `return`.

use std::fmt;

use super::{Edge, Side};
use super::{Fact, HomingSignal, HomingStart, HomingStatus, Signal};

/// How fast a move goes.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Pace {
    /// At the speed for the search of a switch, 6099:01.
    Fast,
    /// At the speed for the search of zero, 6099:02.
    Slow,
}

/// What ends a move.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Event {
    /// A switch becomes active (`true`) or inactive.
    Switch(Signal, bool),
    /// The first index pulse after the move began.
    Index,
    /// The torque reaches the level of the drive for its time (`true`), or falls below it.
    Torque(bool),
    /// A hard stop: the torque at its limit and no motion, for the time of the drive.
    Stall,
}

/// A step of a homing program.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Step {
    /// Moves until something happens.
    Move {
        /// Where to.
        direction: Side,
        /// How fast.
        pace: Pace,
        /// Until when.
        until: Event,
    },
    /// Brakes and waits for standstill.
    Stop,
    /// Takes home.
    Latch,
    /// Goes back to what was latched.
    Return,
    /// The axis is at home already.
    Done,
    /// The manual does not say what follows.
    NotStated,
}

/// A homing program.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Moves(pub Vec<Step>);

/// What is seen at the start.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Level {
    /// A switch is active (`true`) or inactive.
    Switch(Signal, bool),
    /// The axis does not move.
    Standstill,
    /// The axis stands at home.
    AtHome,
}

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

/// Two things as text, one of them for each value of a flag.
fn on_off(on: bool) -> &'static str {
    if on { "on" } else { "off" }
}

impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Switch(signal, on) => write!(f, "{} {}", signal.word(), on_off(*on)),
            Self::Index => f.write_str("index"),
            Self::Torque(on) => write!(f, "torque {}", on_off(*on)),
            Self::Stall => f.write_str("stall"),
        }
    }
}

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Move { direction, pace, until } => {
                let sign = if *direction == Side::Negative { '-' } else { '+' };
                let pace = if *pace == Pace::Fast { "fast" } else { "slow" };
                write!(f, "{sign} {pace} until {until}")
            }
            Self::Stop => f.write_str("stop"),
            Self::Latch => f.write_str("latch"),
            Self::Return => f.write_str("return"),
            Self::Done => f.write_str("done"),
            Self::NotStated => f.write_str("not stated"),
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Switch(signal, on) => write!(f, "{} {}", signal.word(), on_off(*on)),
            Self::Standstill => f.write_str("standstill"),
            Self::AtHome => f.write_str("at_home"),
        }
    }
}

/// Items with something between them.
fn joined<T: fmt::Display>(items: &[T], between: &str, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    for (n, item) in items.iter().enumerate() {
        write!(f, "{}{item}", if n == 0 { "" } else { between })?;
    }
    Ok(())
}

impl fmt::Display for Moves {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        joined(&self.0, "; ", f)
    }
}

impl fmt::Display for When {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_empty() { f.write_str("any") } else { joined(&self.0, ", ", f) }
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
