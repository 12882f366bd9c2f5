//! Expressions over objects: the conditions of rules. Whole numbers, no side effects, no recursion.

use std::fmt;

use super::Address;

/// An operator; all take two whole numbers, and comparisons give 1 or 0.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Op {
    /// `||`: at least one is not 0.
    Or,
    /// `&&`: neither is 0.
    And,
    /// `==`
    Equal,
    /// `!=`
    Differ,
    /// `<`
    Less,
    /// `<=`
    AtMost,
    /// `>`
    More,
    /// `>=`
    AtLeast,
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `%`: the remainder, with the sign of the left.
    Remainder,
    /// `&`: bit by bit.
    Mask,
}

/// Operators as text, with how strongly they bind. The longer ones come first.
pub const OPERATORS: &[(&str, Op, u8)] = &[
    ("||", Op::Or, 1),
    ("&&", Op::And, 2),
    ("==", Op::Equal, 3),
    ("!=", Op::Differ, 3),
    ("<=", Op::AtMost, 3),
    (">=", Op::AtLeast, 3),
    ("<", Op::Less, 3),
    (">", Op::More, 3),
    ("+", Op::Add, 4),
    ("-", Op::Subtract, 4),
    ("*", Op::Multiply, 5),
    ("%", Op::Remainder, 5),
    ("&", Op::Mask, 5),
];

/// A part of an expression.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Term {
    /// A number.
    Number(i64),
    /// The value of an object.
    Object(Address),
    /// Takes the two values before it and gives one.
    Apply(Op),
}

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
        self.terms.iter().filter_map(|term| match term {
            Term::Object(address) => Some(*address),
            _ => None,
        })
    }

    /// Its value; `None` where `value` has none for an object, a remainder is by 0, or a number is too large.
    pub fn value(&self, value: impl Fn(Address) -> Option<i128>) -> Option<i128> {
        let mut stack: Vec<i128> = Vec::new();
        for term in &self.terms {
            let next = match term {
                Term::Number(n) => i128::from(*n),
                Term::Object(address) => value(*address)?,
                Term::Apply(op) => {
                    let (right, left) = (stack.pop()?, stack.pop()?);
                    apply(*op, left, right)?
                }
            };
            stack.push(next);
        }
        stack.pop()
    }
}

fn apply(op: Op, left: i128, right: i128) -> Option<i128> {
    match op {
        Op::Or => Some(i128::from(left != 0 || right != 0)),
        Op::And => Some(i128::from(left != 0 && right != 0)),
        Op::Equal => Some(i128::from(left == right)),
        Op::Differ => Some(i128::from(left != right)),
        Op::Less => Some(i128::from(left < right)),
        Op::AtMost => Some(i128::from(left <= right)),
        Op::More => Some(i128::from(left > right)),
        Op::AtLeast => Some(i128::from(left >= right)),
        Op::Add => left.checked_add(right),
        Op::Subtract => left.checked_sub(right),
        Op::Multiply => left.checked_mul(right),
        Op::Remainder => left.checked_rem(right),
        Op::Mask => Some(left & right),
    }
}
