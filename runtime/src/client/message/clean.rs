//! Text of a drive or of a profile on a terminal.

use core::fmt::{self, Write};

/// Bytes as text that can do nothing to a terminal or a log: control characters and what is no UTF-8 show as `\xNN`; text
/// ends at the first NUL, which drives pad with.
///
/// ```
/// use drivewright_runtime::client::message::Clean;
///
/// assert_eq!(Clean(b"ELD2\0\0").to_string(), "ELD2");
/// assert_eq!(Clean(b"\x1B[31mK\xFC\xC2\xB5").to_string(), r"\x1b[31mK\xfcµ");
/// ```
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Clean<'a>(pub &'a [u8]);

impl fmt::Display for Clean<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = self.0.split(|b| *b == 0).next().unwrap_or(self.0);
        for chunk in text.utf8_chunks() {
            chunk.valid().chars().try_for_each(|c| show(f, c))?;
            write!(f, "{}", chunk.invalid().escape_ascii())?;
        }
        Ok(())
    }
}

impl fmt::Debug for Clean<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{self}\"")
    }
}

/// Direction marks can make a line read as what it is not, so they are shown as controls are.
fn show(f: &mut fmt::Formatter<'_>, c: char) -> fmt::Result {
    match c {
        '\u{80}'..='\u{9F}' | '\u{200E}'..='\u{200F}' | '\u{2028}'..='\u{202E}' | '\u{2066}'..='\u{2069}' => {
            write!(f, "{}", c.escape_unicode())
        }
        c if c.is_ascii_control() => write!(f, "{}", (c as u8).escape_ascii()),
        c => f.write_char(c),
    }
}
