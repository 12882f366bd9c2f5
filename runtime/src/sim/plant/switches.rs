//! Where the switches and the index pulse of an axis are, and what lies between two places.
//!
//! An edge at `e` lies between the counts `e - 1` and `e`, from whichever side it is crossed; so does an index pulse.

use super::config::ConfigError;
use super::PlantConfig;
use crate::homing::interpreter::{Crossing, Levels};
use crate::homing::{Event, Side, Signal};

/// Where a switch is active: from `from` up to, but without, `to`. Empty where `to` is not above `from`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Band {
    /// The first count that is active.
    pub from: i64,
    /// The first count that is not active any more.
    pub to: i64,
}

impl Band {
    /// A band between two edges.
    pub const fn new(from: i64, to: i64) -> Self {
        Self { from, to }
    }

    /// Active from an edge on.
    pub const fn above(edge: i64) -> Self {
        Self { from: edge, to: i64::MAX }
    }

    /// Active below an edge.
    pub const fn below(edge: i64) -> Self {
        Self { from: i64::MIN, to: edge }
    }

    const fn holds(self, count: i64) -> bool {
        self.from <= count && count < self.to
    }
}

/// The switches and the index pulse of an axis.
///
/// Default: limits a quarter of a revolution before the hard stops of the default axis, a home switch from 1 to 2
/// revolutions, an index pulse at three eighths of each revolution.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Switches {
    /// The negative limit is active below this edge; `None` where there is no switch.
    pub negative_limit: Option<i64>,
    /// The positive limit is active from this edge on; `None` where there is no switch.
    pub positive_limit: Option<i64>,
    /// Where the home switch is active; two bands that touch or overlap are one.
    pub home: [Band; 2],
    /// Counts of a revolution of the encoder. 1 to 2^40.
    pub revolution: i64,
    /// Where in each revolution the index pulse is, counted from place 0; `None` without one.
    pub index: Option<i64>,
}

impl Default for Switches {
    fn default() -> Self {
        let revolution = PlantConfig::REVOLUTION;
        Self {
            negative_limit: Some(-revolution * 10 - revolution / 4),
            positive_limit: Some(revolution * 10 + revolution / 4),
            home: [Band::new(revolution, revolution * 2), Band::default()],
            revolution,
            index: Some(revolution / 8 * 3),
        }
    }
}

/// The signals in the order in which those that change at one place are told.
const ORDER: [Signal; 3] = [Signal::NegativeLimit, Signal::PositiveLimit, Signal::Home];

impl Switches {
    /// No switches and no index pulse.
    pub const NONE: Self = Self {
        negative_limit: None,
        positive_limit: None,
        home: [Band::new(0, 0); 2],
        revolution: 1,
        index: None,
    };

    pub(super) fn check(&self) -> Result<(), ConfigError> {
        if !(1..=1 << 40).contains(&self.revolution) {
            return Err(ConfigError::Revolution(self.revolution));
        }
        match self.index {
            Some(index) if !(0..self.revolution).contains(&index) => Err(ConfigError::Revolution(index)),
            _ => Ok(()),
        }
    }

    /// What the switches say at a place; the axis neither stands nor is at home for them.
    pub fn levels(&self, count: i64) -> Levels {
        Levels {
            negative_limit: self.negative_limit.is_some_and(|edge| count < edge),
            positive_limit: self.positive_limit.is_some_and(|edge| count >= edge),
            home: self.home.iter().any(|band| band.holds(count)),
            ..Levels::default()
        }
    }

    /// The nearest edge or index pulse above a place.
    pub fn above(&self, count: i64) -> Option<i64> {
        let edges = self.edges().filter(|edge| *edge > count).min();
        nearest(edges, self.index_from(count).and_then(|index| index.checked_add(self.revolution)), i64::min)
    }

    /// The nearest edge or index pulse at a place or below it.
    pub fn below(&self, count: i64) -> Option<i64> {
        let edges = self.edges().filter(|edge| *edge <= count).max();
        nearest(edges, self.index_from(count), i64::max)
    }

    /// What happens when the edge or pulse at `at` is crossed: switches first, an index pulse at the same place last.
    pub fn crossings(&self, at: i64, direction: Side) -> impl Iterator<Item = Crossing> + '_ {
        let (low, high) = (self.levels(at.saturating_sub(1)), self.levels(at));
        let after = if direction == Side::Positive { high } else { low };
        let switches = ORDER.into_iter().filter(move |signal| low.switch(*signal) != high.switch(*signal));
        let switches = switches.map(move |signal| Event::Switch(signal, after.switch(signal)));
        let index = self.index_from(at) == Some(at);
        switches.chain(index.then_some(Event::Index)).map(move |event| Crossing {
            event,
            position: at,
            direction,
        })
    }

    /// The edges of all switches; those of a band that is not there or does not end count too, and change nothing.
    fn edges(&self) -> impl Iterator<Item = i64> + '_ {
        let limits = self.negative_limit.into_iter().chain(self.positive_limit);
        limits
            .chain(self.home.iter().filter(|band| band.from < band.to).flat_map(|band| [band.from, band.to]))
    }

    /// The index pulse at a place or the nearest below it.
    fn index_from(&self, count: i64) -> Option<i64> {
        let above = count.checked_sub(self.index?)?.checked_rem_euclid(self.revolution)?;
        count.checked_sub(above)
    }
}

fn nearest(a: Option<i64>, b: Option<i64>, choose: fn(i64, i64) -> i64) -> Option<i64> {
    match (a, b) {
        (Some(a), Some(b)) => Some(choose(a, b)),
        (a, b) => a.or(b),
    }
}
