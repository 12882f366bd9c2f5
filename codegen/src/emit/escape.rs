//! One escaping function for each output language. Text of a profile reaches an output through these and no other way.

/// A character that could hide or reorder what a reader sees: controls, bidi marks, zero-width characters, tags.
pub fn is_hidden(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{AD}' | '\u{61C}' | '\u{180E}' | '\u{200B}'..='\u{200F}' | '\u{2028}'..='\u{202E}'
            | '\u{2060}'..='\u{206F}' | '\u{FEFF}' | '\u{FFF9}'..='\u{FFFB}' | '\u{E0000}'..='\u{E0FFF}')
}

/// One line without hidden characters: each run of them becomes a blank.
pub fn one_line(text: &str) -> String {
    text.split(is_hidden).filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" ")
}

/// Text inside one line of plain text, from which the text can be read back: hidden characters as `\u{202e}`.
pub fn plain_line(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' => out.push_str("\\\\"),
            c if is_hidden(c) => out.extend(c.escape_unicode()),
            c => out.push(c),
        }
    }
    out
}

/// Text inside a Rust string literal, without the quotes.
pub fn rust_str(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '"' | '\\' => {
                out.push('\\');
                out.push(c);
            }
            c if is_hidden(c) => out.extend(c.escape_unicode()),
            c => out.push(c),
        }
    }
    out
}

/// Text of a Rust doc comment line: one line that can open no link, code block or HTML tag.
pub fn rust_doc(text: &str) -> String {
    markdown(text)
}

/// Text inside Markdown: one line in which no character has a meaning of its own. Blanks before it would make it code.
pub fn markdown(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in one_line(text).trim().chars() {
        match c {
            // Many pages make links of `http://` and `www.`.
            '/' if out.ends_with(':') => out.push_str("\\/"),
            '.' if out.ends_with("www") => out.push_str("\\."),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            '\\' | '`' | '*' | '_' | '[' | ']' | '|' | '#' | '~' | '$' => {
                out.push('\\');
                out.push(c);
            }
            c => out.push(c),
        }
    }
    out
}

/// A value in an INI file (EDS, DCF): one line of printable ASCII without the signs that some reader takes for a comment,
/// an escape or a quote. What ASCII cannot say becomes `?`.
pub fn ini(text: &str) -> String {
    let ascii: String = one_line(text)
        .replace('#', "No.")
        .chars()
        .map(|c| match c {
            ';' => ',',
            '\\' => '/',
            c if c.is_ascii() => c,
            'µ' | 'μ' => 'u',
            _ => '?',
        })
        .collect();
    ascii.trim_start_matches([' ', '"', '\'']).trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    const HOSTILE: &str = "a\"]})*/ <script>\u{202E}\n[6040]\0#}`";

    #[test]
    fn ini_stays_on_one_line() {
        let out = ini(HOSTILE);
        assert!(!out.contains('\n') && out.is_ascii() && !out.contains('\0'));
        assert_eq!(ini("\"Motor\" #1; C:\\x µm"), "Motor\" No.1, C:/x um");
    }

    #[test]
    fn rust_literals_parse_back() {
        let literal = format!("\"{}\"", rust_str(HOSTILE));
        let parsed: syn::LitStr = syn::parse_str(&literal).unwrap();
        assert_eq!(parsed.value(), HOSTILE);
    }

    #[test]
    fn markdown_has_no_tags() {
        let out = markdown(HOSTILE);
        assert!(!out.contains('<') && !out.contains('\n') && !out.contains('\u{202E}'));
        assert_eq!(markdown("    http://a.b www.c.d "), "http:\\//a.b www\\.c.d");
    }
}
