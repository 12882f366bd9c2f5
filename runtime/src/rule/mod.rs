//! Rules between values, as a manual gives them: what must hold, under which condition, and on which occasion.
//!
//! A condition is an [`Expr`]: operands before operators, so that it is evaluated without recursion on a small stack.
//!
//! ```
//! use drivewright_runtime::rule::*;
//! use drivewright_runtime::Address;
//!
//! const SHIFT: Address = Address::new(0x1C33, 3);
//! const RULE: RuleDesc<'static> = RuleDesc::new("R01", "The input shift time is a multiple of 62500 ns.").with_require(&[
//!     Term::Object(SHIFT),
//!     Term::Number(62_500),
//!     Term::Apply(Op::Remainder),
//!     Term::Number(0),
//!     Term::Apply(Op::Equal),
//! ]);
//!
//! let with = |shift| move |at| (at == SHIFT).then_some(shift);
//! assert!(!RULE.broken(with(125_000)));
//! assert!(RULE.broken(with(125_001)));
//! assert!(!RULE.broken(|_| None), "nobody knows the value");
//! ```

mod expr;

pub use expr::{Expr, Op, Term, DEPTH};

use crate::address::Address;

crate::word::words! {
    /// When a rule must hold.
    Occasion {
        /// With distributed clocks.
        Dc = "dc",
        /// In free run.
        FreeRun = "free run",
        /// When homing is started.
        StartHoming = "start homing",
        /// While homing runs.
        WhileHoming = "while homing",
        /// When the drive is enabled.
        Enable = "enable",
        /// When a state of the EtherCAT state machine is asked for.
        EsmChange = "esm change",
        /// When process data are mapped or assigned.
        Remap = "remap",
    }
}

/// A rule between values.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RuleDesc<'m> {
    id: &'m str,
    text: &'m str,
    on: Option<Occasion>,
    when: Option<Expr<'m>>,
    require: Option<Expr<'m>>,
}

impl<'m> RuleDesc<'m> {
    /// A rule that a reader can follow and no program checks: its id, unique in the drive, and its words.
    pub const fn new(id: &'m str, text: &'m str) -> Self {
        Self { id, text, on: None, when: None, require: None }
    }

    /// With the occasion on which it must hold.
    #[must_use]
    pub const fn with_on(mut self, on: Occasion) -> Self {
        self.on = Some(on);
        self
    }

    /// With the condition under which it must hold.
    #[must_use]
    pub const fn with_when(mut self, when: &'m [Term]) -> Self {
        self.when = Some(Expr(when));
        self
    }

    /// With what must hold.
    #[must_use]
    pub const fn with_require(mut self, require: &'m [Term]) -> Self {
        self.require = Some(Expr(require));
        self
    }

    /// Its id, unique in the drive.
    pub const fn id(&self) -> &'m str {
        self.id
    }

    /// The rule in words.
    pub const fn text(&self) -> &'m str {
        self.text
    }

    /// The occasion on which it must hold; `None`: always.
    pub const fn on(&self) -> Option<Occasion> {
        self.on
    }

    /// The condition under which it must hold; `None`: under any.
    pub const fn when(&self) -> Option<Expr<'m>> {
        self.when
    }

    /// What must hold; `None` for a rule that only words can say.
    pub const fn require(&self) -> Option<Expr<'m>> {
        self.require
    }

    /// Whether it names the entry at `address`.
    pub fn names(&self, address: Address) -> bool {
        [self.when, self.require].iter().flatten().any(|expr| expr.objects().any(|at| at == address))
    }

    /// Whether its condition holds for these values and it is not obeyed; never where a value that decides this is
    /// unknown.
    pub fn broken(&self, value: impl Fn(Address) -> Option<i128>) -> bool {
        broken(self.when, self.require, value)
    }

    /// Whether its conditions can be evaluated: see [`Expr::depth`].
    pub fn is_sound(&self) -> bool {
        [self.when, self.require].iter().flatten().all(|expr| expr.depth().is_some())
    }
}

/// Whether `when` holds for these values and `require` does not; never where a value that decides this is unknown.
pub fn broken(
    when: Option<Expr<'_>>,
    require: Option<Expr<'_>>,
    value: impl Fn(Address) -> Option<i128>,
) -> bool {
    let holds = when.map_or(Some(1), |when| when.value(&value)).is_some_and(|when| when != 0);
    holds && require.and_then(|require| require.value(&value)) == Some(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODE: Address = Address::new(0x6061, 0);
    const METHOD: Address = Address::new(0x6098, 0);
    const HOMING: [Term; 3] = [Term::Object(MODE), Term::Number(6), Term::Apply(Op::Equal)];
    const CHOSEN: [Term; 3] = [Term::Object(METHOD), Term::Number(0), Term::Apply(Op::Differ)];

    fn values(mode: Option<i128>, method: Option<i128>) -> impl Fn(Address) -> Option<i128> {
        move |at| if at == MODE { mode } else { method }
    }

    #[test]
    fn a_rule_is_broken_where_its_condition_holds_and_it_does_not() {
        let rule = RuleDesc::new("R", "").with_when(&HOMING).with_require(&CHOSEN);
        for (mode, method, broken) in [
            (Some(6), Some(0), true),
            (Some(6), Some(1), false),
            (Some(1), Some(0), false),
            (None, Some(0), false),
            (Some(6), None, false),
        ] {
            assert_eq!(rule.broken(values(mode, method)), broken, "{mode:?} {method:?}");
        }
        assert!(!RuleDesc::new("R", "").with_when(&HOMING).broken(values(Some(6), Some(0))), "words only");
        assert!(RuleDesc::new("R", "").with_require(&CHOSEN).broken(values(None, Some(0))), "no condition");
    }

    #[test]
    fn a_rule_names_the_objects_of_both_parts() {
        let rule = RuleDesc::new("R", "").with_when(&HOMING).with_require(&CHOSEN);
        assert!(rule.names(MODE) && rule.names(METHOD) && !rule.names(Address::new(0x6060, 0)));
    }
}
