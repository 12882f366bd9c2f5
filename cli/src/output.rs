//! What goes to standard output, and what is said when it cannot.

use std::io::Write;

use crate::End;

/// Prints `text`. A reader that has seen enough (`drivewright lints | head`) is no error.
pub(crate) fn print(text: &str) -> End {
    match std::io::stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => disk(&error),
        _ => End::Fine,
    }
}

/// Says that the disk refused.
pub(crate) fn disk(error: &dyn std::fmt::Display) -> End {
    eprintln!("error: {error}");
    End::Disk
}

/// A number of things, with the plural where it is one.
pub(crate) fn counted(n: usize, one: &str) -> String {
    if n == 1 { format!("1 {one}") } else { format!("{n} {one}s") }
}
