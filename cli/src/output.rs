//! What goes to standard output, and what is said when it cannot.

use std::io::Write;

use crate::End;

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
    eprintln!("error: {error}");
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
