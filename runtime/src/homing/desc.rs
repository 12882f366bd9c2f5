//! Rows of the table of homing methods.

use super::text::{Moves, When};
use super::{Edge, HomingSignal, HomingStart, HomingStatus, Level, Side, Signal, Step};

/// A case of a homing method: where the axis starts, and what it does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct HomingCase<'m> {
    when: &'m [Level],
    moves: &'m [Step],
    abort: Option<&'m [Level]>,
    mask: &'m [Signal],
}

impl<'m> HomingCase<'m> {
    /// A case that holds where all of `when` is seen at the start; with nothing, at any start.
    pub const fn new(when: &'m [Level], moves: &'m [Step]) -> Self {
        Self { when, moves, abort: None, mask: &[] }
    }

    /// With what ends it with an error.
    #[must_use]
    pub const fn with_abort(mut self, abort: &'m [Level]) -> Self {
        self.abort = Some(abort);
        self
    }

    /// With the signals that have no effect while it runs.
    #[must_use]
    pub const fn with_mask(mut self, mask: &'m [Signal]) -> Self {
        self.mask = mask;
        self
    }

    /// At which start it holds.
    pub const fn when(&self) -> When<'m> {
        When(self.when)
    }

    /// What the axis does.
    pub const fn moves(&self) -> Moves<'m> {
        Moves(self.moves)
    }

    /// What ends it with an error; `None` where none is stated.
    pub const fn abort(&self) -> Option<When<'m>> {
        match self.abort {
            Some(abort) => Some(When(abort)),
            None => None,
        }
    }

    /// Signals without effect while it runs.
    pub const fn mask(&self) -> &'m [Signal] {
        self.mask
    }
}

/// A homing method.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct HomingDesc<'m> {
    number: i8,
    status: HomingStatus,
    same: Option<i8>,
    start: Option<HomingStart>,
    approach: Option<HomingSignal>,
    reference: Option<HomingSignal>,
    side: Option<Side>,
    edge: Option<Edge>,
    cases: &'m [HomingCase<'m>],
}

/// A builder method and a getter for each column of a manual's table, which need not be there.
macro_rules! columns {
    ($($(#[$doc:meta])* $name:ident, $with:ident: $ty:ty;)*) => {
        impl<'m> HomingDesc<'m> {
            $(
                #[doc = concat!("With `", stringify!($name), "`.")]
                #[must_use]
                pub const fn $with(mut self, $name: $ty) -> Self {
                    self.$name = Some($name);
                    self
                }

                $(#[$doc])*
                pub const fn $name(&self) -> Option<$ty> {
                    self.$name
                }
            )*
        }
    };
}

columns! {
    /// The method that it is the same as; [`DriveModel::homing`](crate::DriveModel::homing) follows it.
    same, with_same: i8;
    /// Direction of the first move, where the manual has a table that says so.
    start, with_start: HomingStart;
    /// Signal that ends the fast move, where the manual has a table that says so.
    approach, with_approach: HomingSignal;
    /// Signal that is the home, where the manual has a table that says so.
    reference, with_reference: HomingSignal;
    /// Side of the approach signal on which home lies, where the manual has a table that says so.
    side, with_side: Side;
    /// Edge of the approach signal that counts, where the manual has a table that says so.
    edge, with_edge: Edge;
}

impl<'m> HomingDesc<'m> {
    /// A method that the drive has: the value of 6098h. Without cases until it gets some.
    pub const fn new(number: i8) -> Self {
        Self {
            number,
            status: HomingStatus::Supported,
            same: None,
            start: None,
            approach: None,
            reference: None,
            side: None,
            edge: None,
            cases: &[],
        }
    }

    /// With another status than that the drive has it.
    #[must_use]
    pub const fn with_status(mut self, status: HomingStatus) -> Self {
        self.status = status;
        self
    }

    /// With its cases.
    #[must_use]
    pub const fn with_cases(mut self, cases: &'m [HomingCase<'m>]) -> Self {
        self.cases = cases;
        self
    }

    /// The value of 6098h.
    pub const fn number(&self) -> i8 {
        self.number
    }

    /// Whether the drive has it.
    pub const fn status(&self) -> HomingStatus {
        self.status
    }

    /// Its cases; none for a method that is the same as another or that the drive does not have.
    pub const fn cases(&self) -> &'m [HomingCase<'m>] {
        self.cases
    }
}
