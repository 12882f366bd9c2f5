//! What was crossed in a step, without allocation.

use crate::homing::interpreter::Crossing;
use crate::homing::{Event, Side};

/// How many crossings of a step are kept.
const ROOM: usize = 8;

const NOTHING: Crossing = Crossing { event: Event::Index, position: 0, direction: Side::Positive };

/// The first crossings of a step.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) struct Crossed {
    room: [Crossing; ROOM],
    used: usize,
    more: bool,
}

impl Default for Crossed {
    fn default() -> Self {
        Self { room: [NOTHING; ROOM], used: 0, more: false }
    }
}

impl Crossed {
    pub(super) fn clear(&mut self) {
        self.used = 0;
        self.more = false;
    }

    pub(super) fn add(&mut self, crossings: impl Iterator<Item = Crossing>) {
        for crossing in crossings {
            match self.room.get_mut(self.used) {
                Some(room) => {
                    *room = crossing;
                    self.used = self.used.saturating_add(1);
                }
                None => self.more = true,
            }
        }
    }

    pub(super) fn all(&self) -> &[Crossing] {
        self.room.get(..self.used).unwrap_or(&[])
    }

    pub(super) const fn more(&self) -> bool {
        self.more
    }
}
