//! Profile position: the hand-shake of bits 4 and 12, with a set-point that is approached and one that waits.

use crate::cia402::ModeBits;

/// Where to, in counts of the axis.
pub(super) type Target = i64;

/// The set-points of profile position.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct SetPoints {
    /// Bit 4 of the last cycle.
    bit: bool,
    acknowledged: bool,
    current: Option<Target>,
    next: Option<Target>,
}

impl SetPoints {
    /// None; `word` is the controlword at this moment, whose bit 4 is no edge.
    pub(super) const fn none(word: u16) -> Self {
        Self { bit: word & ModeBits::NEW_SET_POINT != 0, acknowledged: false, current: None, next: None }
    }

    /// A look at the controlword: a rising edge of bit 4 hands over `target`, which is asked for then. `reached`: the
    /// present one is.
    pub(super) fn step(&mut self, word: u16, reached: bool, target: impl FnOnce(Option<Target>) -> Target) {
        let bit = word & ModeBits::NEW_SET_POINT != 0;
        let before = core::mem::replace(&mut self.bit, bit);
        let rises = bit && !before;
        if rises && (word & ModeBits::CHANGE_IMMEDIATELY != 0 || self.current.is_none()) {
            self.acknowledged = true;
            self.current = Some(target(self.current));
            self.next = None;
            return;
        }
        if reached && self.current.is_some() {
            self.current = self.next.take();
        }
        if rises && self.next.is_none() {
            self.acknowledged = true;
            let target = Some(target(self.current));
            if self.current.is_some() {
                self.next = target;
            } else {
                self.current = target;
            }
        }
        if !bit && self.next.is_none() {
            self.acknowledged = false;
        }
    }

    /// The set-point that is approached.
    pub(super) const fn current(&self) -> Option<Target> {
        self.current
    }

    /// Bit 12: the last set-point has been taken, and bit 4 is still set or no other would be taken.
    pub(super) const fn acknowledged(&self) -> bool {
        self.acknowledged
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NEW: u16 = ModeBits::NEW_SET_POINT;
    const NOW: u16 = ModeBits::CHANGE_IMMEDIATELY;

    #[test]
    fn one_is_approached_and_one_waits() {
        let mut points = SetPoints::none(0);
        points.step(NEW, true, |_| 1);
        assert_eq!((points.current(), points.acknowledged()), (Some(1), true));
        points.step(0, false, |_| 0);
        assert!(!points.acknowledged());
        points.step(NEW, false, |_| 2);
        assert_eq!((points.current(), points.acknowledged()), (Some(1), true));
        points.step(0, false, |_| 0);
        assert!(points.acknowledged(), "there is no room for another");
        points.step(NEW, false, |_| 3);
        points.step(0, true, |_| 0);
        assert_eq!((points.current(), points.acknowledged()), (Some(2), false), "the third was not taken");
        points.step(0, true, |_| 0);
        assert_eq!(points.current(), None);
    }

    #[test]
    fn change_immediately_replaces_both() {
        let mut points = SetPoints::none(0);
        for word in [NEW, 0] {
            points.step(word, false, |_| 1);
        }
        points.step(NEW, false, |_| 2);
        points.step(0, false, |_| 0);
        points.step(NEW | NOW, false, |before| before.unwrap() + 10);
        assert_eq!(points.current(), Some(11));
        points.step(NOW, true, |_| 0);
        assert_eq!((points.current(), points.acknowledged()), (None, false));
    }

    #[test]
    fn a_bit_that_is_set_before_is_no_edge() {
        let mut points = SetPoints::none(NEW);
        points.step(NEW, true, |_| 1);
        assert_eq!((points.current(), points.acknowledged()), (None, false));
    }
}
