//! How errors and faults of a client print: what, why, what to do, and where it is written; decoded first, raw in brackets.
//!
//! An error implements [`Explain`]; a [`Report`] puts the parts below one another. A part that writes nothing has no line.
//! With `{:#}` a report is one line: what happened and what to do about it.
//!
//! ```
//! use core::fmt;
//! use drivewright_runtime::client::message::{Explain, Lines, Report};
//! use drivewright_runtime::{Address, AbortCode};
//!
//! struct Refused(Address, AbortCode);
//!
//! impl Explain for Refused {
//!     fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
//!         f.write_str("SDO")
//!     }
//!     fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
//!         write!(f, "write {} refused [{}]", self.0, self.1)
//!     }
//!     fn details(&self, lines: &mut Lines<'_, '_>) -> fmt::Result {
//!         lines.line("step", "4 of 9")
//!     }
//!     fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
//!         f.write_str("write 0 to sub-index 0 first")
//!     }
//! }
//!
//! let error = Refused(Address::new(0x1C12, 1), AbortCode::SUB_INDEX_0_NOT_ZERO);
//! let report = Report::new(&error).from("manual 3.4");
//! assert_eq!(report.to_string(), "\
//! error[SDO]: write 1C12:01 refused [0601 0003: sub-index 0 must be 0 before entries are written]
//!   step   : 4 of 9
//!   do     : write 0 to sub-index 0 first
//!   source : manual 3.4");
//! assert_eq!(format!("{report:#}"), "error[SDO]: write 1C12:01 refused \
//!     [0601 0003: sub-index 0 must be 0 before entries are written]; do: write 0 to sub-index 0 first");
//! ```

mod clean;

use core::fmt::{self, Write};

pub use clean::Clean;

crate::word::words! {
    /// How serious a report is.
    Severity {
        /// What was asked for did not happen.
        Error = "error",
        /// It happened, and the user should know something about it.
        Warning = "warning",
        /// Nothing is wrong.
        Note = "note",
        /// The drive is in fault.
        Fault = "FAULT",
    }
}

/// The parts of a message. Each is plain text without a full stop at its end; one that is not known writes nothing.
pub trait Explain {
    /// How serious it is.
    fn severity(&self) -> Severity {
        Severity::Error
    }

    /// What kind of message this is, in brackets after the severity: `SDO`, `LAYOUT`.
    fn code(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result;

    /// What happened, in one sentence: decoded first, raw values in brackets.
    fn what(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result;

    /// Facts, each with a label: what was expected, what was found.
    fn details(&self, lines: &mut Lines<'_, '_>) -> fmt::Result {
        let _ = lines;
        Ok(())
    }

    /// Why it happened.
    fn why(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let _ = f;
        Ok(())
    }

    /// What to do about it.
    fn remedy(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let _ = f;
        Ok(())
    }

    /// Where it is written: profile, manual, page.
    fn source(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let _ = f;
        Ok(())
    }
}

/// A message as text: several lines with `{}`, one with `{:#}`. No line ends in a line break.
pub struct Report<'e, E: ?Sized> {
    explain: &'e E,
    source: Option<&'e str>,
}

impl<'e, E: Explain + ?Sized> Report<'e, E> {
    /// The report of an error.
    pub const fn new(explain: &'e E) -> Self {
        Self { explain, source: None }
    }

    /// With where the facts are written, where the caller knows it better than the error.
    #[must_use]
    pub const fn from(self, source: &'e str) -> Self {
        Self { source: Some(source), ..self }
    }

    fn head(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{}[{}]: {}",
            self.explain.severity(),
            Part(self.explain, E::code),
            Part(self.explain, E::what)
        )
    }

    fn long(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut lines = Lines { f };
        self.explain.details(&mut lines)?;
        lines.line("why", Part(self.explain, E::why))?;
        lines.line("do", Part(self.explain, E::remedy))?;
        match self.source {
            Some(source) => lines.line("source", source),
            None => lines.line("source", Part(self.explain, E::source)),
        }
    }
}

impl<E: Explain + ?Sized> fmt::Display for Report<'_, E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.head(f)?;
        if f.alternate() {
            let mut remedy = Late { to: f, before: Before::Separator, begun: false };
            return write!(remedy, "{}", Part(self.explain, E::remedy));
        }
        self.long(f)
    }
}

/// The labelled lines of a report.
pub struct Lines<'f, 'b> {
    f: &'f mut fmt::Formatter<'b>,
}

impl Lines<'_, '_> {
    /// A line `label : text`. Line breaks of the text continue below its start; an empty text has no line.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn line(&mut self, label: &str, text: impl fmt::Display) -> fmt::Result {
        write!(Late { to: self.f, before: Before::Label(label), begun: false }, "{text}")
    }
}

/// One method of an [`Explain`] as something to display.
struct Part<'e, E: ?Sized>(&'e E, fn(&E, &mut fmt::Formatter<'_>) -> fmt::Result);

impl<E: ?Sized> fmt::Display for Part<'_, E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.1(self.0, f)
    }
}

/// What goes before a text that may turn out to be empty.
enum Before<'l> {
    Label(&'l str),
    Separator,
}

/// Writes what goes before a text once the text has a first character, and keeps its further lines in place.
struct Late<'w, 'b, 'l> {
    to: &'w mut fmt::Formatter<'b>,
    before: Before<'l>,
    begun: bool,
}

impl Write for Late<'_, '_, '_> {
    // By characters: a search in a text has panics that the optimizer cannot rule out.
    fn write_str(&mut self, text: &str) -> fmt::Result {
        text.chars().try_for_each(|character| self.write_char(character))
    }

    fn write_char(&mut self, character: char) -> fmt::Result {
        self.begin()?;
        match character {
            '\n' => self.next_line(),
            other => self.to.write_char(other),
        }
    }
}

impl Late<'_, '_, '_> {
    fn begin(&mut self) -> fmt::Result {
        if self.begun {
            return Ok(());
        }
        self.begun = true;
        match self.before {
            Before::Label(label) => write!(self.to, "\n  {label:<7}: "),
            Before::Separator => self.to.write_str("; do: "),
        }
    }

    fn next_line(&mut self) -> fmt::Result {
        match self.before {
            Before::Label(_) => write!(self.to, "\n{:11}", ""),
            Before::Separator => self.to.write_str(" "),
        }
    }
}

/// Writes items one after the other, with this between them.
pub(crate) fn list<T: fmt::Display>(
    f: &mut fmt::Formatter<'_>,
    between: &str,
    items: impl Iterator<Item = T>,
) -> fmt::Result {
    let mut gap = "";
    for item in items {
        write!(f, "{gap}{item}")?;
        gap = between;
    }
    Ok(())
}

/// `Display` and `Error` of an error that explains itself: the report. Its lifetimes come first, in brackets.
macro_rules! displays {
    ($([$($life:lifetime),*] $name:ty;)*) => {$(
        impl<$($life),*> core::fmt::Display for $name {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                core::fmt::Display::fmt(&$crate::client::message::Report::new(self), f)
            }
        }

        impl<$($life),*> core::error::Error for $name {}
    )*};
}

pub(crate) use displays;

#[cfg(test)]
mod tests;
