//! What goes to standard output and to standard error, and what is said when it cannot.

use std::fmt::Arguments;
use std::io::{IsTerminal, Write};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

use crate::End;

/// How much is said, and to whom.
#[derive(Clone, Copy)]
pub(crate) struct Shape {
    /// Only what is wrong.
    pub(crate) quiet: bool,
    /// For programs.
    pub(crate) json: bool,
}

/// Says something on standard error, in the words of `format!`.
macro_rules! tell {
    ($($text:tt)*) => { $crate::output::tell_text(format_args!($($text)*)) };
}
pub(crate) use tell;

/// What `tell!` does. Where nobody can hear it, the exit code still says how it ended: that is no reason to panic, which
/// `eprintln!` would do.
pub(crate) fn tell_text(text: Arguments<'_>) {
    let mut line = text.to_string();
    line.push('\n');
    tell_all(&line);
}

/// Writes `text` to standard error as it is.
pub(crate) fn tell_all(text: &str) {
    let _ = std::io::stderr().write_all(text.as_bytes());
}

/// Whether standard error is a terminal that shows colour, and the user wants it.
pub(crate) fn colour() -> bool {
    let refused = std::env::var_os("NO_COLOR").is_some_and(|v| !v.is_empty());
    std::io::stderr().is_terminal() && !refused
}

/// Shows that work goes on, until what it gives is dropped. On a terminal only, and not where `quiet` is asked for.
pub(crate) fn working(on: &str, quiet: bool) -> Working {
    if quiet || !std::io::stderr().is_terminal() {
        return Working(ProgressBar::hidden());
    }
    let bar = ProgressBar::new_spinner();
    // The template is a literal that the library takes.
    if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} ({elapsed})") {
        bar.set_style(style);
    }
    bar.set_message(on.to_owned());
    bar.enable_steady_tick(Duration::from_millis(120));
    Working(bar)
}

/// Work that goes on. Its line is gone when it ends.
pub(crate) struct Working(ProgressBar);

impl Drop for Working {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

/// Prints `text`. A reader that has seen enough (`drivewright lints | head`) is no error.
pub(crate) fn print(text: &str) -> End {
    let mut out = std::io::stdout();
    // What stays in the buffer would be lost in silence.
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => disk(&error),
        _ => End::Fine,
    }
}

/// Says that the disk refused.
pub(crate) fn disk(error: &dyn std::fmt::Display) -> End {
    tell!("error: {error}");
    End::Disk
}

/// A number of things, with the plural where it is one.
pub(crate) fn counted(n: usize, one: &str) -> String {
    several(n, one, &format!("{one}s"))
}

/// A number of things whose plural is a word of its own.
pub(crate) fn several(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}
