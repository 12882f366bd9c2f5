//! Expressions over objects as text: `(6041:00 & 0x6F) == 0x27 && 1C33:03 % 62500 == 0`.
//!
//! Operators wait on a stack until one that binds less comes, so that no text can nest too deep.

use drivewright_runtime::rule::DEPTH;

use super::address::{At, Sub};
use super::kind::{Expected, FromRaw, Kind};
use super::value::checked_text;
use crate::diag::code;
use crate::limits;
use crate::model::{Address, Expr, OPERATORS, Op, Term};
use crate::raw::RawValue;

/// What waits for what stands right of it.
enum Waiting {
    Open,
    Operator(Op, u8),
}

struct Parser<'a> {
    rest: &'a str,
    terms: Vec<Term>,
    waiting: Vec<Waiting>,
}

fn wrong(message: String) -> Expected {
    Expected {
        code: code::BAD_EXPRESSION,
        message,
        why: "a rule is evaluated: what cannot be read would hold for everything or for nothing".into(),
        help: "write objects as `6041:00`, whole numbers, the operators == != < <= > >= && || + - * % & and parentheses"
            .into(),
    }
}

impl Parser<'_> {
    /// Reads operands and operators in turn.
    fn run(mut self) -> Result<Vec<Term>, Expected> {
        loop {
            self.operand()?;
            while self.token(")") {
                self.close()?;
            }
            if self.rest.is_empty() {
                break;
            }
            self.operator()?;
        }
        while let Some(waiting) = self.waiting.pop() {
            match waiting {
                Waiting::Open => return Err(wrong("a parenthesis is not closed".into())),
                Waiting::Operator(op, _) => self.terms.push(Term::Apply(op)),
            }
        }
        Ok(self.terms)
    }

    fn token(&mut self, token: &str) -> bool {
        let found = self.rest.strip_prefix(token);
        if let Some(rest) = found {
            self.rest = rest.trim_start();
        }
        found.is_some()
    }

    fn operand(&mut self) -> Result<(), Expected> {
        while self.token("(") {
            self.waiting.push(Waiting::Open);
        }
        let end = self.rest.find(|c: char| !c.is_ascii_alphanumeric() && c != ':').unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest.trim_start();
        self.terms.push(operand(word)?);
        Ok(())
    }

    fn close(&mut self) -> Result<(), Expected> {
        loop {
            match self.waiting.pop() {
                Some(Waiting::Operator(op, _)) => self.terms.push(Term::Apply(op)),
                Some(Waiting::Open) => return Ok(()),
                None => return Err(wrong("a parenthesis is closed that was not opened".into())),
            }
        }
    }

    fn operator(&mut self) -> Result<(), Expected> {
        let found = OPERATORS.iter().find(|(op, _)| self.rest.starts_with(op.word()));
        let Some((op, strength)) = found else {
            return Err(wrong(format!("`{}` is no operator", self.rest)));
        };
        self.token(op.word());
        while let Some(Waiting::Operator(waiting, other)) = self.waiting.last()
            && other >= strength
        {
            self.terms.push(Term::Apply(*waiting));
            self.waiting.pop();
        }
        self.waiting.push(Waiting::Operator(*op, *strength));
        Ok(())
    }
}

fn operand(word: &str) -> Result<Term, Expected> {
    if let Some(At { index, sub: Sub::One(sub) }) = At::parse(word).filter(|_| word.contains(':')) {
        return Ok(Term::Object(Address::new(index, sub).into()));
    }
    let number = match word.strip_prefix("0x") {
        Some(hex) if hex.bytes().all(|b| b.is_ascii_hexdigit()) => i64::from_str_radix(hex, 16).ok(),
        _ if word.bytes().all(|b| b.is_ascii_digit()) => word.parse().ok(),
        _ => None,
    };
    number.map(Term::Number).ok_or_else(|| match word {
        "" => wrong("something is missing in the expression".into()),
        _ => wrong(format!("`{word}` is neither an object nor a number")),
    })
}

fn too_deep() -> Expected {
    Expected {
        why: "a drive's processor evaluates it on a small stack".into(),
        help: "nest fewer parentheses, or write several rules".into(),
        ..wrong(format!("more than {DEPTH} values wait for their operators"))
    }
}

impl FromRaw for Expr {
    const KIND: Kind = Kind::Text(None);

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let text = checked_text(raw, limits::TEXT_BYTES)?;
        let parser = Parser { rest: text.trim(), terms: Vec::new(), waiting: Vec::new() };
        let expr = Self { text: text.to_owned(), terms: parser.run()? };
        // What the parser makes is balanced, so that only its depth can stand against it.
        if expr.evaluated().depth().is_none() {
            return Err(too_deep());
        }
        Ok(expr)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> Result<Option<i128>, Expected> {
        let expr = Expr::from_raw(&RawValue::Text(text.into()))?;
        Ok(expr.value(|address| (address.index == 0x6041).then_some(0x1237)))
    }

    #[test]
    fn stronger_operators_first_and_from_the_left() {
        for (text, expected) in [
            ("1 + 2 * 3", 7),
            ("(1 + 2) * 3", 9),
            ("10 - 3 - 2", 5),
            ("6041:00 & 0x6F == 0x27", 1),
            ("1 == 2 || 3 < 4 && 5 >= 5", 1),
            ("125000 % 62500 == 0", 1),
            ("((7))", 7),
        ] {
            assert_eq!(value(text), Ok(Some(expected)), "{text}");
        }
        assert_eq!(value("6040:00 == 0"), Ok(None), "an object without a value");
        assert_eq!(value("1 % 0"), Ok(None));
        assert_eq!(value("9223372036854775807 * 9223372036854775807 * 9223372036854775807"), Ok(None));
    }

    #[test]
    fn what_is_no_expression_is_refused() {
        for text in ["1 +", "(1", "1)", "1 2", "x == 1", "6041:0 == 1", "0x", "1 = 1", "-1", "1 ; 2"] {
            assert_eq!(value(text).map_err(|e| e.code), Err(code::BAD_EXPRESSION), "{text}");
        }
        assert!(value(&"(".repeat(4_000)).is_err(), "no recursion");
    }

    #[test]
    fn what_nests_deeper_than_the_runtime_evaluates_is_refused() {
        let nested = |numbers: usize| format!("{}1{}", "1 + (".repeat(numbers - 1), ")".repeat(numbers - 1));
        assert_eq!(value(&nested(DEPTH)), Ok(Some(16)));
        assert_eq!(value(&nested(DEPTH + 1)).map_err(|e| e.code), Err(code::BAD_EXPRESSION));
        assert_eq!(value(&format!("{}1", "1 + ".repeat(500))), Ok(Some(501)), "long is not deep");
    }
}
