//! Homing without time: the axis goes from edge to edge.

use drivewright_runtime::homing::interpreter::{Command, Crossing, Levels, Run, StartError};
use drivewright_runtime::homing::{Event, HomingDesc, Pace, Side};

use crate::{Outcome, STOP, Scene};

/// The way in which the axis halts from each speed, in counts.
#[derive(Clone, Copy)]
pub(crate) struct Ways {
    pub(crate) fast: i64,
    pub(crate) slow: i64,
}

struct Axis<'m> {
    scene: Scene,
    run: Run<'m>,
    position: i64,
    struck: bool,
}

/// Homes an axis.
pub(crate) fn home(method: &HomingDesc<'_>, scene: Scene, ways: Ways) -> Result<Outcome, StartError> {
    let seen = Levels { standstill: true, ..scene.switches.levels(scene.start) };
    let run = Run::start(method, seen)?;
    let mut axis = Axis { scene, run, position: scene.start, struck: false };
    let mut moves: Option<(Side, Pace)> = None;
    for _ in 0..1_000 {
        let way = moves.map(|(side, pace)| (side, if pace == Pace::Fast { ways.fast } else { ways.slow }));
        match axis.run.command() {
            Command::Move { direction, pace } => {
                if let Some((side, way)) = way.filter(|(side, _)| *side != direction) {
                    axis.travel(side, way);
                }
                moves = Some((direction, pace));
                if axis.run.command() == (Command::Move { direction, pace }) && !axis.struck {
                    axis.go(direction, &mut moves);
                }
            }
            Command::Brake => {
                if let Some((side, way)) = way {
                    axis.travel(side, way);
                }
                moves = None;
                axis.run.standstill(axis.position);
            }
            Command::Return { to } => {
                if let Some((side, way)) = way {
                    axis.travel(side, way);
                }
                moves = None;
                let side = if to < axis.position { Side::Negative } else { Side::Positive };
                axis.travel(side, (to - axis.position).abs());
                axis.run.standstill(axis.position);
            }
            Command::Finished { home } if !axis.struck => return Ok(Outcome::Home(home)),
            Command::Failed(failure) => return Ok(Outcome::Failed(failure)),
            _ => {}
        }
        if axis.struck {
            return Ok(Outcome::Struck);
        }
    }
    Ok(Outcome::Endless)
}

impl Axis<'_> {
    /// Goes on to the next edge, or up to the hard stop.
    fn go(&mut self, direction: Side, moves: &mut Option<(Side, Pace)>) {
        if let Some(edge) = self.ahead(direction) {
            self.cross(edge, direction);
            return;
        }
        self.position = if direction == Side::Positive { STOP } else { -STOP };
        let stall = Crossing { event: Event::Stall, position: self.position, direction };
        self.struck = !self.run.event(stall);
        *moves = None;
    }

    /// Goes on for a way, and over all edges on it.
    fn travel(&mut self, direction: Side, way: i64) {
        let sign = if direction == Side::Positive { 1 } else { -1 };
        let end = self.position + way * sign;
        while let Some(edge) = self.ahead(direction) {
            let beyond = if direction == Side::Positive { edge > end } else { edge <= end };
            if beyond {
                break;
            }
            self.cross(edge, direction);
        }
        self.struck |= end.abs() > STOP;
        self.position = end.clamp(-STOP, STOP);
    }

    /// The next edge within the hard stops.
    fn ahead(&self, direction: Side) -> Option<i64> {
        let edge = match direction {
            Side::Positive => self.scene.switches.above(self.position),
            Side::Negative => self.scene.switches.below(self.position),
        };
        edge.filter(|edge| edge.abs() <= STOP)
    }

    fn cross(&mut self, edge: i64, direction: Side) {
        for crossing in self.scene.switches.crossings(edge, direction) {
            self.run.event(crossing);
        }
        self.position = if direction == Side::Positive { edge } else { edge - 1 };
    }
}
