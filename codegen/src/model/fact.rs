//! A value together with who says so.

use std::fmt;

use super::ErratumId;
use crate::source::Span;

/// How a value is known.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Class {
    /// The manual says it; the origin cites where.
    Stated,
    /// It follows from the manual by a named rule.
    Inferred(String),
    /// The named base profile says it.
    Standard(String),
    /// A format demands a value that the manual never prints; the text says why this one.
    Assumed(String),
}

impl Class {
    /// `stated`, `inferred`, `standard` or `assumed`.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Stated => "stated",
            Self::Inferred(_) => "inferred",
            Self::Standard(_) => "standard",
            Self::Assumed(_) => "assumed",
        }
    }

    /// The rule, base or reason that comes with it.
    pub fn detail(&self) -> Option<&str> {
        match self {
            Self::Stated => None,
            Self::Inferred(s) | Self::Standard(s) | Self::Assumed(s) => Some(s),
        }
    }
}

impl fmt::Display for Class {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())?;
        self.detail().map_or(Ok(()), |d| write!(f, " ({d})"))
    }
}

/// One place in a manual.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Place {
    /// Id of the manual, where the profile has more than one.
    pub manual: Option<String>,
    /// Section as printed.
    pub section: Option<String>,
    /// Table as printed, without the word: `6-2`.
    pub table: Option<String>,
    /// Lines of the text extract, from 1.
    pub lines: Vec<u32>,
}

/// A citation: one or more places.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Cite {
    /// The places, in the order written.
    pub places: Vec<Place>,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut first = true;
        let mut part = |sign: &str, text: &dyn fmt::Display| {
            let blank = if std::mem::take(&mut first) { "" } else { " " };
            write!(f, "{blank}{sign}{text}")
        };
        self.manual.iter().try_for_each(|m| part("", m))?;
        self.section.iter().try_for_each(|s| part("", s))?;
        self.table.iter().try_for_each(|t| part("T", t))?;
        self.lines.iter().try_for_each(|l| part("L", l))
    }
}

impl fmt::Display for Cite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.places.iter().enumerate().try_for_each(|(n, place)| {
            let comma = if n == 0 { "" } else { ", " };
            write!(f, "{comma}{place}")
        })
    }
}

/// Who says a value.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Origin {
    /// How it is known.
    pub class: Class,
    /// Where the profile says it.
    pub span: Span,
    /// Where the manual says it; `Some` for every stated value of a model without errors.
    pub cite: Option<Cite>,
    /// The erratum that set it or that explains it.
    pub erratum: Option<ErratumId>,
}

impl Origin {
    /// Who says it, for a message: the citation, or `standard: cia402`; `None` where neither is known.
    pub fn source(&self) -> Option<String> {
        let cite = self.cite.as_ref().map(ToString::to_string);
        cite.or_else(|| Some(format!("{}: {}", self.class.word(), self.class.detail()?)))
    }
}

/// A value and who says so. Equality looks at the value only.
#[derive(Clone, Debug)]
pub struct Fact<T> {
    /// The value.
    pub value: T,
    /// Who says so.
    pub origin: Origin,
}

impl<T> Fact<T> {
    /// Joins a value with its origin.
    pub fn new(value: T, origin: Origin) -> Self {
        Self { value, origin }
    }

    /// Keeps the origin and changes the value.
    pub fn map<U>(self, f: impl FnOnce(T) -> U) -> Fact<U> {
        Fact { value: f(self.value), origin: self.origin }
    }

    /// Where the profile says it.
    pub fn span(&self) -> Span {
        self.origin.span
    }
}

impl<T: PartialEq> PartialEq for Fact<T> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}
