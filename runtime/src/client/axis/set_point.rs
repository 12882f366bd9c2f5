//! A move in profile position mode: the hand-shake of bits 4 and 12, and the way to the target.

use core::time::Duration;

use super::{Axis, AxisErrorKind, Goal, Verdict};
use crate::cia402::{Mode, ModeBits, Statusword};

/// A target of profile position mode.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SetPoint {
    /// Where to, or how far; user units.
    pub target: i32,
    /// Whether the target is a distance.
    pub relative: bool,
    /// Whether it replaces a move that is under way, instead of waiting for its end.
    pub immediately: bool,
}

impl SetPoint {
    /// To a position, after what is under way.
    pub const fn to(target: i32) -> Self {
        Self { target, relative: false, immediately: false }
    }

    /// By a distance, after what is under way.
    pub const fn by(distance: i32) -> Self {
        Self { target: distance, relative: true, immediately: false }
    }

    /// The same, at once.
    #[must_use]
    pub const fn immediately(self) -> Self {
        Self { immediately: true, ..self }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum MovePhase {
    /// Bit 4 is low and the target is on its way, so that it arrives before the edge.
    Offer,
    /// Bit 4 is high; bit 12 must rise. `believed`: it was low before.
    Raise { believed: bool },
    /// Bit 4 is low again; bit 12 must fall.
    Lower,
    /// The drive is on its way.
    Under,
}

impl MovePhase {
    pub(super) const fn overdue(self) -> AxisErrorKind {
        match self {
            Self::Offer | Self::Lower => AxisErrorKind::AcknowledgeStays,
            Self::Raise { .. } => AxisErrorKind::NotAcknowledged,
            Self::Under => AxisErrorKind::TimedOut,
        }
    }
}

impl Axis {
    /// Moves to a target in profile position mode; done when the drive has acknowledged it and reports that it is
    /// reached. A new call during a move hands over another target.
    pub fn move_to(&mut self, set_point: SetPoint, within: Duration) {
        self.set_bit(ModeBits::NEW_SET_POINT, false);
        self.begin(Goal::Move(set_point, MovePhase::Offer), within);
        if self.view.mode() != Some(Mode::PROFILE_POSITION) || self.mode != self.view.mode() {
            return self.refuse(AxisErrorKind::WrongMode { shown: self.view.mode() });
        }
        if let Err(kind) = self.in_operation() {
            return self.refuse(kind);
        }
        self.commanded.position = Some(set_point.target);
        self.set_bit(ModeBits::CHANGE_IMMEDIATELY, set_point.immediately);
        let inverted = self.policy.relative_bit_is_inverted.unwrap_or(false);
        self.set_bit(ModeBits::RELATIVE, set_point.relative != inverted);
    }

    /// Whether the drive has taken the last set-point and another one may follow.
    pub fn set_point_is_taken(&self) -> bool {
        matches!(self.goal, Goal::Move(_, MovePhase::Under))
    }

    pub(super) fn advance_move(
        &mut self,
        set_point: SetPoint,
        phase: MovePhase,
        word: Statusword,
    ) -> Verdict {
        let acknowledged = word.0 & ModeBits::SET_POINT_ACKNOWLEDGE != 0;
        let next = match phase {
            MovePhase::Offer if self.phase_samples < 2 => phase,
            MovePhase::Offer if acknowledged && !self.policy.acknowledge_may_be_high => phase,
            MovePhase::Offer => MovePhase::Raise { believed: !acknowledged },
            MovePhase::Raise { believed } if acknowledged && (believed || self.is_fresh()) => {
                MovePhase::Lower
            }
            MovePhase::Raise { .. } if self.phase >= self.policy.acknowledge_within => {
                return Err(phase.overdue())
            }
            MovePhase::Lower if !acknowledged => MovePhase::Under,
            MovePhase::Under => return Ok(self.is_fresh() && word.target_reached()),
            MovePhase::Raise { .. } | MovePhase::Lower => phase,
        };
        if next != phase {
            self.enter(Goal::Move(set_point, next));
            self.set_bit(ModeBits::NEW_SET_POINT, matches!(next, MovePhase::Raise { .. }));
        }
        Ok(false)
    }
}
