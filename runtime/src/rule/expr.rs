//! Expressions over objects. Whole numbers, no side effects, no recursion, no heap.

use crate::address::Address;

crate::word::words! {
    /// An operator; all take two whole numbers, and comparisons give 1 or 0.
    Op {
        /// `||`: at least one is not 0.
        Or = "||",
        /// `&&`: neither is 0.
        And = "&&",
        /// `==`
        Equal = "==",
        /// `!=`
        Differ = "!=",
        /// `<`
        Less = "<",
        /// `<=`
        AtMost = "<=",
        /// `>`
        More = ">",
        /// `>=`
        AtLeast = ">=",
        /// `+`
        Add = "+",
        /// `-`
        Subtract = "-",
        /// `*`
        Multiply = "*",
        /// `%`: the remainder, with the sign of the left.
        Remainder = "%",
        /// `&`: bit by bit.
        Mask = "&",
    }
}

impl Op {
    /// What it makes of two numbers; `None` where that is too large, or the remainder of a division by 0.
    pub fn apply(self, left: i128, right: i128) -> Option<i128> {
        match self {
            Self::Or => Some(i128::from(left != 0 || right != 0)),
            Self::And => Some(i128::from(left != 0 && right != 0)),
            Self::Equal => Some(i128::from(left == right)),
            Self::Differ => Some(i128::from(left != right)),
            Self::Less => Some(i128::from(left < right)),
            Self::AtMost => Some(i128::from(left <= right)),
            Self::More => Some(i128::from(left > right)),
            Self::AtLeast => Some(i128::from(left >= right)),
            Self::Add => left.checked_add(right),
            Self::Subtract => left.checked_sub(right),
            Self::Multiply => left.checked_mul(right),
            Self::Remainder => left.checked_rem(right),
            Self::Mask => Some(left & right),
        }
    }
}

/// A part of an expression.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Term {
    /// A number.
    Number(i64),
    /// The value of an object.
    Object(Address),
    /// Takes the two values before it and gives one.
    Apply(Op),
}

/// An expression: operands before operators.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Expr<'m>(pub &'m [Term]);

/// How many values of an expression may wait for their operator at once.
pub const DEPTH: usize = 16;

impl<'m> Expr<'m> {
    /// The objects that it names, in their order.
    pub fn objects(self) -> impl Iterator<Item = Address> + 'm {
        self.0.iter().filter_map(|term| match term {
            Term::Object(address) => Some(*address),
            _ => None,
        })
    }

    /// How many values wait for their operator at once, at most; `None` for what cannot be evaluated: an operator without
    /// its operands, an operand without its operator, nothing at all, or more than [`DEPTH`].
    pub fn depth(self) -> Option<usize> {
        let (mut now, mut most) = (0_usize, 0);
        for term in self.0 {
            now = if matches!(term, Term::Apply(_)) { now.checked_sub(2)? } else { now }.checked_add(1)?;
            most = now.max(most);
        }
        (now == 1 && most <= DEPTH).then_some(most)
    }

    /// Its value; `None` where `value` has none for an object, where an operator has no result, and for what cannot be
    /// evaluated: see [`depth`](Self::depth).
    pub fn value(self, value: impl Fn(Address) -> Option<i128>) -> Option<i128> {
        let mut stack = Stack::default();
        for term in self.0 {
            let next = match *term {
                Term::Number(n) => i128::from(n),
                Term::Object(address) => value(address)?,
                Term::Apply(op) => {
                    let (right, left) = (stack.pop()?, stack.pop()?);
                    op.apply(left, right)?
                }
            };
            stack.push(next)?;
        }
        let result = stack.pop();
        result.filter(|_| stack.used == 0)
    }
}

/// Values that wait for their operator.
#[derive(Default)]
struct Stack {
    values: [i128; DEPTH],
    used: usize,
}

impl Stack {
    fn push(&mut self, value: i128) -> Option<()> {
        *self.values.get_mut(self.used)? = value;
        self.used = self.used.checked_add(1)?;
        Some(())
    }

    fn pop(&mut self) -> Option<i128> {
        self.used = self.used.checked_sub(1)?;
        self.values.get(self.used).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec::Vec;

    const N: fn(i64) -> Term = Term::Number;

    fn value(terms: &[Term]) -> Option<i128> {
        Expr(terms).value(|at| (at == Address::new(0x6041, 0)).then_some(0x1237))
    }

    #[test]
    fn operators_take_the_two_values_before_them() {
        use Op::*;
        for (op, left, right, expected) in [
            (Or, 0, 0, 0),
            (Or, 0, 7, 1),
            (And, 2, 0, 0),
            (And, 2, 1, 1),
            (Equal, 3, 3, 1),
            (Differ, 3, 3, 0),
            (Less, 2, 3, 1),
            (Less, 3, 3, 0),
            (AtMost, 3, 3, 1),
            (More, 3, 2, 1),
            (AtLeast, 2, 3, 0),
            (Add, 2, 3, 5),
            (Subtract, 2, 3, -1),
            (Multiply, -2, 3, -6),
            (Remainder, -7, 3, -1),
            (Mask, 0x1237, 0x6F, 0x27),
        ] {
            assert_eq!(value(&[N(left), N(right), Term::Apply(op)]), Some(expected), "{left} {op} {right}");
        }
    }

    #[test]
    fn what_has_no_value_has_none() {
        let object = |index| Term::Object(Address::new(index, 0));
        assert_eq!(value(&[object(0x6041)]), Some(0x1237));
        assert_eq!(value(&[object(0x6040)]), None);
        assert_eq!(value(&[N(1), N(0), Term::Apply(Op::Remainder)]), None);
        let thrice =
            [N(i64::MAX), N(i64::MAX), Term::Apply(Op::Multiply), N(i64::MAX), Term::Apply(Op::Multiply)];
        assert_eq!(value(&thrice), None);
    }

    #[test]
    fn what_cannot_be_evaluated_has_neither_depth_nor_value() {
        let add = Term::Apply(Op::Add);
        for terms in [&[][..], &[add], &[N(1), add], &[N(1), N(2)], &[N(1), N(2), add, add]] {
            assert_eq!((Expr(terms).depth(), value(terms)), (None, None), "{terms:?}");
        }
        assert_eq!(Expr(&[N(1), N(2), add]).depth(), Some(2));
    }

    #[test]
    fn the_stack_has_an_end() {
        let nested = |depth: usize| -> Vec<Term> {
            let numbers = std::iter::repeat(N(1)).take(depth);
            numbers.chain(std::iter::repeat(Term::Apply(Op::Add)).take(depth - 1)).collect()
        };
        assert_eq!((Expr(&nested(16)).depth(), value(&nested(16))), (Some(16), Some(16)));
        assert_eq!((Expr(&nested(17)).depth(), value(&nested(17))), (None, None));
    }
}
