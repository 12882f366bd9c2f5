//! One escaping function for each output language. Text of a profile reaches an output through these and no other way.

use std::fmt::Write;

/// A character that could hide or reorder what a reader sees: controls, format characters such as bidi marks and tags, and
/// all that fonts draw as nothing. These are the general category Cf and the property `Default_Ignorable_Code_Point` of
/// Unicode, and the two separators of lines and paragraphs.
pub fn is_hidden(c: char) -> bool {
    const HIDDEN: &[(char, char)] = &[
        ('\u{AD}', '\u{AD}'),
        ('\u{34F}', '\u{34F}'),
        ('\u{600}', '\u{605}'),
        ('\u{61C}', '\u{61C}'),
        ('\u{6DD}', '\u{6DD}'),
        ('\u{70F}', '\u{70F}'),
        ('\u{890}', '\u{891}'),
        ('\u{8E2}', '\u{8E2}'),
        ('\u{115F}', '\u{1160}'),
        ('\u{17B4}', '\u{17B5}'),
        ('\u{180B}', '\u{180F}'),
        ('\u{200B}', '\u{200F}'),
        ('\u{2028}', '\u{202E}'),
        ('\u{2060}', '\u{206F}'),
        ('\u{3164}', '\u{3164}'),
        ('\u{FE00}', '\u{FE0F}'),
        ('\u{FEFF}', '\u{FEFF}'),
        ('\u{FFA0}', '\u{FFA0}'),
        ('\u{FFF0}', '\u{FFFB}'),
        ('\u{110BD}', '\u{110BD}'),
        ('\u{110CD}', '\u{110CD}'),
        ('\u{13430}', '\u{1343F}'),
        ('\u{1BCA0}', '\u{1BCA3}'),
        ('\u{1D173}', '\u{1D17A}'),
        ('\u{E0000}', '\u{E0FFF}'),
    ];
    if c.is_ascii() {
        return c.is_ascii_control();
    }
    let next = HIDDEN.partition_point(|(_, last)| *last < c);
    c.is_control() || HIDDEN.get(next).is_some_and(|(first, _)| *first <= c)
}

/// One line without hidden characters: each run of them becomes a blank.
pub fn one_line(text: &str) -> String {
    if is_plain(text) {
        return text.to_owned();
    }
    text.split(is_hidden).filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" ")
}

/// Whether `text` is printable ASCII, as nearly every text is: then no character of it is looked at twice.
fn is_plain(text: &str) -> bool {
    begins_with(text.as_bytes(), &PRINTABLE) == text.len()
}

/// Bytes, as a table.
type Bytes = [bool; 256];

/// Printable ASCII.
const PRINTABLE: Bytes = printable_but(b"");

/// Printable ASCII without `special`.
const fn printable_but(special: &[u8]) -> Bytes {
    let mut all = [false; 256];
    let mut byte = b' ' as usize;
    while byte <= b'~' as usize {
        all[byte] = true;
        byte += 1;
    }
    let mut at = 0;
    while at < special.len() {
        all[special[at] as usize] = false;
        at += 1;
    }
    all
}

/// How many of the first `bytes` are among `some`, which are ASCII. A plain loop, since it is where a compiler that
/// nobody optimized, that of a build script, spends its time.
fn begins_with(bytes: &[u8], some: &Bytes) -> usize {
    let mut at = 0;
    while at < bytes.len() && some[bytes[at] as usize] {
        at += 1;
    }
    at
}

/// `text`, in which `one` writes each character that is not among `plain`; it is told where the character stands.
fn escaped(text: &str, plain: &Bytes, one: impl FnMut(&mut String, usize, char)) -> String {
    let mut out = String::with_capacity(text.len());
    escape_into(&mut out, text, plain, one);
    out
}

/// Adds to `out` what [`escaped`] gives.
fn escape_into(out: &mut String, text: &str, plain: &Bytes, mut one: impl FnMut(&mut String, usize, char)) {
    let mut at = 0;
    loop {
        let same = begins_with(&text.as_bytes()[at..], plain);
        out.push_str(&text[at..at + same]);
        at += same;
        let Some(c) = text[at..].chars().next() else { return };
        one(out, at, c);
        at += c.len_utf8();
    }
}

/// Text inside one line of plain text, from which the text can be read back: hidden characters as `\u{202e}`.
pub fn plain_line(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    push_plain_line(&mut out, text);
    out
}

/// Adds to `out` what [`plain_line`] gives.
pub fn push_plain_line(out: &mut String, text: &str) {
    const PLAIN: Bytes = printable_but(b"\\");
    escape_into(out, text, &PLAIN, |out, _, c| match c {
        '\\' => out.push_str("\\\\"),
        c if is_hidden(c) => out.extend(c.escape_unicode()),
        c => out.push(c),
    });
}

/// Text for a person to read, of one line or several: hidden characters but line feeds as `\u{202e}`. Not to be read back.
pub fn visible(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if is_hidden(c) && c != '\n' { out.extend(c.escape_unicode()) } else { out.push(c) }
    }
    out
}

/// A JSON text in which strings hold hidden characters: the same with those as escapes.
pub fn json(text: &str) -> String {
    escaped(text, &PRINTABLE, |out, _, c| json_char(out, c))
}

/// Adds `text` inside a JSON string, without the quotes.
pub fn json_str(out: &mut String, text: &str) {
    const PLAIN: Bytes = printable_but(b"\"\\");
    escape_into(out, text, &PLAIN, |out, _, c| match c {
        '"' | '\\' => out.extend(['\\', c]),
        '\n' => out.push_str("\\n"),
        '\r' => out.push_str("\\r"),
        '\t' => out.push_str("\\t"),
        '\u{8}' => out.push_str("\\b"),
        '\u{C}' => out.push_str("\\f"),
        c => json_char(out, c),
    });
}

/// A character inside a JSON string that needs no quoting; a hidden one becomes an escape.
fn json_char(out: &mut String, c: char) {
    if !is_hidden(c) {
        return out.push(c);
    }
    for unit in c.encode_utf16(&mut [0; 2]) {
        // Writing to a String cannot fail.
        let _ = write!(out, "\\u{unit:04x}");
    }
}

/// Text inside a Rust string literal, without the quotes.
pub fn rust_str(text: &str) -> String {
    const PLAIN: Bytes = printable_but(b"\"\\");
    escaped(text, &PLAIN, |out, _, c| match c {
        '"' | '\\' => out.extend(['\\', c]),
        c if is_hidden(c) => out.extend(c.escape_unicode()),
        c => out.push(c),
    })
}

/// Text of a Rust doc comment line: one line that can open no link, block, code block or HTML tag. What it says is never
/// compiled or run.
pub fn rust_doc(text: &str) -> String {
    markdown(text)
}

/// Text inside Markdown: one line in which no character has a meaning of its own. It may stand at the start of a line, as
/// long as no full stop follows that is not part of it.
pub fn markdown(text: &str) -> String {
    let line = one_line(text);
    // Four blanks at the start of a line would make it code, which `cargo test` compiles and runs.
    let line = line.trim();
    let marker = block_marker(line);
    let one = |out: &mut String, at: usize, c| match c {
        '<' => out.push_str("&lt;"),
        '>' => out.push_str("&gt;"),
        '&' => out.push_str("&amp;"),
        '\\' | '`' | '*' | '_' | '[' | ']' | '|' | '#' | '~' | '$' => out.extend(['\\', c]),
        c if marker == Some(at) || makes_link(&line[..at], &line[at..]) => out.extend(['\\', c]),
        c => out.push(c),
    };
    escaped(line, &MARKDOWN, one)
}

/// What may stand in Markdown as it is. The last row has what begins a block or a link, which depends on where it stands.
const MARKDOWN: Bytes = printable_but(
    b"<>&\\`*_[]|#~$\
    -+=:.)",
);

/// A text as the anchor of a page: its ASCII letters and digits in lower case, with one `-` for what is between them. It may
/// be empty, and two texts may have the same.
pub fn anchor(text: &str) -> String {
    let words: Vec<&str> =
        text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty()).collect();
    words.join("-").to_ascii_lowercase()
}

/// Where the sign stands that makes `line` more than a paragraph: a list, a rule, a table, or a heading of the line above.
fn block_marker(line: &str) -> Option<usize> {
    if let Some(rest) = line.strip_prefix(['-', '+', '=', ':']) {
        return (!rest.starts_with(|c: char| c.is_ascii_alphanumeric())).then_some(0);
    }
    let digits = line.bytes().take_while(u8::is_ascii_digit).count();
    let rest = line[digits..].strip_prefix(['.', ')'])?;
    (digits > 0 && (rest.is_empty() || rest.starts_with(char::is_whitespace))).then_some(digits)
}

/// Whether the sign between `before` and `rest` makes a link of plain text: the colon of `https://x.org`, the first dot of
/// `www.x.org`.
fn makes_link(before: &str, rest: &str) -> bool {
    rest.starts_with("://")
        || rest.starts_with('.')
            && before.get(before.len().saturating_sub(3)..).is_some_and(|w| w.eq_ignore_ascii_case("www"))
}

/// Text in an XML element or between the double quotes of an attribute, from which every reader reads the same text: hidden
/// characters and line breaks as numbers. Those that XML cannot hold at all become U+FFFD.
pub fn xml(text: &str) -> String {
    const PLAIN: Bytes = printable_but(b"&<>\"");
    escaped(text, &PLAIN, |out, _, c| match c {
        '&' => out.push_str("&amp;"),
        '<' => out.push_str("&lt;"),
        '>' => out.push_str("&gt;"),
        '"' => out.push_str("&quot;"),
        c if !is_xml(c) => out.push('\u{FFFD}'),
        c if is_hidden(c) => drop(write!(out, "&#x{:X};", u32::from(c))),
        c => out.push(c),
    })
}

/// Whether XML 1.0 can hold a character.
pub fn is_xml(c: char) -> bool {
    matches!(c, '\t' | '\n' | '\r' | ' '..='\u{D7FF}' | '\u{E000}'..='\u{FFFD}' | '\u{10000}'..)
}

/// Text in a basic string of TOML, without the quotes, from which the text can be read back.
pub fn toml_str(text: &str) -> String {
    const PLAIN: Bytes = printable_but(b"\"\\");
    escaped(text, &PLAIN, |out, _, c| match c {
        '"' | '\\' => out.extend(['\\', c]),
        '\n' => out.push_str("\\n"),
        '\t' => out.push_str("\\t"),
        c if is_hidden(c) => {
            let n = u32::from(c);
            let _ = if n > 0xFFFF { write!(out, "\\U{n:08X}") } else { write!(out, "\\u{n:04X}") };
        }
        c => out.push(c),
    })
}

/// A value in an INI file (EDS, DCF): one line of printable ASCII without the signs that some reader takes for a comment,
/// an escape or a quote. What ASCII cannot say becomes `?`.
pub fn ini(text: &str) -> String {
    const PLAIN: Bytes = printable_but(b"#;\\");
    let ascii = sii(text);
    let plain = begins_with(ascii.as_bytes(), &PLAIN) == ascii.len();
    let ascii = if plain { ascii } else { ascii.replace('#', "No.").replace(';', ",").replace('\\', "/") };
    ascii.trim_start_matches([' ', '"', '\'']).trim_end().to_owned()
}

/// A string of an SII: one line of printable ASCII, in which no sign has a meaning. What ASCII cannot say becomes `?`.
pub fn sii(text: &str) -> String {
    let ascii = |c| match c {
        'µ' | 'μ' => 'u',
        c if char::is_ascii(&c) => c,
        _ => '?',
    };
    let line = one_line(text);
    if line.is_ascii() { line } else { line.chars().map(ascii).collect() }
}

/// Text inside an XML comment: one line without the two dashes that would end it. Nothing else has a meaning there.
pub fn xml_comment(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in one_line(text).chars() {
        if c == '-' && out.ends_with('-') {
            out.push(' ');
        }
        out.push(if is_xml(c) { c } else { char::REPLACEMENT_CHARACTER });
    }
    if out.ends_with('-') {
        out.push(' ');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    const HOSTILE: &str = "a\"]})*/ <script>\u{202E}\n[6040]\0#}`";

    #[test]
    fn json_escapes_what_nobody_sees() {
        // Beyond the basic plane an escape is two.
        let text = "\"a\u{202E}b\u{110BD}\"";
        assert_eq!(json(text), r#""a\u202eb\ud804\udcbd""#);
        assert_eq!(serde_json::from_str::<String>(&json(text)).unwrap(), "a\u{202E}b\u{110BD}");
        assert_eq!(visible("a\u{202E}\nb\\"), "a\\u{202e}\nb\\");
    }

    #[test]
    fn ini_stays_on_one_line() {
        let out = ini(HOSTILE);
        assert!(!out.contains('\n') && out.is_ascii() && !out.contains('\0'));
        assert_eq!(ini("\"Motor\" #1; C:\\x µm"), "Motor\" No.1, C:/x um");
    }

    #[test]
    fn strings_of_an_sii_are_printable_ascii() {
        assert!(sii(HOSTILE).bytes().all(|b| (0x20..0x7F).contains(&b)), "{}", sii(HOSTILE));
        // Text that ends with zero bytes is a defect that masters know.
        assert_eq!(sii("X1 #2; 3 µm é\0\0"), "X1 #2; 3 um ?");
    }

    #[test]
    fn xml_holds_no_markup() {
        assert_eq!(xml("a < b & \"c\"\u{FFFF}"), "a &lt; b &amp; &quot;c&quot;\u{FFFD}");
        let out = xml(HOSTILE);
        assert!(!out.contains(['<', '>', '"', '\n', '\0', '\u{202E}']), "{out}");
        for text in ["a--b", "--->", "-", "- -", HOSTILE] {
            let out = format!("<!--{}-->", xml_comment(text));
            assert_eq!(out.matches("--").count(), 2, "{out}");
            assert!(out.ends_with("-->") && !out.ends_with("--->"), "{out}");
        }
    }

    #[test]
    fn rust_literals_parse_back() {
        let literal = format!("\"{}\"", rust_str(HOSTILE));
        let parsed: syn::LitStr = syn::parse_str(&literal).unwrap();
        assert_eq!(parsed.value(), HOSTILE);
    }

    #[test]
    fn xml_is_read_as_the_same_text() {
        let out = xml(HOSTILE);
        assert!(!out.contains(['<', '>', '"', '\n', '\0', '\u{202E}']), "{out}");
        assert_eq!(xml("a<b & \"c\"\n\u{1}µ"), "a&lt;b &amp; &quot;c&quot;&#xA;\u{FFFD}µ");
        assert_eq!(quick_xml_reads(&out), HOSTILE.replace('\0', "\u{FFFD}"));
    }

    fn quick_xml_reads(text: &str) -> String {
        quick_xml::escape::unescape(text).unwrap().into_owned()
    }

    #[test]
    fn toml_strings_parse_back() {
        let text = format!("{HOSTILE}\u{7F}\u{E0041}\r\t\\");
        let table: toml::Table = toml::from_str(&format!("a = \"{}\"", toml_str(&text))).unwrap();
        assert_eq!(table["a"].as_str(), Some(text.as_str()));
        assert_eq!(toml_str("\u{202E}\u{E0041}"), "\\u202E\\U000E0041");
    }

    #[test]
    fn markdown_has_no_tags() {
        let out = markdown(HOSTILE);
        assert!(!out.contains('<') && !out.contains('\n') && !out.contains('\u{202E}'));
    }

    #[test]
    fn markdown_opens_no_block() {
        assert_eq!(markdown("    panic!()   "), "panic!()");
        for (text, escaped) in [
            ("---", "\\---"),
            ("- item", "\\- item"),
            ("+ item", "\\+ item"),
            ("===", "\\==="),
            (" = ", "\\="),
            (":-: cell", "\\:-: cell"),
            ("1. item", "1\\. item"),
            ("12) item", "12\\) item"),
            ("2.", "2\\."),
            ("1.5 rpm", "1.5 rpm"),
            ("-5 to +5", "-5 to +5"),
            ("a - b = 1. c", "a - b = 1. c"),
        ] {
            assert_eq!(markdown(text), escaped);
        }
    }

    #[test]
    fn anchors_have_letters_digits_and_dashes() {
        assert_eq!(anchor("Mode of operation (6060h)"), "mode-of-operation-6060h");
        assert_eq!(anchor(HOSTILE), "a-script-6040");
        assert_eq!(anchor("\"> 伺服"), "");
    }

    #[test]
    fn markdown_makes_no_link() {
        assert_eq!(markdown("see https://x.org/a_b"), "see https\\://x.org/a\\_b");
        assert_eq!(markdown("at WWW.x.org, Wwx."), "at WWW\\.x.org, Wwx.");
        assert_eq!(markdown("C: 1:2"), "C: 1:2");
    }
}
