//! Expressions over objects: the conditions of rules, as text and as the runtime evaluates them.

use std::fmt;

use drivewright_runtime::rule;
pub use drivewright_runtime::rule::{Op, Term};

use super::Address;

/// Operators with how strongly they bind. Longer words come before those that they begin with.
pub const OPERATORS: &[(Op, u8)] = &[
    (Op::Or, 1),
    (Op::And, 2),
    (Op::Equal, 3),
    (Op::Differ, 3),
    (Op::AtMost, 3),
    (Op::AtLeast, 3),
    (Op::Less, 3),
    (Op::More, 3),
    (Op::Add, 4),
    (Op::Subtract, 4),
    (Op::Multiply, 5),
    (Op::Remainder, 5),
    (Op::Mask, 5),
];

/// An expression: its text, and its parts with each operator behind what it works on.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Expr {
    /// As the profile writes it.
    pub text: String,
    /// Operands before operators.
    pub terms: Vec<Term>,
}

impl fmt::Display for Expr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl Expr {
    /// The objects that it names, in the order of its text.
    pub fn objects(&self) -> impl Iterator<Item = Address> {
        self.evaluated().objects().map(Address::from)
    }

    /// Its value; `None` where `value` has none for an object, a remainder is by 0, or a number is too large.
    pub fn value(&self, value: impl Fn(Address) -> Option<i128>) -> Option<i128> {
        self.evaluated().value(|at| value(at.into()))
    }

    /// As the runtime evaluates it.
    pub fn evaluated(&self) -> rule::Expr<'_> {
        rule::Expr(&self.terms)
    }
}
